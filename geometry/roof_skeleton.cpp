// Roofs over the straight skeleton: from options to a plan, its heights and its faces.
#include <algorithm>
#include <cmath>

#include "geometry/roof_parts.hpp"
#include "geometry/roof_plan.hpp"

namespace mansard {
namespace {

RoofEnd own_end(RoofKind kind, bool gables_given) {
  switch (kind) {
    case RoofKind::gable:
    case RoofKind::gambrel:
    case RoofKind::cross_gable:
      return gables_given ? RoofEnd::hip : RoofEnd::gable;
    case RoofKind::half_hip:
      return RoofEnd::half_hip;
    case RoofKind::dutch_hip:
      return RoofEnd::dutch_hip;
    default:
      return RoofEnd::hip;
  }
}

std::vector<RoofEnd> wanted_ends(const SkeletonOn& on, const RoofOptions& options) {
  const RoofEnd own = own_end(options.kind, options.gables.has_value());
  std::vector<RoofEnd> ends(on.polygon.points.size(), own);
  for (std::size_t e = 0; e < ends.size(); ++e) {
    if (options.gables && (*options.gables)[on.edges[e]]) ends[e] = RoofEnd::gable;
    if (options.hips && (*options.hips)[on.edges[e]]) ends[e] = RoofEnd::hip;
  }
  return ends;
}

// The edge of the cleaned polygon that an edge of the original became.
std::optional<uint32_t> ridge_edge(const SkeletonOn& on, const RoofOptions& options) {
  if (!options.ridge || *options.ridge >= on.edge_of.size()) return std::nullopt;
  const uint32_t edge = on.edge_of[*options.ridge];
  return edge < on.polygon.points.size() ? std::optional(edge) : std::nullopt;
}

RoofPlan plan_with_ends(SkeletonOn& on, const RoofOptions& options) {
  const std::vector<RoofEnd> wanted = wanted_ends(on, options);
  std::vector<char> changed(wanted.size());
  for (std::size_t e = 0; e < wanted.size(); ++e) changed[e] = wanted[e] != RoofEnd::hip;
  const std::vector<RidgeEnd> ends =
      ridge_ends(on, changed, ridge_edge(on, options), verge_of(options));
  RoofPlan plan = plan_roof(on);
  close_slits(plan);
  plan.ends = wanted;
  shape_ends(plan, ends, std::clamp(options.clipped, 0.05, 0.95));
  return plan;
}

// The centre of the area, where it lies well inside of every wall.
std::optional<Vec2> apex_of(const Polygon& polygon, const std::vector<WallLine>& lines) {
  if (polygon.rings() != 1) return std::nullopt;
  const Vec2 o = polygon.points[0];
  Vec2 sum;
  double twice = 0;
  for_each_edge(polygon, [&](uint32_t, Vec2 a, Vec2 b) {
    const double part = cross(a - o, b - o);
    twice += part;
    sum = sum + (a + b - o - o) * (part / 3);
  });
  const Vec2 apex = o + sum * (1 / twice);
  const double least = twice / 2 / perimeter(polygon);  // half of a square's
  for (const WallLine& line : lines) {
    if (line.distance(apex) < least) return std::nullopt;
  }
  return apex;
}

// All faces meet in one point, which has t = 1; the walls' tops have 0. The eaves keep parallel to
// the walls when the outline grows from the apex.
std::optional<RoofPlan> plan_pyramid(SkeletonOn& on, const RoofOptions& options, double& high) {
  const std::vector<WallLine> lines = wall_lines(on.polygon);
  const auto apex = apex_of(on.polygon, lines);
  if (!apex) return std::nullopt;
  const auto n = static_cast<uint32_t>(lines.size());
  on.mesh.nodes.resize(n);
  on.mesh.nodes.push_back({apex->x, apex->y, 1});
  on.mesh.corners.clear();
  on.mesh.face_ends.clear();
  for (uint32_t e = 0; e < n; ++e) {
    on.mesh.corners.insert(on.mesh.corners.end(), {e, (e + 1) % n, n});
    on.mesh.face_ends.push_back(3 * (e + 1));
  }
  RoofPlan plan = plan_roof(on);
  double longest = 0, nearest = 1e300;
  for_each_edge(on.polygon, [&](uint32_t e, Vec2 a, Vec2 b) {
    const double distance = lines[e].distance(*apex);
    nearest = std::min(nearest, distance);
    if (length(b - a) < longest + 1e-6) return;
    longest = length(b - a);
    high = distance;  // the longest wall's slope has the pitch
  });
  const double out = has_party_wall(on.polygon) ? 0 : std::min(options.overhang, nearest) / nearest;
  for (uint32_t i = 0; i < n && out > 0; ++i) {
    const Vec2 p = *apex + (on.polygon.points[i] - *apex) * (1 + out);
    plan.nodes[i].outer = {p.x, p.y, -out};
  }
  return plan;
}

bool has_two_slopes(RoofKind kind) {
  return kind == RoofKind::mansard || kind == RoofKind::gambrel;
}

// Metres inside the walls where the upper slopes begin.
double bend_of(const RoofOptions& options, double rise, double highest) {
  if (options.break_inset > 0) return options.break_inset;
  if (options.break_height > 0) return options.break_height / rise;
  const double share = 0.4 * highest;
  if (options.kind == RoofKind::gambrel) return share;
  constexpr double storey = 2.6;  // a mansard is as high as its rooms
  return std::min(share, storey / rise);
}

// Heights: by the pitch, or by the height less the thickness of the roof's edge.
RoofProfile profile_of(Roof& roof, const RoofOptions& options, double highest, double thickness) {
  RoofProfile profile;
  profile.rise = profile.upper_rise = rise_of(pitch_of(options));
  profile.level_eaves = pitch_of(options) > steep_eaves;
  if (has_two_slopes(options.kind)) {
    const double own = options.kind == RoofKind::mansard ? 25 : 30;
    profile.upper_rise = rise_of(options.upper_pitch > 0 ? options.upper_pitch : own);
    profile.bend = bend_of(options, profile.rise, highest);
    roof.no_break = profile.bend > 0.98 * highest;
    if (roof.no_break) profile.bend = 1e300;
  }
  if (options.height <= 0) return profile;
  roof.low = thickness > 0 && thickness < options.thickness;
  const double scale = (options.height - thickness) / profile(highest);
  profile.rise *= scale;
  profile.upper_rise *= scale;
  profile.level_eaves = profile.rise > rise_of(steep_eaves);
  return profile;
}

}  // namespace

std::optional<Roof> skeleton_roof(const Polygon& polygon, const RoofOptions& options) {
  std::optional<SkeletonOn> on = best_skeleton(polygon);
  if (!on) return std::nullopt;
  Roof roof;
  roof.fallback = on->fallback;
  double scale = 1;  // metres inwards that t = 1 stands for
  std::optional<RoofPlan> plan;
  if (options.kind == RoofKind::pyramid) {
    plan = plan_pyramid(*on, options, scale);
    roof.no_apex = !plan;
  }
  const bool pyramid = plan.has_value();
  if (!plan) plan = plan_with_ends(*on, options);
  const double thickness = thickness_of(options);
  if (!pyramid && options.overhang > 0) move_eaves(*plan, options);
  if (options.kind == RoofKind::cross_gable) add_wall_gables(*plan, options);
  RoofProfile profile = profile_of(roof, options, plan->highest() * scale, thickness);
  profile.rise *= scale;
  if (profile.level_eaves && options.overhang > 0) {
    cut_at_level(*plan, 0, RoofPart::fascia, RoofPart::slope);
  }
  if (profile.bend < 1e300) {
    profile.bend = cut_at_level(*plan, profile.bend, RoofPart::lower, RoofPart::upper);
  }
  emit_faces(roof, *plan, *on, polygon, profile, thickness);
  return roof;
}

}  // namespace mansard
