// The straight skeleton as points with numbers, for the roofs. Nothing here is CGAL's.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/polygon.hpp"
#include "geometry/vector.hpp"

namespace mansard {

/// The faces of a straight skeleton, one an edge of its polygon, in edge order. Faces share nodes
/// by number, so that what is built on them is closed by construction.
struct SkeletonMesh {
  std::vector<Vec3> nodes;          ///< (u, v, inset distance); the polygon's points come first
  std::vector<uint32_t> corners;    ///< node numbers, face after face, each from its edge's start
  std::vector<uint32_t> face_ends;  ///< one past the last corner of each face

  std::size_t faces() const { return face_ends.size(); }
  uint32_t face_begin(std::size_t f) const { return f == 0 ? 0 : face_ends[f - 1]; }
  std::span<const uint32_t> face(std::size_t f) const {
    return {corners.data() + face_begin(f), corners.data() + face_ends[f]};
  }
};

/// The line of a wall as n.p + c: the distance of p inwards from it.
struct WallLine {
  Vec2 normal;
  double c = 0;
  double distance(Vec2 p) const { return dot(normal, p) + c; }
};
WallLine wall_line(Vec2 from, Vec2 to);
std::vector<WallLine> wall_lines(const Polygon& polygon);

/// The point (u, v, t) at the distance t from three lines; nullopt when there is no single one.
std::optional<Vec3> meet(const WallLine& a, const WallLine& b, const WallLine& c);

/// CGAL's straight skeleton of a clean, simple, oriented polygon, as it comes. nullopt when CGAL
/// gives none. What is not clean may crash or hang it (CGAL 5.5): see clean.hpp.
std::optional<SkeletonMesh> raw_skeleton(const Polygon& polygon);

/// The skeleton of a convex quadrilateral in closed form: six nodes, the ridge from node 4, the tip
/// of a triangle, to node 5; they coincide where it would be shorter than 1e-5 m. nullopt for other
/// polygons.
std::optional<SkeletonMesh> quad_skeleton(const Polygon& polygon);

/// The trace of a wavefront in doubles: some ten times as quick as CGAL, and with less care. A
/// wrong result is as possible as none, so it is for checked_skeleton. Steps in the wavefront that
/// are born narrower than `together` metres and stay so vanish at once, so that the slopes of walls
/// along one line are parted square to them.
std::optional<SkeletonMesh> wavefront_skeleton(const Polygon& polygon, double together);

/// Who makes a skeleton.
enum class SkeletonMaker : uint8_t { closed_form, wavefront, cgal };

/// A way to a skeleton: the wavefront's or CGAL's, of the polygon with every point moved by
/// `jitter` metres at most, which keeps events apart; then all nodes are moved to where the planes
/// of the polygon itself meet, and those that are closer than `weld` joined. Too small a jitter
/// lets CGAL crash, too large a one turns over what is smaller.
struct SkeletonWay {
  SkeletonMaker maker;
  double jitter, weld, together;  ///< metres; `together` is the wavefront's
};

/// nullopt unless the skeleton passes every check: a face for each edge, closed, planar within
/// 5e-6 m and 1e-3 degrees, no face across itself, and covering the polygon within 1e-6 of its
/// area. The closed form needs neither jitter nor weld.
std::optional<SkeletonMesh> checked_skeleton(const Polygon& polygon, const SkeletonWay& way);

/// The first rung of the ladder that gives a checked skeleton, with the polygon it stands on.
struct SkeletonOn {
  SkeletonMesh mesh;
  Polygon polygon;               ///< cleaned
  std::vector<uint32_t> points;  ///< these three as in Cleaned
  std::vector<uint32_t> edges;
  std::vector<uint32_t> edge_of;
  bool moved = false;  ///< corners have not the coordinates of their original points
  int fallback = 1;    ///< 1 as asked, 2 moved by millimetres or where it touched itself,
                       ///< 3 simplified by centimetres
  SkeletonMaker maker = SkeletonMaker::wavefront;
  /// Of a closed form: the edge whose face is the triangle with node 4.
  std::optional<uint32_t> quad_first;
};
std::optional<SkeletonOn> best_skeleton(const Polygon& polygon);

}  // namespace mansard
