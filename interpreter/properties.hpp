// Properties of footprints that were meant to give variables a value and do not.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "grammar/diagnostic.hpp"
#include "interpreter/program.hpp"

namespace mansard {

/// W021, once for each name (which come once): `Block.Name` of a block that has no such variable or
/// of nearly a block's name, and a bare name in mixed case that is nearly a variable of the style,
/// or one of a block, and one that differs only in case from one that is read. Whatever else the
/// data holds is its own affair.
std::vector<Diagnostic> misnamed_properties(const Program& program,
                                            std::span<const std::string> names);

}  // namespace mansard
