// Rings that cross themselves or each other, made into polygons.
#pragma once

#include <vector>

#include "geometry/vector.hpp"

namespace mansard {

struct RepairedRings {
  bool was_valid = false;  ///< nothing was to be done: `pieces` is empty
  bool scribble = false;   ///< more than 1,000 crossings: nothing is done, `pieces` is empty
  /// Polygons (the outline, then its holes) without repeated points; the outline counter-clockwise,
  /// with the first edge first where it is still there.
  std::vector<std::vector<std::vector<Vec2>>> pieces;
};

/// `rings`: an outline and holes, of three points and more, finite, not repeating the first one.
/// Valid is as in OGC 06-103r4 §6.1.11. Every ring becomes the area that it winds around, then
/// holes are taken from the outline ("structure" of GEOS): where a ring overlaps itself no hole
/// comes of it. Pieces under 0.01 m^2 are dropped; there may be none.
RepairedRings repair(const std::vector<std::vector<Vec2>>& rings);

}  // namespace mansard
