// The ends of ridges: gables, half hips and Dutch hips, by moving a hip's tip along its ridge
// (Laycock & Day 2003 made exact): the slopes at both sides stay in their planes, since the ridge
// is their common line.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/roof_parts.hpp"
#include "geometry/roof_plan.hpp"

namespace mansard {
namespace {

// The foot of a gable's tip lies on the wall, away from its corners.
bool stands_on(Vec3 tip, Vec2 from, Vec2 to) {
  const Vec2 d = to - from;
  const double along = dot(Vec2{tip.x, tip.y} - from, d) / dot(d, d);
  return tip.z > 0 && along > 0.02 && along < 0.98;
}

// The node before or after `node` in the loop of a face.
uint32_t beside(std::span<const uint32_t> face, uint32_t node, std::size_t step) {
  const auto at =
      static_cast<std::size_t>(std::find(face.begin(), face.end(), node) - face.begin());
  return face[(at + step) % face.size()];
}

// Whether the ridge is still well above the eaves where the verge ends.
bool reaches_verge(const WallLine& left, const WallLine& right, WallLine wall, double verge,
                   double height) {
  wall.c += verge;
  const auto end = ridge_above(left, right, wall);
  return verge <= 0 || (end && end->z > 0.3 * height);
}

// Whether the tip of the triangle on edge e, where just three faces meet, can go to the wall.
bool tip_can_move(const SkeletonMesh& mesh, const std::vector<WallLine>& lines, uint32_t e,
                  uint32_t left_edge, uint32_t right_edge, double verge) {
  const auto face = mesh.face(e), left = mesh.face(left_edge), right = mesh.face(right_edge);
  const uint32_t tip = face[2];
  if (left_edge == right_edge) return false;
  const uint32_t along = beside(left, tip, 1);  // the ridge's other end
  if (along != beside(right, tip, right.size() - 1) || along == face[0] || along == face[1]) {
    return false;  // more than three faces meet there, or it is a pyramid of three walls
  }
  if (dot(lines[left_edge].normal, lines[right_edge].normal) >= 0)
    return false;  // a corner cut off
  const Vec3 old = mesh.nodes[tip], other = mesh.nodes[along];
  const Vec2 ridge = left_of(lines[left_edge].normal - lines[right_edge].normal);
  const Vec2 inwards = lines[e].normal;
  if (std::abs(dot(ridge, inwards)) < 0.2 * length(ridge)) return false;
  if (dot(Vec2{other.x - old.x, other.y - old.y}, inwards) < 1e-3) return false;
  const auto moved = ridge_above(lines[left_edge], lines[right_edge], lines[e]);
  if (!moved || moved->z < 0.2 * old.z || moved->z > 2 * old.z) return false;
  if (!reaches_verge(lines[left_edge], lines[right_edge], lines[e], verge, moved->z)) return false;
  const Vec3 from = mesh.nodes[face[0]], to = mesh.nodes[face[1]];
  return stands_on(*moved, {from.x, from.y}, {to.x, to.y});
}

std::vector<RidgeEnd> triangular_ends(const SkeletonOn& on, const std::vector<char>& wanted,
                                      double verge) {
  const std::vector<WallLine> lines = wall_lines(on.polygon);
  std::vector<RidgeEnd> ends;
  std::vector<char> taken(on.mesh.nodes.size(), 0);
  const uint32_t n = on.polygon.ring_ends[0];  // hip ends stand on the outline only
  for (uint32_t e = 0; e < n; ++e) {
    const auto face = on.mesh.face(e);
    if (face.size() != 3 || !wanted[e] || taken[face[2]]) continue;
    if (!tip_can_move(on.mesh, lines, e, (e + n - 1) % n, (e + 1) % n, verge)) {
      continue;
    }
    taken[face[2]] = 1;
    ends.push_back({e, face[2]});
  }
  return ends;
}

// A ridge from edge `e` of a quadrilateral to the one across, over the walls where an end is
// wanted.
bool ridge_from(SkeletonOn& on, uint32_t e, const std::vector<char>& wanted, double verge) {
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
        wanted[wall] ? ridge_above(left, right, lines[wall]) : meet(left, right, lines[wall]);
    if (!end || end->z <= 0) return false;
    if (wanted[wall] && !reaches_verge(left, right, lines[wall], verge, end->z)) return false;
    if (wanted[wall] && !stands_on(*end, on.polygon.points[wall] - origin,
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

std::vector<RidgeEnd> ends_of_quad(SkeletonOn& on, const std::vector<char>& wanted,
                                   std::optional<uint32_t> ridge, double verge) {
  // The hip's own ridge is the longer one; over a square the one along its first edge.
  uint32_t e = *on.quad_first % 2, across = 1 - e;
  const bool square = length(on.mesh.nodes[4] - on.mesh.nodes[5]) < 1e-3;
  if (square && e == 0) std::swap(e, across);
  const int here = wanted[e] + wanted[e + 2], there = wanted[across] + wanted[across + 2];
  const bool turned = ridge ? *ridge % 2 == e : square ? there > here : here == 0;
  if (turned) std::swap(e, across);
  if (wanted[e] + wanted[e + 2] == 0 || !ridge_from(on, e, wanted, verge)) return {};
  std::vector<RidgeEnd> ends;
  if (wanted[e]) ends.push_back({e, 4});
  if (wanted[e + 2]) ends.push_back({e + 2, 5});
  return ends;
}

// Puts `more` between two neighbours in a loop.
void insert_between(std::vector<uint32_t>& loop, uint32_t a, uint32_t b, uint32_t more) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t next = (i + 1) % loop.size();
    if (loop[i] != a || loop[next] != b) continue;
    loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i + 1), more);
    return;
  }
}

// One ridge's end over its wall, while it is shaped.
class End {
 public:
  End(RoofPlan& plan, const RidgeEnd& end)
      : plan_(plan),
        e_(end.edge),
        tip_(end.tip),
        a_(e_),
        b_(plan.next[e_]),
        left_(plan.before[e_]),
        right_(plan.next[e_]) {}

