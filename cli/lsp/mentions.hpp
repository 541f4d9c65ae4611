// All uses of a name in all scripts of the workspace.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "cli/lsp/project.hpp"

namespace mansard::lsp {

struct Mention {
  Range range;
  std::string text;
  bool declares = false;
};

/// By identity of the file and where it begins there.
using Mentions = std::map<std::pair<std::string, uint32_t>, Mention>;

/// Of what the word at the cursor means, the word itself among them. Empty for words of the
/// language.
Mentions mentions_of(Project& project, const Cursor& cursor);

/// Can it be declared in a script at all?
bool is_declared_kind(Kind kind);

}  // namespace mansard::lsp
