// What has been said once a run need not be said again.
#pragma once

#include <set>
#include <span>
#include <tuple>

#include "cli/session.hpp"

namespace mansard {

/// Prints a diagnostic of one place only the first time it comes, or each that is news.
class Said {
 public:
  void print(const Session& session, std::span<const Diagnostic> diagnostics);

 private:
  std::set<std::tuple<std::string, const Source*, uint32_t, std::string>> said_;
};

}  // namespace mansard
