// What turns CGAL's skeleton into one to build on: jitter before, welding and checks after.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/clean.hpp"
#include "geometry/skeleton.hpp"

namespace mansard {
namespace {

constexpr double weld_distance = 1e-5;  // metres
constexpr double settle_distance = 1e-3;

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

uint32_t root(std::vector<uint32_t>& parents, uint32_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

// Drops repeated nodes and a-b-a spikes; the edge from the first corner to the second stays.
void tidy(std::vector<uint32_t>& loop) {
  for (std::size_t i = 2; i < loop.size();) {
    const uint32_t next = i + 1 < loop.size() ? loop[i + 1] : loop[0];
    if (loop[i] == loop[i - 1] || loop[i] == next) {
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
      i = std::max<std::size_t>(2, i - 1);
    } else if (loop[i - 1] == next && i > 2) {
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i - 1),
                 loop.begin() + static_cast<std::ptrdiff_t>(i + 1));
      i = std::max<std::size_t>(2, i - 2);
    } else {
      ++i;
    }
  }
}

// Joins inner nodes along edges that are shorter than the weld distance, and drops unused ones.
SkeletonMesh welded(const SkeletonMesh& mesh, std::size_t contour) {
  std::vector<uint32_t> parents(mesh.nodes.size());
  std::iota(parents.begin(), parents.end(), 0u);
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const uint32_t a = face[i], b = face[(i + 1) % face.size()];
      if (a < contour || b < contour) continue;
      if (length(mesh.nodes[a] - mesh.nodes[b]) >= weld_distance) continue;
      const uint32_t one = root(parents, a), two = root(parents, b);
      parents[std::max(one, two)] = std::min(one, two);
    }
  }
  SkeletonMesh out;
  out.nodes.assign(mesh.nodes.begin(), mesh.nodes.begin() + static_cast<std::ptrdiff_t>(contour));
  constexpr uint32_t none = ~0u;
  std::vector<uint32_t> numbers(mesh.nodes.size(), none);
  std::iota(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(contour), 0u);
  std::vector<uint32_t> loop;
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    loop.clear();
    for (const uint32_t i : mesh.face(f)) loop.push_back(root(parents, i));
    tidy(loop);
    for (const uint32_t i : loop) {
      if (numbers[i] == none) {
        numbers[i] = static_cast<uint32_t>(out.nodes.size());
        out.nodes.push_back(mesh.nodes[i]);
      }
      out.corners.push_back(numbers[i]);
    }
    out.face_ends.push_back(static_cast<uint32_t>(out.corners.size()));
  }
  return out;
}

// The walls of the faces around each inner node, as pairs (node, wall) in node order.
std::vector<std::pair<uint32_t, uint32_t>> walls_at_nodes(const SkeletonMesh& mesh,
                                                          std::size_t contour) {
  std::vector<std::pair<uint32_t, uint32_t>> pairs;
  for (uint32_t f = 0; f < mesh.faces(); ++f) {
    for (const uint32_t i : mesh.face(f)) {
      if (i >= contour) pairs.emplace_back(i, f);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// One step of least squares from `node` to the point at equal distance from its walls: it solves
// (sum(a a^T) + damping) d = -sum(a r), with a = (n, -1) and r the residual of each wall. Damped
// (Levenberg 1944), so that a node between walls along one line stays where it is along its ridge.
Vec3 step_to_walls(Vec3 node, Vec2 origin, const std::vector<WallLine>& lines,
                   const std::pair<uint32_t, uint32_t>* begin,
                   const std::pair<uint32_t, uint32_t>* end) {
  constexpr double damping = 1e-6;
  Vec3 rows[3] = {{damping, 0, 0}, {0, damping, 0}, {0, 0, damping}}, right;
  for (auto pair = begin; pair != end; ++pair) {
    const WallLine& line = lines[pair->second];
    const Vec3 a{line.normal.x, line.normal.y, -1};
    const double r = line.distance(Vec2{node.x, node.y} - origin) - node.z;
    rows[0] = rows[0] + a * a.x;
    rows[1] = rows[1] + a * a.y;
    rows[2] = rows[2] + a * a.z;
    right = right + a * -r;
  }
  const double determinant = dot(rows[0], cross(rows[1], rows[2]));
  return {dot(right, cross(rows[1], rows[2])) / determinant,
          dot(rows[0], cross(right, rows[2])) / determinant,
          dot(rows[0], cross(rows[1], right)) / determinant};
}

// The planes of the polygon, not of the jittered one: a rectangle's ridge gets straight again.
void settle(SkeletonMesh& mesh, const Polygon& polygon) {
  const std::size_t contour = polygon.points.size();
  const Vec2 origin = polygon.points[0];
  std::vector<WallLine> lines;
  for_each_edge(polygon, [&](uint32_t, Vec2 a, Vec2 b) {
    lines.push_back(wall_line(a - origin, b - origin));
  });
  for (std::size_t i = 0; i < contour; ++i) {
    mesh.nodes[i] = {polygon.points[i].x, polygon.points[i].y, 0};
  }
  const auto pairs = walls_at_nodes(mesh, contour);
  for (std::size_t i = 0; i < pairs.size();) {
    std::size_t j = i;
    while (j < pairs.size() && pairs[j].first == pairs[i].first) ++j;
    Vec3& node = mesh.nodes[pairs[i].first];
    for (int round = 0; round < 3; ++round) {
      const Vec3 step = step_to_walls(node, origin, lines, &pairs[i], pairs.data() + j);
      if (length(step) < settle_distance) node = node + step;
    }
    i = j;
  }
}

bool closed(const SkeletonMesh& mesh, std::size_t contour) {
  std::vector<std::pair<uint32_t, uint32_t>> edges, opposite;
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const auto face = mesh.face(f);
    if (face.size() < 3 || face[0] >= contour || face[1] >= contour) return false;
    for (std::size_t i = 1; i < face.size(); ++i) {
      const uint32_t a = face[i], b = face[(i + 1) % face.size()];
      edges.emplace_back(a, b);
      opposite.emplace_back(b, a);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(opposite.begin(), opposite.end());
  return edges == opposite;
}

bool planar_and_covering(const SkeletonMesh& mesh, const Polygon& polygon) {
  const std::vector<WallLine> lines = wall_lines(polygon);
  double covered = 0;
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const auto face = mesh.face(f);
    const Vec3 first = mesh.nodes[face[0]];
    double twice = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3 p = mesh.nodes[face[i]], q = mesh.nodes[face[(i + 1) % face.size()]];
      if (!(std::abs(lines[f].distance({p.x, p.y}) - p.z) < 1e-3)) return false;
      twice += cross(Vec2{p.x - first.x, p.y - first.y}, Vec2{q.x - first.x, q.y - first.y});
    }
    if (!(twice > 0)) return false;
    covered += twice / 2;
  }
  const double whole = area(polygon);
  return std::abs(covered - whole) <= 1e-6 * whole;
}

}  // namespace

std::optional<SkeletonMesh> checked_skeleton(const Polygon& polygon, double jitter) {
  const std::optional<SkeletonMesh> raw = raw_skeleton(jittered(polygon, jitter));
  if (!raw) return std::nullopt;
  SkeletonMesh mesh = *raw;
  settle(mesh, polygon);
  mesh = welded(mesh, polygon.points.size());
  settle(mesh, polygon);
  if (!closed(mesh, polygon.points.size())) return std::nullopt;
  if (!planar_and_covering(mesh, polygon)) return std::nullopt;
  return mesh;
}

}  // namespace mansard
