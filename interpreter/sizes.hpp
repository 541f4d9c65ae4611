// The sizes of a split.
#pragma once

#include <span>
#include <vector>

#include "grammar/syntax.hpp"

namespace mansard {

struct SizeValue {
  syntax::SizeKind kind = syntax::SizeKind::absolute;
  double value = 0;  ///< metres, percent, shares, or the metres a float wants
};

/// Lengths along `whole` metres, one a size, appended to `out` (Müller et al. 2006 §3.2): shares
/// get r (L - sum of the others) / sum of shares; floats stretch together to fill, or keep what
/// they want where there are shares, and shrink in proportion where there is too little room.
/// Returns what is left over (negative: what the fixed sizes overrun).
double solve_sizes(std::span<const SizeValue> sizes, double whole, std::vector<double>& out);

}  // namespace mansard
