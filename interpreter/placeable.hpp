// Which symbols come out the same wherever they stand.
#pragma once

#include <cstdint>
#include <vector>

namespace mansard {

struct Program;

/// For each style of the program, by symbol: whether what is derived from a rectangle or a box of
/// the symbol depends on its size, its directions and what it inherits, but not on its place. Such
/// a symbol reads no position, asks about no other shape and reports nothing, nor does any that it
/// leads to; and it does not lead to itself. Only symbols whose rules divide them count, and that
/// come several times or below what is not the same each time: knowing them saves something. What
/// depends on chance may be placeable: that shows when it is derived.
std::vector<std::vector<bool>> placeable_symbols(const Program& program);

}  // namespace mansard
