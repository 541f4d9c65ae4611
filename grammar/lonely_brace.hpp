// Which '{' lacks its '}'.
#pragma once

#include <string_view>

namespace mansard {

/// Of the braces that are open between `begin`, which is one, and `end`: the one whose '}' is
/// missing, told by how lines are indented; `begin` when they do not tell.
std::size_t lonely_brace(std::string_view text, std::size_t begin, std::size_t end);

}  // namespace mansard
