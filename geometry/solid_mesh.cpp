#include "geometry/solid_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "geometry/clip.hpp"

namespace mansard {

bool is_before(const Nearest3& a, const Nearest3& b) {
  const auto key = [](const Nearest3& n) {
    return std::tuple(n.distance, n.second.x, n.second.y, n.second.z, n.first.x, n.first.y,
                      n.first.z);
  };
  return key(a) < key(b);
}

SolidMesh::SolidMesh(Mesh mesh) : mesh_(std::move(mesh)) {
  if (!is_large()) return;
  std::vector<Box3> boxes;
  std::vector<Vec3> loop;
  for (const Mesh::Face& face : mesh_.faces) {
    loop.clear();
    for (const uint32_t corner : mesh_.loop(face)) loop.push_back(mesh_.points[corner]);
    boxes.push_back(bounds(loop));
  }
  faces_.build(boxes);
}

void SolidMesh::find_triangles() {
  if (std::exchange(has_triangles_, true)) return;
  std::vector<Box3> boxes;
  std::vector<Vec3> loop;
  for (const Mesh::Face& face : mesh_.faces) {
    loop.clear();
    for (const uint32_t corner : mesh_.loop(face)) loop.push_back(mesh_.points[corner]);
    const std::vector<uint32_t> corners =
        loop.size() == 3 ? std::vector<uint32_t>{0, 1, 2} : triangulate(loop);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      triangles_.push_back({loop[corners[i]], loop[corners[i + 1]], loop[corners[i + 2]]});
      boxes.push_back(bounds(triangles_.back()));
    }
  }
  index_.build(boxes);
}

Mesh SolidMesh::across(Vec3 normal, double at, const Box3* box) const {
  std::vector<uint32_t> numbers;
  faces_.across(normal, at, numbers);
  if (box) {
    std::vector<uint32_t> near, both;
    faces_.near(*box, near);
    std::ranges::set_union(numbers, near, std::back_inserter(both));
    numbers = std::move(both);
  }
  Mesh part;
  std::vector<uint32_t> used;
  for (const uint32_t f : numbers) {
    const auto loop = mesh_.loop(mesh_.faces[f]);
    used.insert(used.end(), loop.begin(), loop.end());
  }
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const uint32_t point : used) part.points.push_back(mesh_.points[point]);
  std::vector<uint32_t> loop;
  for (const uint32_t f : numbers) {
    loop.clear();
    for (const uint32_t corner : mesh_.loop(mesh_.faces[f]))
      loop.push_back(static_cast<uint32_t>(std::ranges::lower_bound(used, corner) - used.begin()));
    part.add_face(loop);
  }
  return part;
}

std::optional<Nearest3> SolidMesh::nearest(const Triangle& triangle, double within) {
  find_triangles();
  std::optional<Nearest3> best;
  index_.nearest(bounds(triangle), within, [&](uint32_t number) {
    const Nearest3 pair = nearest_pair(triangle, triangles_[number]);
    if (pair.distance <= within && (!best || is_before(pair, *best))) best = pair;
    return pair.distance;
  });
  return best;
}

namespace {

/// Two directions at right angles to `way`.
std::pair<Vec3, Vec3> beside(Vec3 way) {
  const Vec3 helper = std::abs(way.y) < 0.9 * length(way) ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  const Vec3 a = normalized(cross(way, helper));
  return {a, cross(normalized(way), a)};
}

/// Whether the ray to the right of (0, 0) crosses p-q. The same for q-p to the last bit, so that
/// no line slips through between two triangles.
bool crosses(Vec2 p, Vec2 q) {
  if ((p.y > 0) == (q.y > 0)) return false;
  if (p.y > q.y) std::swap(p, q);
  return p.x + (q.x - p.x) * (-p.y / (q.y - p.y)) > 0;
}

}  // namespace

/// Shares of the segment at which its line goes through the surface, those on the segment, in
/// order.
std::vector<double> SolidMesh::crossings(Vec3 from, Vec3 to) {
  find_triangles();
  const Vec3 way = to - from;
  const auto [u, v] = beside(way);
  const auto drawn = [&, u = u, v = v](Vec3 p) { return Vec2{dot(p - from, u), dot(p - from, v)}; };
  std::vector<uint32_t> near;
  index_.along(from, to, near);
  std::vector<double> at;
  for (const uint32_t number : near) {
    const Triangle& t = triangles_[number];
    const std::array<Vec2, 3> flat{drawn(t[0]), drawn(t[1]), drawn(t[2])};
    bool over = false;
    for (std::size_t i = 0; i < 3; ++i) over = over != crosses(flat[i], flat[(i + 1) % 3]);
    if (!over) continue;
    const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
    const double share = dot(normal, t[0] - from) / dot(normal, way);
    if (share >= 0 && share <= 1) at.push_back(share);
  }
  std::ranges::sort(at);
  return at;
}

bool SolidMesh::contains(Vec3 p) {
  if (mesh_.points.empty()) return false;
  const double above = bounds(mesh_.points).high.y + 1;
  // Not quite upright: edges of buildings are.
  return p.y < above && crossings(p, {p.x + 1.7e-3, above, p.z + 1.3e-3}).size() % 2 == 1;
}

std::vector<std::pair<double, double>> SolidMesh::inside(Vec3 from, Vec3 to) {
  std::vector<double> at = crossings(from, to);
  if (contains(from)) at.insert(at.begin(), 0);
  if (at.size() % 2 == 1) at.push_back(1);
  std::vector<std::pair<double, double>> parts;
  for (std::size_t i = 0; i + 1 < at.size(); i += 2) parts.emplace_back(at[i], at[i + 1]);
  return parts;
}

}  // namespace mansard
