// Stains on walls, below what rain runs off: pieces cut out along the walls' faces, with a stain of
// the atlas on each.
#pragma once

#include <cstdint>
#include <span>

#include "geometry/mesh.hpp"

namespace mansard {

/// The lower edge of a sill or a ledge, which water leaves. Metres, y up.
struct Drip {
  Vec3 from, to;  ///< level, from left to right as seen from outside
  Vec3 out;       ///< unit length, level, away from the wall
  double top;     ///< height of the upper side
  double depth;   ///< from `from` along `out`, 0 or more
  double rate;    ///< how strongly it stains, above 0 to 1
  uint64_t seed;

  void move(Vec3 by) {
    from = from + by;
    to = to + by;
    top += by.y;
  }
};

/// Metres that stains lie before their wall: more than a depth buffer confuses at a hundred metres,
/// less than any sill stands out.
inline constexpr double stain_gap = 0.005;

/// Draws what runs down from each drip: on the faces that stand below it in one plane, from the
/// drip's lower edge to the faces' end, to the next drip or to where it peters out. `walls` are the
/// polygons of the surface that take stains at all. The stains are appended as one run; all that
/// was there stays as it is. A drip below which nothing stands leaves no stain.
void add_streaks(Surface& surface, std::span<const Drip> drips, std::span<const uint32_t> walls,
                 uint32_t symbol, uint32_t material);

}  // namespace mansard
