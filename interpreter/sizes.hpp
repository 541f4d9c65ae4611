// The sizes of a split.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "grammar/syntax.hpp"

namespace mansard {

struct SizeValue {
  syntax::SizeKind kind = syntax::SizeKind::absolute;
  double value = 0;  ///< metres, percent, shares, the metres a float wants or ':' prefers
  /// Of ':' only: the metres between which it gives way, minimum <= value <= maximum.
  double minimum = 0, maximum = std::numeric_limits<double>::infinity();
};

/// Lengths along `whole` metres, one a size, appended to `out` (Müller et al. 2006 §3.2): shares
/// get r (L - sum of the others) / sum of shares; floats stretch together to fill, or keep what
/// they want where there are shares, and shrink in proportion where there is too little room. A
/// ':' gets what it prefers; where the fixed sizes leave less all of them shrink in proportion,
/// down to their minima, and where nothing else takes what is left they stretch in proportion, up
/// to their maxima.
/// Returns what is left over (negative: what the fixed sizes and the minima overrun).
double solve_sizes(std::span<const SizeValue> sizes, double whole, std::vector<double>& out);

}  // namespace mansard
