// A planar polygon with holes, in metres in the frame of its shape (u to the right, v up the face
// or into the depth of the footprint).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vector.hpp"

namespace mansard {

/// What is known of an edge. It survives clipping, offsetting and cleaning; a merged edge keeps the
/// tag of its longest part.
struct EdgeTag {
  enum Flag : uint16_t {
    party = 1,   ///< shared with a neighbouring building
    court = 2,   ///< faces a hole of the footprint
    street = 4,  ///< free towards a street
    main = 8,    ///< the longest street edge
    cut = 16,    ///< made by a split or clip
    corner = 32  ///< a street edge that meets another one in an outer corner
  };
  static constexpr uint16_t no_wall = 0xffff;

  uint16_t flags = 0;
  uint16_t wall = no_wall;  ///< number of the footprint's edge it came from

  constexpr bool has(Flag f) const { return (flags & f) != 0; }
  friend constexpr bool operator==(const EdgeTag&, const EdgeTag&) = default;
};

/// Rings one after the other: the first is the outline, counter-clockwise; the others are holes,
/// clockwise. A ring does not repeat its first point. Edge i runs from point i to the next of its
/// ring and has tags[i].
struct Polygon {
  std::vector<Vec2> points;
  std::vector<EdgeTag> tags;        ///< as long as points
  std::vector<uint32_t> ring_ends;  ///< one past the last point of each ring

  std::size_t rings() const { return ring_ends.size(); }
  uint32_t ring_begin(std::size_t r) const { return r == 0 ? 0 : ring_ends[r - 1]; }
  std::span<const Vec2> ring(std::size_t r) const {
    return {points.data() + ring_begin(r), points.data() + ring_ends[r]};
  }
  bool empty() const { return points.empty(); }
  bool has_holes() const { return ring_ends.size() > 1; }

  /// Keeps the capacity, so that a pool of polygons stops allocating.
  void clear() {
    points.clear();
    tags.clear();
    ring_ends.clear();
  }
  void add_point(Vec2 p, EdgeTag tag = {}) {
    points.push_back(p);
    tags.push_back(tag);
  }
  void close_ring() { ring_ends.push_back(static_cast<uint32_t>(points.size())); }
};

struct Box2 {
  Vec2 low, high;
  constexpr Vec2 size() const { return high - low; }
};

/// Calls f(edge, from, to) for every edge, in order.
template <class F>
void for_each_edge(const Polygon& polygon, F f) {
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) {
      f(i, polygon.points[i], polygon.points[i + 1 == end ? begin : i + 1]);
    }
  }
}

/// For each point the number of the next one of its ring.
std::vector<uint32_t> next_points(const Polygon& polygon);
Polygon rectangle(double width, double height);
/// Signed: positive for counter-clockwise rings.
double area(std::span<const Vec2> ring);
/// Outline less holes.
double area(const Polygon& polygon);
double perimeter(const Polygon& polygon);
Box2 bounds(std::span<const Vec2> points);
/// Convex outline and no holes; collinear points are allowed.
bool is_convex(const Polygon& polygon);
/// Four corners, right angles within `tolerance` metres, edges along u and v.
bool is_axis_rectangle(const Polygon& polygon, double tolerance);
/// True for points inside or on the border (even-odd over all rings).
bool contains(const Polygon& polygon, Vec2 point);
void translate(Polygon& polygon, Vec2 by);
/// Mirrors at the v axis through u = 0 and keeps the orientation of rings and the edge tags.
void mirror_u(Polygon& polygon);
/// Turns rings so that the outline is counter-clockwise and holes are clockwise, keeping each
/// ring's first edge first.
void orient(Polygon& polygon);

}  // namespace mansard