  // Metres from the wall to the ridge's other end.
  double room() const {
    const uint32_t other = beside(plan_.faces[left_].loop, tip_, 1);
    const Vec3 p = plan_.nodes[other].wall;
    return wall().distance({p.x, p.y});
  }
  void to_wall() {
    if (const auto over = ridge_above(slope(left_), slope(right_), wall())) set_tip(*over);
  }
  void make_gable() {
    plan_.faces[e_].part = RoofPart::gable;
    plan_.faces[e_].over_wall = true;
    plan_.borders[e_] = {a_, tip_, b_};
  }
  // The gable's upper part leans back, at the slopes' own pitch.
  bool make_half_hip(double clipped) {
    const double top = tip().z, cut = std::max(top * (1 - clipped), top - 0.48 * room());
    WallLine leaning = wall();
    leaning.c += cut;
    const auto back = meet(slope(left_), slope(right_), leaning);
    if (!back || !(back->z > cut && back->z <= 1.5 * top)) return false;
    const Vec3 over = tip(), a = corner(a_), b = corner(b_);
    const uint32_t c1 = plan_.add_node(mix(a, over, cut / top));
    const uint32_t c2 = plan_.add_node(mix(b, over, cut / top));
    set_tip(*back);
    divide(c1, c2);
    plan_.faces[e_].part = RoofPart::gable;
    plan_.faces[e_].over_wall = true;
    plan_.faces.push_back({RoofPart::slope, e_, false, {c1, c2, tip_}});
    plan_.borders[e_] = {a_, c1, c2, b_};
    return true;
  }
  // A small gable stands on the hip end.
  bool make_dutch_hip(double clipped) {
    const double inset = std::min(tip().z * (1 - clipped), 0.48 * room());
    WallLine plane = wall();
    plane.c -= inset;
    const auto over = ridge_above(slope(left_), slope(right_), plane);
    const auto p1 = at_distances(slope(left_), inset, wall(), inset);
    const auto p2 = at_distances(wall(), inset, slope(right_), inset);
    if (!over || !p1 || !p2 || !(over->z > inset)) return false;
    const uint32_t c1 = plan_.add_node({p1->x, p1->y, inset});
    const uint32_t c2 = plan_.add_node({p2->x, p2->y, inset});
    set_tip(*over);
    divide(c1, c2);
    plan_.faces.push_back({RoofPart::gable, e_, false, {c1, c2, tip_}});
    return true;
  }

 private:
  const WallLine& wall() const { return plan_.lines[e_]; }
  const WallLine& slope(uint32_t e) const { return plan_.lines[e]; }
  Vec3 corner(uint32_t i) const { return plan_.nodes[i].wall; }
  Vec3 tip() const { return plan_.nodes[tip_].wall; }
  void set_tip(Vec3 p) { plan_.nodes[tip_] = {p, p}; }
  void divide(uint32_t c1, uint32_t c2) {
    plan_.faces[e_].loop = {a_, b_, c2, c1};
    insert_between(plan_.faces[left_].loop, a_, tip_, c1);
    insert_between(plan_.faces[right_].loop, tip_, b_, c2);
  }

  RoofPlan& plan_;
  uint32_t e_, tip_, a_, b_, left_, right_;
};

}  // namespace

std::optional<Vec2> at_distances(const WallLine& one, double s, const WallLine& two, double t) {
  const double determinant = cross(one.normal, two.normal);
  if (std::abs(determinant) < 1e-9) return std::nullopt;
  const double a = s - one.c, b = t - two.c;
  return Vec2{(a * two.normal.y - b * one.normal.y) / determinant,
              (one.normal.x * b - two.normal.x * a) / determinant};
}

std::optional<Vec3> ridge_above(const WallLine& left, const WallLine& right, const WallLine& wall) {
  const Vec2 n = left.normal - right.normal;
  const double determinant = cross(n, wall.normal);
  if (std::abs(determinant) < 1e-9) return std::nullopt;
  const double c1 = right.c - left.c, c2 = -wall.c;
  const Vec2 p{(c1 * wall.normal.y - c2 * n.y) / determinant,
               (n.x * c2 - wall.normal.x * c1) / determinant};
  return Vec3{p.x, p.y, (left.distance(p) + right.distance(p)) / 2};
}

std::vector<RidgeEnd> ridge_ends(SkeletonOn& on, const std::vector<char>& wanted,
                                 std::optional<uint32_t> ridge, double verge) {
  if (std::find(wanted.begin(), wanted.end(), 1) == wanted.end()) return {};
  return on.quad_first ? ends_of_quad(on, wanted, ridge, verge)
                       : triangular_ends(on, wanted, verge);
}

void shape_ends(RoofPlan& plan, const std::vector<RidgeEnd>& ends, double clipped) {
  const std::vector<RoofEnd> asked =
      std::exchange(plan.ends, std::vector<RoofEnd>(plan.edges(), RoofEnd::hip));
  for (const RidgeEnd& end : ends) {
    End(plan, end).to_wall();
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    End end(plan, ends[i]);
    RoofEnd kind = asked[ends[i].edge];
    if (kind == RoofEnd::half_hip && !end.make_half_hip(clipped)) kind = RoofEnd::gable;
    if (kind == RoofEnd::dutch_hip && !end.make_dutch_hip(clipped)) kind = RoofEnd::gable;
    if (kind == RoofEnd::gable) end.make_gable();
    plan.ends[ends[i].edge] = kind;
  }
}

}  // namespace mansard
