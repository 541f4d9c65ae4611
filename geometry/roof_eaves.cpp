// The overhang: outer nodes, on the planes of the slopes beyond the walls.
#include <algorithm>

#include "geometry/roof_parts.hpp"
#include "geometry/roof_plan.hpp"

namespace mansard {
namespace {

bool over_gable(const RoofPlan& plan, uint32_t e) {
  return plan.ends[e] == RoofEnd::gable || plan.ends[e] == RoofEnd::half_hip;
}

// How far the roof goes beyond each wall; not at all where a neighbour stands.
std::vector<double> reaches(const RoofPlan& plan, const RoofOptions& options) {
  std::vector<double> reach(plan.edges());
  for (uint32_t e = 0; e < plan.edges(); ++e) {
    const double out = over_gable(plan, e) ? verge_of(options) : options.overhang;
    reach[e] = plan.footprint->tags[e].has(EdgeTag::party) ? 0 : out;
  }
  return reach;
}

// The point on a slope's plane where the leaning top of a half hip has its eave.
void move_half_hip(RoofPlan& plan, uint32_t e, double by) {
  const std::vector<uint32_t>& border = plan.borders[e];
  const WallLine& wall = plan.lines[e];
  const auto move = [&](uint32_t node, const WallLine& slope) {
    const Vec3 p = plan.nodes[node].wall;
    const auto eave = at_distances(wall, -by, slope, p.z - by);
    if (eave) plan.nodes[node].outer = {eave->x, eave->y, p.z - by};
  };
  move(border[1], plan.lines[plan.before[e]]);
  move(border[2], plan.lines[plan.next[e]]);
}

// A corner between two slopes of which one does not stand out. The slopes part at the wall's own
// corner: from there the other's end runs down in the plane of the wall that stays.
void part_corner(RoofPlan& plan, uint32_t corner, const std::vector<double>& reach, Vec2 outer) {
  const uint32_t before = plan.before[corner];
  const bool stays_before = reach[before] == 0;
  const uint32_t out = stays_before ? corner : before, stays = stays_before ? before : corner;
  const uint32_t foot = plan.add_node(plan.nodes[corner].wall);
  plan.nodes[foot].outer = {outer.x, outer.y, plan.lines[out].distance(outer)};
  std::vector<uint32_t>&loop = plan.faces[out].loop, &border = plan.borders[out];
  std::vector<uint32_t>& flush = plan.borders[stays];
  if (stays_before) {
    loop[0] = border.front() = foot;
    loop.push_back(corner);
    flush.push_back(foot);
  } else {
    loop.insert(loop.begin() + 1, foot);
    border.back() = foot;
    flush.insert(flush.begin(), foot);
  }
}

}  // namespace

void move_eaves(RoofPlan& plan, const RoofOptions& options) {
  const std::vector<double> reach = reaches(plan, options);
  const MovedOutline outline = move_outline(*plan.footprint, reach);
  for (uint32_t i = 0; i < plan.edges(); ++i) {
    if (outline.shares[i] == 0) continue;
    const Vec2 p = outline.points[i];
    const uint32_t before = plan.before[i];
    const bool hip = !over_gable(plan, i) && !over_gable(plan, before);
    if (hip && (reach[i] == 0) != (reach[before] == 0)) {
      part_corner(plan, i, reach, p);
      continue;
    }
    const uint32_t slope = over_gable(plan, i) ? plan.before[i] : i;
    plan.nodes[i].outer = {p.x, p.y, plan.lines[slope].distance(p)};
  }
  for (uint32_t e = 0; e < plan.edges(); ++e) {
    if (!over_gable(plan, e) || reach[e] == 0) continue;
    const double by = reach[e] * std::min(outline.shares[e], outline.shares[plan.next[e]]);
    if (plan.ends[e] == RoofEnd::half_hip) {
      move_half_hip(plan, e, by);
      continue;
    }
    WallLine plane = plan.lines[e];
    plane.c += by;
    const auto tip = ridge_above(plan.lines[plan.before[e]], plan.lines[plan.next[e]], plane);
    if (tip) plan.nodes[plan.borders[e][1]].outer = *tip;
  }
}

}  // namespace mansard
