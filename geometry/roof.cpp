#include "geometry/roof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/roof_parts.hpp"

namespace mansard {
namespace {

// Slopes over a skeleton, whose gables have been made: up = inset distance times `rise`. The eaves
// are moved outwards along the slopes' planes, so overhangs need no skeleton of their own.
class SlopedRoof {
 public:
  SlopedRoof(const SkeletonOn& on, const std::vector<char>& gable, const RoofOptions& options)
      : on_(on), gable_(gable), lines_(wall_lines(on.polygon)), next_(on.polygon.points.size()) {
    const Polygon& polygon = on.polygon;
    before_.resize(next_.size());
    for (std::size_t r = 0; r < polygon.rings(); ++r) {
      const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
      for (uint32_t i = begin; i < end; ++i) {
        next_[i] = i + 1 == end ? begin : i + 1;
        before_[next_[i]] = i;
      }
    }
    double highest = 0;
    for (const Vec3 node : on.mesh.nodes) highest = std::max(highest, node.z);
    constexpr double degree = std::numbers::pi / 180;
    rise_ = options.height > 0 ? options.height / highest : std::tan(options.pitch * degree);
    rise_ = std::clamp(rise_, std::tan(0.01 * degree), std::tan(89 * degree));
    outer_ = on.mesh.nodes;
    if (options.overhang > 0) move_eaves(options);
    for (Vec3& p : outer_) p.z *= rise_;
  }

  Roof build(bool overhang) const {
    Roof roof;
    roof.fallback = on_.fallback;
    for (const uint32_t e : edges_in_original_order()) {
      if (gable_[e]) {
        add_face(roof, RoofPart::gable, tag(e), std::array{wall(e), wall(next_[e]), tip(e)});
      } else {
        std::vector<Vec3> loop;
        for (const uint32_t i : on_.mesh.face(e)) loop.push_back(outer_[i]);
        add_face(roof, RoofPart::slope, tag(e), loop);
      }
      if (overhang) add_eaves(roof, e);
    }
    return roof;
  }

 private:
  EdgeTag tag(uint32_t e) const { return on_.polygon.tags[e]; }
  Vec3 wall(uint32_t i) const { return on_.mesh.nodes[i]; }
  uint32_t tip_node(uint32_t e) const { return on_.mesh.face(e)[2]; }
  Vec3 tip(uint32_t e) const {
    const Vec3 node = on_.mesh.nodes[tip_node(e)];
    return {node.x, node.y, node.z * rise_};
  }
  // A gable towards a neighbour ends flush, since the neighbour stands there.
  bool flush(uint32_t e) const { return gable_[e] && tag(e).has(EdgeTag::party); }

  std::vector<uint32_t> edges_in_original_order() const {
    std::vector<uint32_t> order(on_.mesh.faces());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](uint32_t a, uint32_t b) { return on_.edges[a] < on_.edges[b]; });
    return order;
  }

  // Corners move along their slopes' planes (up still in units of the inset distance) and gables'
  // tips along their ridges. The fascia gets lower where a corner moves only a share of its way, so
  // that soffits stay planar.
  void move_eaves(const RoofOptions& options) {
    const std::size_t n = on_.polygon.points.size();
    std::vector<double> reach(n, options.overhang);
    for (uint32_t e = 0; e < n; ++e) {
      if (flush(e)) reach[e] = 0;
    }
    const MovedOutline outline = move_outline(on_.polygon, reach);
    fascia_.assign(outer_.size(), 0);
    const double thickness = std::max(options.thickness, 0.0);
    for (uint32_t i = 0; i < n; ++i) {
      if (outline.shares[i] == 0) continue;
      const Vec2 p = outline.points[i];
      const uint32_t slope = gable_[i] ? before_[i] : i;
      outer_[i] = {p.x, p.y, lines_[slope].distance(p)};
      fascia_[i] = thickness * outline.shares[i];
    }
    for (uint32_t e = 0; e < n; ++e) {
      if (!gable_[e] || flush(e)) continue;
      const double share = std::min(outline.shares[e], outline.shares[next_[e]]);
      WallLine plane = lines_[e];
      plane.c += share * options.overhang;
      const auto p = ridge_above(lines_[before_[e]], lines_[next_[e]], plane);
      if (!p) continue;
      outer_[tip_node(e)] = *p;
      fascia_[tip_node(e)] = thickness * share;
    }
  }

  Vec3 lower(uint32_t i) const { return outer_[i] - Vec3{0, 0, fascia_[i]}; }

  // Fascia and soffit between two points of the wall's top and the nodes outside of them.
  void add_strip(Roof& roof, uint32_t e, uint32_t a, uint32_t b, Vec3 wall_a, Vec3 wall_b) const {
    add_face(roof, RoofPart::soffit, tag(e), std::array{lower(b), lower(a), wall_a, wall_b});
    add_face(roof, RoofPart::fascia, tag(e), std::array{lower(a), lower(b), outer_[b], outer_[a]});
  }

  void add_eaves(Roof& roof, uint32_t e) const {
    const uint32_t a = e, b = next_[e];
    if (flush(e)) {  // only the ends of the neighbouring eaves show
      add_face(roof, RoofPart::fascia, tag(e), std::array{lower(a), wall(a), outer_[a]});
      add_face(roof, RoofPart::fascia, tag(e), std::array{lower(b), outer_[b], wall(b)});
    } else if (gable_[e]) {
      add_strip(roof, e, a, tip_node(e), wall(a), tip(e));
      add_strip(roof, e, tip_node(e), b, tip(e), wall(b));
    } else {
      add_strip(roof, e, a, b, wall(a), wall(b));
    }
  }

  const SkeletonOn& on_;
  const std::vector<char>& gable_;
  std::vector<WallLine> lines_;
  std::vector<uint32_t> next_, before_;
  double rise_ = 1;
  std::vector<Vec3> outer_;     // the nodes as the slopes have them
  std::vector<double> fascia_;  // its height at each of them
};

}  // namespace

void add_face(Roof& roof, RoofPart part, EdgeTag tag, std::span<const Vec3> loop) {
  RoofFace face{part, tag, {}, {}};
  face.loop.reserve(loop.size());
  for (const Vec3 p : loop) {
    if (face.loop.empty() || face.loop.back() != p) face.loop.push_back(p);
  }
  while (face.loop.size() > 1 && face.loop.front() == face.loop.back()) face.loop.pop_back();
  if (face.loop.size() >= 3) roof.faces.push_back(std::move(face));
}

Roof roof(const Polygon& polygon, const RoofOptions& options) {
  if (options.kind == RoofKind::flat) return flat_roof(polygon, options);
  std::optional<SkeletonOn> on = best_skeleton(polygon);
  if (!on) {
    Roof flat = flat_roof(polygon, options);
    flat.fallback = 6;
    return flat;
  }
  std::vector<char> gable(on->polygon.points.size(), 0);
  if (options.kind == RoofKind::gable) {
    gable = make_gables(
        *on, [&](uint32_t e) { return !options.gables || (*options.gables)[on->edges[e]] != 0; });
  }
  return SlopedRoof(*on, gable, options).build(options.overhang > 0);
}

}  // namespace mansard
