// The topology of cutting rings by a line: which corners stay and how the cut closes them. Shared
// by the clipping of polygons and of the faces of meshes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygon.hpp"

namespace mansard {

/// A corner of a kept piece: the ring point `edge` itself, or the point where edge `edge` crosses
/// the line. The edge that leaves the corner is a new one when `cut_follows`, else `edge`.
struct CutCorner {
  uint32_t edge = 0;
  bool crossing = false;
  bool cut_follows = false;
};

struct LineCut {
  std::vector<CutCorner> corners;   ///< of all loops, one after the other
  std::vector<uint32_t> loop_ends;  ///< one past the last corner of each loop
};

/// Keeps what lies where `side` is negative. `side` is zero for points on the line; `along` is
/// their position in metres on it, growing to the right of the direction in which `side` grows.
/// Rings must have their interior to the left. Points of the line within `tolerance` are one point.
/// Every loop that touches the cut is an outline; others are rings that were kept whole.
LineCut cut_by_line(std::span<const double> side, std::span<const double> along,
                    std::span<const uint32_t> ring_ends, double tolerance);

/// Puts loops together: counter-clockwise ones are outlines, clockwise ones holes of the outline
/// around them. `loops` is a polygon only in its storage. Loops thinner than `tolerance` vanish.
std::vector<Polygon> assemble(const Polygon& loops, double tolerance);

}  // namespace mansard
