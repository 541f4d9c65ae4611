// How long something is by itself.
#pragma once

#include <limits>

namespace mansard {

/// Metres along an axis, 0 <= minimum <= preferred <= maximum.
struct NaturalSize {
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  double minimum = 0, preferred = 0, maximum = unbounded;

  static NaturalSize exactly(double metres) { return {metres, metres, metres}; }
  /// Whether anything says how long it is. What does not, a wall, is as long as it is made.
  bool is_known() const { return preferred > 0 || maximum < unbounded; }
};

/// One after the other.
NaturalSize operator+(const NaturalSize& a, const NaturalSize& b);
/// Beside each other, as long as the longer one.
NaturalSize longest(const NaturalSize& a, const NaturalSize& b);

}  // namespace mansard
