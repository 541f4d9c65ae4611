// What an edge sweeps over when it moves to one side, corners mitred: the common part of setbacks
// and outsets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygon.hpp"

namespace mansard {

/// An edge and the convex figure that it sweeps over.
struct Side {
  uint32_t edge = 0;
  Vec2 from, to;        ///< the edge
  Vec2 normal;          ///< unit, the way it moves
  double distance = 0;  ///< metres, positive
  Vec2 moved_from, moved_to;
  bool vanished = false;    ///< its mitres meet before it has moved that far
  std::vector<Vec2> swept;  ///< convex, counter-clockwise, first the edge itself (or its reverse)
};

/// What becomes of the corner between two edges. `in` and `out` are the ends of the moved edges; at
/// corners too sharp for a mitre, `between` is where their swept figures meet.
struct MovedCorner {
  Vec2 in, out, between;
  bool mitred = true;
  bool convex = false;  ///< of the polygon
};

/// Moves every edge to the left (inwards) by distances[edge] metres; negative distances move it
/// outwards. Corners in the order of the polygon's points.
std::vector<MovedCorner> move_corners(const Polygon& polygon, std::span<const double> distances);

/// The same with sides as wide as their edges at convex corners, where mitres would cut them short:
/// for sides that outlive their neighbours.
std::vector<MovedCorner> widen(const Polygon& polygon, std::span<const double> distances,
                               std::vector<MovedCorner> corners);

/// The sides that move, in edge order. All distances must have the same sign.
std::vector<Side> moved_sides(const Polygon& polygon, std::span<const double> distances,
                              std::span<const MovedCorner> corners);

/// Whether two convex figures (or segments) share more than a strip `tolerance` metres wide.
bool convex_overlap(std::span<const Vec2> a, std::span<const Vec2> b, double tolerance);

}  // namespace mansard
