// Problems, as they are while one types.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include "cli/lsp/project.hpp"

namespace mansard::lsp {

/// A diagnostic of the protocol: range, severity, code, text with its help, notes that have a place
/// as related information.
Json json(Project& project, View& view, const Diagnostic& diagnostic);

/// Checks one of the open scripts that have changed; false when there is none any more. One at a
/// time, so that requests need not wait for all.
bool check_next(Project& project);

/// The diagnostics of all open scripts and of what they import, and what was said of them last.
class Publisher {
 public:
  /// Checks what has changed. Calls `send` with the parameters of `publishDiagnostics` for each
  /// file whose problems are others than before; mended files get an empty list.
  void publish(Project& project, const std::function<void(const Json&)>& send);

 private:
  std::map<std::string, std::string> said_;  ///< by URI
};

}  // namespace mansard::lsp
