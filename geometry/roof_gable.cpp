// Gables by moving a hip's tip along its ridge into the wall (Laycock & Day 2003 made exact): the
// slopes at both sides stay in their planes, since the ridge is their common line.
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/roof_parts.hpp"

namespace mansard {
namespace {

// The foot of a gable's tip lies on the wall, away from its corners.
bool stands_on(Vec3 tip, Vec2 from, Vec2 to) {
  const Vec2 d = to - from;
  const double along = dot(Vec2{tip.x, tip.y} - from, d) / dot(d, d);
  return tip.z > 0 && along > 0.02 && along < 0.98;
}

struct Tip {
  uint32_t node;
  uint32_t left, right;  // the faces before and after the wall's
};

// The tip of the triangle on edge e, where just three faces meet.
std::optional<Tip> hip_tip(const SkeletonMesh& mesh, uint32_t e) {
  const auto face = mesh.face(e);
  if (face.size() != 3) return std::nullopt;
  Tip tip{face[2], 0, 0};
  int count = 0;
  for (uint32_t f = 0; f < mesh.faces(); ++f) {
    const auto other = mesh.face(f);
    if (std::find(other.begin(), other.end(), tip.node) == other.end()) continue;
    ++count;
    if (f == e) continue;
    if (other[1] == face[0]) tip.left = f;
    if (other[0] == face[1]) tip.right = f;
  }
  if (count != 3 || tip.left == tip.right) return std::nullopt;
  return tip;
}

// The node before or after `node` in the loop of a face.
uint32_t beside(std::span<const uint32_t> face, uint32_t node, std::size_t step) {
  const auto at =
      static_cast<std::size_t>(std::find(face.begin(), face.end(), node) - face.begin());
  return face[(at + step) % face.size()];
}

std::optional<Vec3> gable_tip(const SkeletonOn& on, const std::vector<WallLine>& lines, uint32_t e,
                              const Tip& tip) {
  const SkeletonMesh& mesh = on.mesh;
  const auto left = mesh.face(tip.left);
  const uint32_t along = beside(left, tip.node, 1);  // the ridge's other end
  if (along != beside(mesh.face(tip.right), tip.node, mesh.face(tip.right).size() - 1)) {
    return std::nullopt;
  }
  const Vec3 old = mesh.nodes[tip.node], other = mesh.nodes[along];
  const Vec2 ridge = left_of(lines[tip.left].normal - lines[tip.right].normal);
  const Vec2 inwards = lines[e].normal;
  if (std::abs(dot(ridge, inwards)) < 0.2 * length(ridge)) return std::nullopt;
  if (dot(Vec2{other.x - old.x, other.y - old.y}, inwards) < 1e-3) return std::nullopt;
  const auto moved = ridge_above(lines[tip.left], lines[tip.right], lines[e]);
  if (!moved || moved->z < 0.2 * old.z || moved->z > 2 * old.z) return std::nullopt;
  const Vec3 from = mesh.nodes[mesh.face(e)[0]], to = mesh.nodes[mesh.face(e)[1]];
  if (!stands_on(*moved, {from.x, from.y}, {to.x, to.y})) return std::nullopt;
  return moved;
}

std::vector<char> gables_by_tips(SkeletonOn& on, const std::function<bool(uint32_t)>& allowed) {
  const std::vector<WallLine> lines = wall_lines(on.polygon);
  std::vector<char> gable(lines.size(), 0), moved(on.mesh.nodes.size(), 0);
  for (uint32_t e = 0; e < on.polygon.ring_ends[0]; ++e) {
    if (on.mesh.face(e).size() != 3 || !allowed(e)) continue;
    const std::optional<Tip> tip = hip_tip(on.mesh, e);
    if (!tip || moved[tip->node]) continue;
    if (const auto to = gable_tip(on, lines, e, *tip)) {
      on.mesh.nodes[tip->node] = *to;
      gable[e] = moved[tip->node] = 1;
    }
  }
  return gable;
}

// A ridge from edge `e` to the one across, each end a gable where allowed and else a hip.
bool ridge_from(SkeletonOn& on, uint32_t e, const std::array<char, 4>& allowed) {
  const Vec2 origin = on.polygon.points[0];
  std::array<WallLine, 4> lines;
  for (uint32_t i = 0; i < 4; ++i) {
    lines[i] = wall_line(on.polygon.points[i] - origin, on.polygon.points[(i + 1) % 4] - origin);
  }
  const WallLine &left = lines[(e + 3) % 4], &right = lines[(e + 1) % 4];
  std::array<Vec3, 2> ends;
  for (uint32_t k = 0; k < 2; ++k) {
    const uint32_t wall = (e + 2 * k) % 4;
    const auto end =
        allowed[wall] ? ridge_above(left, right, lines[wall]) : meet(left, right, lines[wall]);
    if (!end || end->z <= 0) return false;
    if (allowed[wall] && !stands_on(*end, on.polygon.points[wall] - origin,
                                    on.polygon.points[(wall + 1) % 4] - origin)) {
      return false;
    }
    ends[k] = *end;
  }
  const Vec2 run{ends[1].x - ends[0].x, ends[1].y - ends[0].y};
  if (dot(run, lines[e].normal) < 1e-3 || dot(run, lines[(e + 2) % 4].normal) > -1e-3) return false;
  on.mesh.nodes.resize(4);
  for (const Vec3 end : ends) on.mesh.nodes.push_back({end.x + origin.x, end.y + origin.y, end.z});
  on.mesh.corners.clear();
  on.mesh.face_ends.clear();
  for (uint32_t i = 0; i < 4; ++i) {
    on.mesh.corners.insert(on.mesh.corners.end(), {i, (i + 1) % 4});
    if (i == e) on.mesh.corners.push_back(4);
    if (i == (e + 1) % 4) on.mesh.corners.insert(on.mesh.corners.end(), {5, 4});
    if (i == (e + 2) % 4) on.mesh.corners.push_back(5);
    if (i == (e + 3) % 4) on.mesh.corners.insert(on.mesh.corners.end(), {4, 5});
    on.mesh.face_ends.push_back(static_cast<uint32_t>(on.mesh.corners.size()));
  }
  return true;
}

std::vector<char> gables_of_quad(SkeletonOn& on, const std::function<bool(uint32_t)>& allowed) {
  std::array<char, 4> can;
  for (uint32_t i = 0; i < 4; ++i) can[i] = allowed(i);
  // The hip's own ridge is the longer one; over a square the one along its first edge.
  uint32_t e = *on.quad_first % 2, across = 1 - e;
  const bool square = length(on.mesh.nodes[4] - on.mesh.nodes[5]) < 1e-3;
  if (square && e == 0) std::swap(e, across);
  const int here = can[e] + can[e + 2], there = can[across] + can[across + 2];
  if (square ? there > here : here == 0) std::swap(e, across);
  std::vector<char> gable(4, 0);
  if (can[e] + can[e + 2] == 0 || !ridge_from(on, e, can)) return gable;
  gable[e] = can[e];
  gable[e + 2] = can[e + 2];
  return gable;
}

}  // namespace

std::optional<Vec3> ridge_above(const WallLine& left, const WallLine& right, const WallLine& wall) {
  const Vec2 n = left.normal - right.normal;
  const double determinant = cross(n, wall.normal);
  if (std::abs(determinant) < 1e-9) return std::nullopt;
  const double c1 = right.c - left.c, c2 = -wall.c;
  const Vec2 p{(c1 * wall.normal.y - c2 * n.y) / determinant,
               (n.x * c2 - wall.normal.x * c1) / determinant};
  return Vec3{p.x, p.y, (left.distance(p) + right.distance(p)) / 2};
}

std::vector<char> make_gables(SkeletonOn& on, const std::function<bool(uint32_t)>& allowed) {
  return on.quad_first ? gables_of_quad(on, allowed) : gables_by_tips(on, allowed);
}

}  // namespace mansard
