// Cross gables: a gable in the middle of a wall, whose two slopes run back into the wall's own.
#include <algorithm>
#include <cmath>

#include "geometry/roof_parts.hpp"
#include "geometry/roof_plan.hpp"

namespace mansard {
namespace {

constexpr double least_height = 0.7;  // of the ridge's; a lower gable looks like a mistake
constexpr double margin = 0.985;      // of the way to where it would meet other faces

// The frame of a wall: s along it, t inwards.
struct WallFrame {
  Vec2 origin, along, inwards;
  Vec2 at(double s, double t) const { return origin + along * s + inwards * t; }
  double s_of(Vec3 p) const { return dot(Vec2{p.x, p.y} - origin, along); }
};

// Half the width of the widest gable around s = middle: its valleys leave the wall at 45 degrees in
// the plan and must stay on the wall's own slope.
double widest(const RoofPlan& plan, const RoofPlan::Face& face, const WallFrame& frame,
              double middle) {
  double half = 1e300;
  const std::size_t n = face.loop.size();
  for (std::size_t i = 1; i < n; ++i) {  // the first edge is the wall itself
    const Vec3 p = plan.nodes[face.loop[i]].wall, q = plan.nodes[face.loop[(i + 1) % n]].wall;
    const double s = frame.s_of(p), next = frame.s_of(q);
    half = std::min(half, p.z + std::abs(s - middle));
    if ((s - middle) * (next - middle) >= 0) continue;
    half = std::min(half, p.z + (q.z - p.z) * (middle - s) / (next - s));
  }
  return half;
}

bool is_convex_at(const RoofPlan& plan, uint32_t corner) {
  return cross(plan.lines[plan.before[corner]].normal, plan.lines[corner].normal) > 0;
}

void add_gable(RoofPlan& plan, uint32_t e, const WallFrame& frame, double middle, double half,
               double overhang, double verge) {
  const auto at = [&](double s, double t, double height) {
    const Vec2 p = frame.at(s, t);
    return Vec3{p.x, p.y, height};
  };
  const uint32_t left = plan.add_node(at(middle - half, 0, 0));
  const uint32_t right = plan.add_node(at(middle + half, 0, 0));
  const uint32_t tip = plan.add_node(at(middle, 0, half));
  const uint32_t end = plan.add_node(at(middle, half, half));
  plan.nodes[left].outer = at(middle - half - overhang, -overhang, -overhang);
  plan.nodes[right].outer = at(middle + half + overhang, -overhang, -overhang);
  plan.nodes[tip].outer = at(middle, -verge, half);
  std::vector<uint32_t>& loop = plan.faces[e].loop;
  loop.insert(loop.begin() + 1, {left, end, right});
  plan.faces.push_back({RoofPart::gable, e, true, {left, right, tip}});
  plan.faces.push_back({RoofPart::slope, e, false, {left, tip, end}});
  plan.faces.push_back({RoofPart::slope, e, false, {right, end, tip}});
  std::vector<uint32_t>& border = plan.borders[e];
  border.insert(border.begin() + 1, {left, tip, right});
}

}  // namespace

void add_wall_gables(RoofPlan& plan, const RoofOptions& options) {
  const double least = std::max(1.0, least_height * plan.highest());
  for (uint32_t e = 0; e < plan.footprint->ring_ends[0]; ++e) {
    const EdgeTag tag = plan.footprint->tags[e];
    if (plan.ends[e] != RoofEnd::hip || tag.has(EdgeTag::party)) continue;
    if (!is_convex_at(plan, e) || !is_convex_at(plan, plan.next[e])) continue;
    const std::vector<uint32_t>& border = plan.borders[e];
    const RoofPlan::Node a = plan.nodes[border.front()], b = plan.nodes[border.back()];
    const Vec2 from{a.wall.x, a.wall.y}, to{b.wall.x, b.wall.y};
    const WallFrame frame{from, normalized(to - from), plan.lines[e].normal};
    const double wide = length(to - from), middle = wide / 2;
    const double overhang = -std::max(a.outer.z, b.outer.z);
    const double left = middle - overhang - std::max(frame.s_of(a.outer), 0.0);
    const double right = std::min(frame.s_of(b.outer), wide) - overhang - middle;
    const double half =
        margin * std::min({left, right, widest(plan, plan.faces[e], frame, middle)});
    if (half < least) continue;
    add_gable(plan, e, frame, middle, half, overhang, verge_of(options));
  }
}

}  // namespace mansard
