// From the plan of a roof to its faces.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/clean.hpp"
#include "geometry/mesh.hpp"
#include "geometry/roof_parts.hpp"
#include "geometry/roof_plan.hpp"

namespace mansard {
namespace {

constexpr double on_the_line = 2e-5;  // metres: what cleaning drops without being seen

// The walls as they stand: cleaning may have dropped points of their tops, or moved them.
class WallTops {
 public:
  WallTops(const RoofPlan& plan, const SkeletonOn& on, const Polygon& original)
      : plan_(plan), on_(on), original_(original) {}

  /// Calls f for all points of the wall's top on edge e, but those of spikes.
  template <class F>
  void for_each_point(uint32_t e, F f) const {
    const uint32_t first = on_.points[e], last = on_.points[plan_.next[e]];
    std::size_t r = 0;
    while (original_.ring_ends[r] <= first) ++r;
    const uint32_t begin = original_.ring_begin(r), end = original_.ring_ends[r];
    f(original_.points[first]);
    for (uint32_t i = first, steps = begin; steps < end; ++steps) {
      const bool spike = on_.edge_of[i] == Cleaned::no_edge;
      i = i + 1 == end ? begin : i + 1;
      if (i == last) break;
      if (!spike && on_.edge_of[i] != Cleaned::no_edge) f(original_.points[i]);
    }
    f(original_.points[last]);
  }
  /// Those between two places on the edge, as far as the roof can take them in.
  std::vector<Vec3> between(uint32_t e, Vec3 from, Vec3 to) const {
    std::vector<Vec3> points;
    const Vec2 along = left_of(plan_.lines[e].normal) * -1;
    const double end = dot(along, Vec2{to.x, to.y});
    double last = dot(along, Vec2{from.x, from.y});
    for_each_point(e, [&](Vec2 p) {
      const double s = dot(along, p);
      const bool corner = (p.x == from.x && p.y == from.y) || (p.x == to.x && p.y == to.y);
      if (corner || s <= last || s >= end) return;
      if (std::abs(plan_.lines[e].distance(p)) > on_the_line) return;
      points.push_back({p.x, p.y, 0});
      last = s;
    });
    return points;
  }

