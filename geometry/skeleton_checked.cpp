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

Polygon jittered(const Polygon& polygon, double by) {
  Polygon moved = polygon;
  for (std::size_t i = 0; i < moved.points.size(); ++i) {
    moved.points[i] = moved.points[i] + Vec2{hashed(2 * i), hashed(2 * i + 1)} * (by * 0.7);
  }
  return moved;
}

}  // namespace

std::optional<SkeletonMesh> checked_skeleton(const Polygon& polygon, const SkeletonWay& way) {
  Polygon local = polygon;  // so that far away polygons lose no digits
  const Vec2 origin = polygon.points[0];
  translate(local, origin * -1);
  const auto raw = way.maker == SkeletonMaker::cgal ? raw_skeleton : wavefront_skeleton;
  std::optional<SkeletonMesh> mesh = raw(jittered(local, way.jitter));
  if (!mesh) return std::nullopt;
  settle(*mesh, local, way.weld);
  if (!is_sound(*mesh, local)) return std::nullopt;
  for (std::size_t i = 0; i < mesh->nodes.size(); ++i) {
    Vec3& node = mesh->nodes[i];
    const bool contour = i < polygon.points.size();
    const Vec2 p = contour ? polygon.points[i] : Vec2{node.x, node.y} + origin;
    node = {p.x, p.y, node.z};
  }
  return mesh;
}

}  // namespace mansard
