// Jitter before, settling and checks after.
#include <utility>

#include "geometry/skeleton_steps.hpp"

namespace mansard {
namespace {

// -1 .. 1 from the number of a point, the same on every machine (splitmix64).
double hashed(uint64_t number) {
  uint64_t x = (number + 1) * 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  x ^= x >> 31;
  return static_cast<double>(x >> 11) * 0x1p-52 - 1;
}

// In local coordinates, so that far away polygons lose no digits; and without tags.
void place(Polygon& local, const Polygon& polygon, double jitter) {
  const Vec2 origin = polygon.points[0];
  local.points.resize(polygon.points.size());
  for (std::size_t i = 0; i < local.points.size(); ++i) {
    const Vec2 p = polygon.points[i] - origin;
    local.points[i] = p + Vec2{hashed(2 * i), hashed(2 * i + 1)} * (jitter * 0.7);
  }
}

std::optional<SkeletonMesh> made(const Polygon& local, const SkeletonWay& way) {
  if (way.maker == SkeletonMaker::cgal) return raw_skeleton(local);
  if (way.maker == SkeletonMaker::wavefront) return wavefront_skeleton(local, way.together);
  return quad_skeleton(local);
}

}  // namespace

std::optional<SkeletonMesh> checked_skeleton(const Polygon& polygon, const SkeletonWay& way) {
  Polygon local;
  local.ring_ends = polygon.ring_ends;
  place(local, polygon, way.jitter);
  std::optional<SkeletonMesh> mesh = made(local, way);
  if (!mesh) return std::nullopt;
  place(local, polygon, 0);
  Spokes spokes(*mesh);
  Workpiece piece{local, wall_lines(local), std::move(*mesh), std::move(spokes)};
  if (way.maker != SkeletonMaker::closed_form) settle(piece, way.weld);
  if (!is_sound(piece)) return std::nullopt;
  for (std::size_t i = 0; i < piece.mesh.nodes.size(); ++i) {
    Vec3& node = piece.mesh.nodes[i];
    const bool contour = i < polygon.points.size();
    const Vec2 p = contour ? polygon.points[i] : Vec2{node.x, node.y} + polygon.points[0];
    node = {p.x, p.y, node.z};
  }
  return std::move(piece.mesh);
}

}  // namespace mansard