 private:
  const RoofPlan& plan_;
  const SkeletonOn& on_;
  const Polygon& original_;
};

class Emitter {
 public:
  Emitter(Roof& roof, const RoofPlan& plan, const SkeletonOn& on, const Polygon& original,
          const RoofProfile& profile, double thickness)
      : roof_(roof),
        plan_(plan),
        tops_(plan, on, original),
        profile_(profile),
        thickness_(thickness) {
    std::vector<uint32_t> order(plan.faces.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto edge = [&](uint32_t f) { return on.edges[plan.faces[f].edge]; };
    std::stable_sort(order.begin(), order.end(),
                     [&](uint32_t a, uint32_t b) { return edge(a) < edge(b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
      add(plan.faces[order[i]]);
      if (i + 1 < order.size() && edge(order[i]) == edge(order[i + 1])) continue;
      const uint32_t e = plan.faces[order[i]].edge;
      if (thickness_ > 0) add_edges(e);
      if (on.fallback > 1) add_ledge(e);
    }
  }

 private:
  EdgeTag tag(uint32_t e) const { return plan_.footprint->tags[e]; }
  Vec3 wall(uint32_t i) const {
    const Vec3 p = plan_.nodes[i].wall;
    return {p.x, p.y, profile_(p.z)};
  }
  Vec3 lower(uint32_t i) const {
    const Vec3 p = plan_.nodes[i].outer;
    return {p.x, p.y, profile_(p.z)};
  }
  Vec3 upper(uint32_t i) const { return lower(i) + Vec3{0, 0, thickness_}; }

  // Whether the border of edge e goes from a to b along the wall's top.
  bool along_wall(uint32_t e, uint32_t a, uint32_t b) const {
    const auto& border = plan_.borders[e];
    const auto at = std::find(border.begin(), border.end(), a);
    return at != border.end() && at + 1 != border.end() && *(at + 1) == b &&
           plan_.nodes[a].wall.z == 0 && plan_.nodes[b].wall.z == 0;
  }

  void add_top(std::vector<Vec3>& loop, uint32_t e, Vec3 from, Vec3 to) const {
    for (const Vec3 p : tops_.between(e, from, to)) loop.push_back(p);
  }

  void add(const RoofPlan::Face& face) {
    std::vector<Vec3> loop;
    const uint32_t e = face.edge;
    for (std::size_t i = 0; i < face.loop.size(); ++i) {
      const uint32_t a = face.loop[i], b = face.loop[(i + 1) % face.loop.size()];
      loop.push_back(face.over_wall ? wall(a) : upper(a));
      const bool low = plan_.nodes[a].wall.z == 0 && plan_.nodes[b].wall.z == 0;
      const bool foot = face.over_wall ? low : thickness_ == 0 && along_wall(e, a, b);
      if (foot) add_top(loop, e, wall(a), wall(b));
    }
    add_face(roof_, face.part, tag(e), loop);
  }

  // Soffit and fascia along the border of an edge.
  void add_edges(uint32_t e) {
    const std::vector<uint32_t>& border = plan_.borders[e];
    for (std::size_t i = 0; i + 1 < border.size(); ++i) {
      const uint32_t a = border[i], b = border[i + 1];
      const Vec2 reach{lower(b).x - wall(b).x, lower(b).y - wall(b).y};
      const Vec2 reach_a{lower(a).x - wall(a).x, lower(a).y - wall(a).y};
      const Vec2 inwards = plan_.lines[e].normal;
      const bool flush = std::abs(dot(reach, inwards)) + std::abs(dot(reach_a, inwards)) < 1e-9;
      if (flush) {
        std::vector<Vec3> fascia{lower(a), wall(a)};
        if (along_wall(e, a, b)) add_top(fascia, e, wall(a), wall(b));
        for (const Vec3 p : {wall(b), lower(b), upper(b), upper(a)}) fascia.push_back(p);
        add_face(roof_, RoofPart::fascia, tag(e), fascia);
        continue;
      }
      std::vector<Vec3> soffit{lower(b), lower(a), wall(a)};
      if (along_wall(e, a, b)) add_top(soffit, e, wall(a), wall(b));
      soffit.push_back(wall(b));
      add_face(roof_, RoofPart::soffit, tag(e), soffit);
      add_face(roof_, RoofPart::fascia, tag(e), std::array{lower(a), lower(b), upper(b), upper(a)});
    }
  }

  // Where cleaning moved the wall's top by more than a hair: the level strips between where it
  // stands and the roof.
  void add_ledge(uint32_t e) {
    const Vec3 begin = wall(e), end = wall(plan_.next[e]);
    std::vector<Vec3> outer, inner = tops_.between(e, begin, end);
    inner.insert(inner.begin(), begin);
    inner.push_back(end);
    std::size_t k = 0;
    tops_.for_each_point(e, [&](Vec2 p) {
      outer.push_back({p.x, p.y, 0});
      if (k + 2 >= inner.size() || outer.back() != inner[k + 1]) return;
      add_level(e, outer, {inner[k], inner[k + 1]});
      outer = {inner[++k]};
    });
    add_level(e, outer, {inner[k], inner[k + 1]});
  }
  // A strip that changes sides is two triangles.
  void add_level(uint32_t e, std::vector<Vec3> outer, std::array<Vec3, 2> inner) {
    const Vec2 n = plan_.lines[e].normal;
    const auto side = [&](Vec3 p, Vec3 q) { return dot(n, Vec2{p.x - q.x, p.y - q.y}); };
    if (side(outer.front(), inner[0]) * side(outer.back(), inner[1]) < 0) {
      add_flat(e, std::array{outer.front(), outer.back(), inner[1]});
      add_flat(e, std::array{outer.front(), inner[1], inner[0]});
      if (outer.size() > 2) add_flat(e, outer);
      return;
    }
    outer.push_back(inner[1]);
    outer.push_back(inner[0]);
    add_flat(e, outer);
  }
  void add_flat(uint32_t e, std::span<const Vec3> loop) {
    const double twice = newell(loop).z;
    if (twice == 0) return;
    add_face(roof_, twice > 0 ? RoofPart::slope : RoofPart::soffit, tag(e), loop);
  }

  Roof& roof_;
  const RoofPlan& plan_;
  WallTops tops_;
  const RoofProfile& profile_;
  double thickness_;
};

}  // namespace

void emit_faces(Roof& roof, const RoofPlan& plan, const SkeletonOn& on, const Polygon& original,
                const RoofProfile& profile, double thickness) {
  Emitter(roof, plan, on, original, profile, thickness);
}

}  // namespace mansard
