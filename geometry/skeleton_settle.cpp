// Joins nodes that belong together, and moves all to where the planes of the polygon meet.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/skeleton_steps.hpp"

namespace mansard {
namespace {

constexpr double settle_distance = 1e-3;  // metres that a node moves at most in one step
constexpr uint32_t none = ~0u;

// One step of least squares from `node` to the point at equal distance from its walls: it solves
// (sum(a a^T) + damping) d = -sum(a r), with a = (n, -1) and r the residual of each wall. Damped
// (Levenberg 1944), so that a node between walls along one line stays where it is along its ridge.
Vec3 step_to_walls(Vec3 node, const std::vector<WallLine>& lines,
                   std::span<const Spokes::Spoke> spokes) {
  constexpr double damping = 1e-6;
  Vec3 rows[3] = {{damping, 0, 0}, {0, damping, 0}, {0, 0, damping}}, right;
  for (const Spokes::Spoke& spoke : spokes) {
    const WallLine& line = lines[spoke.face];
    const Vec3 a{line.normal.x, line.normal.y, -1};
    const double r = line.distance({node.x, node.y}) - node.z;
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

// Three walls that meet at a good angle, as at most nodes, have one point.
std::optional<Vec3> meet_well(const WallLine& a, const WallLine& b, const WallLine& c) {
  constexpr double well = 1e-7;
  if (std::abs(cross(a.normal - b.normal, b.normal - c.normal)) < well) return std::nullopt;
  return meet(a, b, c);
}

Vec3 settled(Vec3 node, const std::vector<WallLine>& lines, std::span<const Spokes::Spoke> spokes) {
  if (spokes.size() == 3) {
    const auto p = meet_well(lines[spokes[0].face], lines[spokes[1].face], lines[spokes[2].face]);
    if (p && length(*p - node) < settle_distance) return *p;
  }
  for (int round = 0; round < 3; ++round) {
    const Vec3 step = step_to_walls(node, lines, spokes);
    if (length(step) < settle_distance) node = node + step;
  }
  return node;
}

void settle_nodes(Workpiece& piece) {
  const std::vector<Vec2>& points = piece.polygon.points;
  std::vector<Vec3>& nodes = piece.mesh.nodes;
  for (std::size_t i = 0; i < points.size(); ++i) nodes[i] = {points[i].x, points[i].y, 0};
  for (std::size_t i = points.size(); i < nodes.size(); ++i) {
    nodes[i] = settled(nodes[i], piece.lines, piece.spokes.at(static_cast<uint32_t>(i)));
  }
}

uint32_t root(std::vector<uint32_t>& parents, uint32_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

// Calls f(a, b) for every arc between inner nodes that is shorter than `reach`.
template <class F>
void for_each_short_arc(const SkeletonMesh& mesh, std::size_t contour, double reach, F f) {
  for (std::size_t e = 0; e < mesh.faces(); ++e) {
    const auto face = mesh.face(e);
    for (std::size_t i = 2; i + 1 < face.size(); ++i) {
      const uint32_t a = face[i], b = face[i + 1];
      if (a < contour || b < contour) continue;
      if (length(mesh.nodes[a] - mesh.nodes[b]) < reach) f(a, b);
    }
  }
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

SkeletonMesh joined(const SkeletonMesh& mesh, std::size_t contour, std::vector<uint32_t>& parents) {
  SkeletonMesh out;
  out.nodes.assign(mesh.nodes.begin(), mesh.nodes.begin() + static_cast<std::ptrdiff_t>(contour));
  std::vector<uint32_t> numbers(mesh.nodes.size(), none), loop;
  std::iota(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(contour), 0u);
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

// Whether there was anything to join.
bool weld(SkeletonMesh& mesh, std::size_t contour, double reach) {
  bool any = false;
  for_each_short_arc(mesh, contour, reach, [&](uint32_t, uint32_t) { any = true; });
  if (!any) return false;
  std::vector<uint32_t> parents(mesh.nodes.size());
  std::iota(parents.begin(), parents.end(), 0u);
  for_each_short_arc(mesh, contour, reach, [&](uint32_t a, uint32_t b) {
    const uint32_t one = root(parents, a), two = root(parents, b);
    parents[std::max(one, two)] = std::min(one, two);
  });
  mesh = joined(mesh, contour, parents);
  return true;
}

}  // namespace

Spokes::Spokes(const SkeletonMesh& mesh) : spokes(mesh.corners.size()), ends(mesh.nodes.size()) {
  for (const uint32_t i : mesh.corners) ++ends[i];
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
  // Backwards, so that each node's spokes come in the order of the faces, and ends become begins.
  for (auto f = static_cast<uint32_t>(mesh.faces()); f-- > 0;) {
    const auto face = mesh.face(f);
    for (std::size_t i = face.size(); i-- > 0;) {
      spokes[--ends[face[i]]] = {f, face[i + 1 < face.size() ? i + 1 : 0]};
    }
  }
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i - 1] = ends[i];
  if (!ends.empty()) ends.back() = static_cast<uint32_t>(spokes.size());
}

void settle(Workpiece& piece, double reach) {
  settle_nodes(piece);
  if (!weld(piece.mesh, piece.polygon.points.size(), reach)) return;
  piece.spokes = Spokes(piece.mesh);
  settle_nodes(piece);
}

}  // namespace mansard
