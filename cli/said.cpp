#include "cli/said.hpp"

namespace mansard {

void Said::print(const Session& session, std::span<const Diagnostic> diagnostics) {
  for (const Diagnostic& d : diagnostics) {
    // Each property that can not be read is news.
    const std::string text = d.code.empty() || d.code == "W012" ? d.text : "";
    if (said_.emplace(std::string(d.code), d.at.source, d.at.begin, text).second) session.print(d);
  }
}

}  // namespace mansard
