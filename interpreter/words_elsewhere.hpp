// Names that operations have in other shape grammars, and what is written for them here.
#pragma once

#include <string_view>

namespace mansard {

/// `insert("mesh.obj")` for i; empty when the name is none of these.
std::string_view operation_elsewhere(std::string_view name);

}  // namespace mansard
