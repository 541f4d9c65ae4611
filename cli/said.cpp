#include "cli/said.hpp"

#include "grammar/codes.hpp"

namespace mansard {

void Said::print(const Session& session, std::span<const Diagnostic> diagnostics) {
  for (const Diagnostic& d : diagnostics) {
    const std::string text = d.code.empty() || each_text_is_news(d.code) ? d.text : "";
    if (said_.emplace(std::string(d.code), d.at.source, d.at.begin, text).second) session.print(d);
  }
}

}  // namespace mansard
