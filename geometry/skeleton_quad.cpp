// Closed forms: wall lines and the skeleton of a quadrilateral (more than half of all footprints).
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/skeleton.hpp"

namespace mansard {

WallLine wall_line(Vec2 from, Vec2 to) {
  const Vec2 normal = left_of(normalized(to - from));
  return {normal, -dot(normal, from)};
}

std::vector<WallLine> wall_lines(const Polygon& polygon) {
  std::vector<WallLine> lines;
  lines.reserve(polygon.points.size());
  for_each_edge(polygon, [&](uint32_t, Vec2 a, Vec2 b) { lines.push_back(wall_line(a, b)); });
  return lines;
}

std::optional<Vec3> meet(const WallLine& a, const WallLine& b, const WallLine& c) {
  // Differences of the equations n.p + c = t leave two lines in the plane.
  const Vec2 n1 = a.normal - b.normal, n2 = b.normal - c.normal;
  const double c1 = b.c - a.c, c2 = c.c - b.c;
  const double determinant = cross(n1, n2);
  if (std::abs(determinant) < 1e-9) return std::nullopt;
  const Vec2 p{(c1 * n2.y - c2 * n1.y) / determinant, (n1.x * c2 - n2.x * c1) / determinant};
  return Vec3{p.x, p.y, (a.distance(p) + b.distance(p) + c.distance(p)) / 3};
}

std::optional<SkeletonMesh> quad_skeleton(const Polygon& polygon) {
  if (polygon.points.size() != 4 || polygon.rings() != 1) return std::nullopt;
  // In coordinates of its first point, so that far away ones lose no digits.
  const Vec2 origin = polygon.points[0];
  std::array<WallLine, 4> lines;
  for (uint32_t i = 0; i < 4; ++i) {
    const Vec2 a = polygon.points[i], b = polygon.points[(i + 1) % 4],
               c = polygon.points[(i + 2) % 4];
    if (cross(normalized(b - a), normalized(c - b)) < 1e-3) return std::nullopt;
    lines[i] = wall_line(a - origin, b - origin);
  }
  // The edge that the shrinking outline loses first; the three others meet in the last point.
  uint32_t e = 0;
  std::optional<Vec3> first;
  for (uint32_t i = 0; i < 4; ++i) {
    const auto at = meet(lines[(i + 3) % 4], lines[i], lines[(i + 1) % 4]);
    if (!at || at->z <= 0 || (first && at->z >= first->z)) continue;
    first = at;
    e = i;
  }
  if (!first) return std::nullopt;
  const uint32_t right = (e + 1) % 4, across = (e + 2) % 4, left = (e + 3) % 4;
  const auto last = meet(lines[left], lines[right], lines[across]);
  if (!last || last->z < first->z - 1e-9) return std::nullopt;

  Vec3 end = *last;
  if (length(end - *first) < 1e-5) first = end = mix(*first, end, 0.5);
  SkeletonMesh mesh;
  mesh.nodes.reserve(6);
  mesh.corners.reserve(14);
  mesh.face_ends.reserve(4);
  for (const Vec2 p : polygon.points) mesh.nodes.push_back({p.x, p.y, 0});
  for (const Vec3 p : {*first, end}) mesh.nodes.push_back({p.x + origin.x, p.y + origin.y, p.z});
  for (uint32_t i = 0; i < 4; ++i) {
    mesh.corners.insert(mesh.corners.end(), {i, (i + 1) % 4});
    if (i == e) mesh.corners.push_back(4);
    if (i == right) mesh.corners.insert(mesh.corners.end(), {5, 4});
    if (i == across) mesh.corners.push_back(5);
    if (i == left) mesh.corners.insert(mesh.corners.end(), {4, 5});
    mesh.face_ends.push_back(static_cast<uint32_t>(mesh.corners.size()));
  }
  return mesh;
}

}  // namespace mansard
