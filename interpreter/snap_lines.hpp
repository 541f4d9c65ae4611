// Splits that snap: which lines across a shape count, and which boundaries go to them (Müller et
// al. 2006 §3.3).
#pragma once

#include <cstdint>
#include <span>

namespace mansard {

/// Lines nearer together than this, in metres, count as one whatever the tolerance.
inline constexpr double same_line = 0.001;
/// Metres, where a split does not say `tolerance`.
inline constexpr double usual_tolerance = 0.3;

/// A line across a shape, at a distance along the axis of its split.
struct SnapLine {
  double at = 0;
  uint32_t by = 0;    ///< node that recorded its plane, or whose face that is
  bool face = false;  ///< of a mass
  bool used = false;  ///< the split has a boundary there
};

/// Marks the lines that divide `whole` metres into intervals: all but those that lie nearer than
/// `tolerance` to an end or to the line that was marked before. `lines` ascend.
void keep_apart(std::span<SnapLine> lines, double whole, double tolerance);

/// Moves the boundaries between parts of these lengths: each to the nearest of the lines that are
/// nearer to it than to any other boundary or end, and not farther than `tolerance`; marks those
/// lines. Parts of no length move along, parts beyond `whole` stay, and boundaries keep their
/// order: none leaves the half ways to its neighbours. `lines` ascend.
void pull(std::span<double> lengths, double whole, std::span<SnapLine> lines, double tolerance);

}  // namespace mansard
