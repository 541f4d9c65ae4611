// Flat roofs: a plain top, a slab that overhangs, a parapet.
#include <cmath>

#include "geometry/clean.hpp"
#include "geometry/roof_parts.hpp"

namespace mansard {
namespace {

constexpr Vec3 at(Vec2 p, double up) { return {p.x, p.y, up}; }

void add_top(Roof& roof, const Polygon& polygon, double up) {
  RoofFace top{RoofPart::top, polygon.tags[0], {}, {}, {}};
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    std::vector<Vec3> ring;
    std::vector<EdgeTag> tags;
    for (uint32_t i = polygon.ring_begin(r); i < polygon.ring_ends[r]; ++i) {
      const Vec3 p = at(polygon.points[i], up);
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
      if (ring.empty() || ring.back() != p) {
        ring.push_back(p);
        tags.push_back(polygon.tags[i]);
      } else {
        tags.back() = polygon.tags[i];  // the edge before it has no length
      }
    }
    const bool flat = ring.size() < 3 || !(std::abs(area(polygon.ring(r))) > 1e-9);
    if (r == 0 && flat) return;
    if (r > 0 && flat) continue;
    (r == 0 ? top.loop : top.holes.emplace_back()) = std::move(ring);
    top.edges.insert(top.edges.end(), tags.begin(), tags.end());
  }
  roof.faces.push_back(std::move(top));
}

// A vertical band over the edge a-b, seen from its right side.
void add_band(Roof& roof, RoofPart part, EdgeTag tag, Vec2 a, Vec2 b, double low, double high) {
  add_face(roof, part, tag, std::array{at(a, low), at(b, low), at(b, high), at(a, high)});
}

// The slab's underside and edge; what stands on it gets its outline and height.
double add_slab(Roof& roof, Polygon& polygon, const RoofOptions& options) {
  std::vector<double> reach(polygon.points.size(), options.overhang);
  for (std::size_t e = 0; e < reach.size(); ++e) {
    if (polygon.tags[e].has(EdgeTag::party)) reach[e] = 0;
  }
  const MovedOutline outer = move_outline(polygon, reach);
  Polygon slab = polygon;
  slab.points = outer.points;
  const double thickness = std::max(options.thickness, 0.0);
  const std::vector<Vec2> walls = polygon.points;
  for (std::size_t r = 0; r < slab.rings(); ++r) {
    const uint32_t begin = slab.ring_begin(r), end = slab.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t next = i + 1 == end ? begin : i + 1;
      const Vec2 a = slab.points[i], b = slab.points[next];
      if (reach[i] == 0) {
        add_face(roof, RoofPart::fascia, slab.tags[i],
                 std::array{at(a, 0), at(walls[i], 0), at(walls[next], 0), at(b, 0),
                            at(b, thickness), at(a, thickness)});
        continue;
      }
      add_face(roof, RoofPart::soffit, slab.tags[i],
               std::array{at(b, 0), at(a, 0), at(walls[i], 0), at(walls[next], 0)});
      add_band(roof, RoofPart::fascia, slab.tags[i], a, b, 0, thickness);
    }
  }
  polygon = std::move(slab);
  return thickness;
}

// Outer side, cap and inner side all round; what remains inside is the top.
void add_parapet(Roof& roof, Polygon& polygon, double foot, const RoofOptions& options) {
  const std::size_t n = polygon.points.size();
  const MovedOutline inner = move_outline(polygon, std::vector<double>(n, -options.parapet_width));
  const double high = foot + options.parapet;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t next = i + 1 == end ? begin : i + 1;
      const Vec2 a = polygon.points[i], b = polygon.points[next];
      const Vec2 c = inner.points[next], d = inner.points[i];
      add_band(roof, RoofPart::parapet, polygon.tags[i], a, b, foot, high);
      add_face(roof, RoofPart::parapet, polygon.tags[i],
               std::array{at(a, high), at(b, high), at(c, high), at(d, high)});
      add_band(roof, RoofPart::parapet, polygon.tags[i], c, d, foot, high);
    }
  }
  polygon.points = inner.points;
}

}  // namespace

Roof flat_roof(const Polygon& polygon, const RoofOptions& options) {
  Roof roof;
  if (polygon.empty() || polygon.rings() == 0) return roof;
  const bool slab = options.overhang > 0, parapet = options.parapet > 0;
  std::optional<Cleaned> cleaned;
  if (slab || parapet) cleaned = clean(polygon, {});
  if (cleaned && cleaned->moved) roof.fallback = 2;
  Polygon outline = cleaned ? cleaned->polygon : polygon;
  double up = 0;
  if (cleaned && slab) up = add_slab(roof, outline, options);
  if (cleaned && parapet) add_parapet(roof, outline, up, options);
  add_top(roof, outline, up);
  return roof;
}

}  // namespace mansard
