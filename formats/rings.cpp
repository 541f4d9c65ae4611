#include "formats/rings.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/repair.hpp"

namespace mansard {
namespace {

constexpr double same_point = 1e-6;  ///< metres
constexpr double least_area = 1e-6;  ///< square metres

bool is_same(Vec2 a, Vec2 b) {
  return std::abs(a.x - b.x) <= same_point && std::abs(a.y - b.y) <= same_point;
}

struct Findings {
  bool open = false, repeated = false, lost_hole = false;
};

/// Without its closing point and without repeated ones.
RawRing cleaned(const RawRing& raw, bool closed, Findings& findings) {
  RawRing ring;
  const bool is_closed = raw.size() > 1 && is_same(raw.front(), raw.back());
  if (closed && !is_closed) findings.open = true;
  const std::size_t count = raw.size() - (is_closed ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (ring.empty() || !is_same(ring.back(), raw[i])) ring.push_back(raw[i]);
  }
  while (ring.size() > 1 && is_same(ring.front(), ring.back())) ring.pop_back();
  if (ring.size() < count) findings.repeated = true;
  return ring;
}

Polygon to_polygon(const RawPolygon& rings) {
  Polygon polygon;
  for (const RawRing& ring : rings) {
    for (Vec2 p : ring) {
      const auto wall = std::min<std::size_t>(polygon.points.size(), EdgeTag::no_wall - 1);
      polygon.add_point(p, {0, static_cast<uint16_t>(wall)});
    }
    polygon.close_ring();
  }
  orient(polygon);
  for (std::size_t i = 0; i < polygon.tags.size(); ++i) {
    polygon.tags[i].wall = static_cast<uint16_t>(std::min<std::size_t>(i, EdgeTag::no_wall - 1));
  }
  return polygon;
}

}  // namespace

CleanedRings clean_rings(const RawPolygon& raw, bool closed) {
  CleanedRings result;
  Findings findings;
  RawPolygon rings;
  for (const RawRing& ring : raw) {
    for (Vec2 p : ring) {
      if (!std::isfinite(p.x + p.y)) return {{}, {"has a coordinate that is not a number"}};
    }
    RawRing good = cleaned(ring, closed, findings);
    const bool is_outline = &ring == &raw.front();
    if (good.size() < 3 && is_outline) return {{}, {"has fewer than three corners"}};
    if (good.size() < 3) {
      findings.lost_hole = true;
    } else {
      rings.push_back(std::move(good));
    }
  }
  if (rings.empty()) return {{}, {"is empty"}};
  if (findings.open) result.notes.emplace_back("open ring closed");
  if (findings.repeated) result.notes.emplace_back("repeated points removed");
  if (findings.lost_hole) result.notes.emplace_back("court without an area filled");

  RepairedRings repaired = repair(rings);
  if (repaired.was_valid) repaired.pieces.push_back(std::move(rings));
  for (const RawPolygon& piece : repaired.pieces) {
    Polygon polygon = to_polygon(piece);
    if (area(polygon) >= least_area) result.polygons.push_back(std::move(polygon));
  }
  if (repaired.scribble) return {{}, {"crosses itself more than 1,000 times"}};
  if (result.polygons.empty()) return {{}, {"has no area"}};
  if (!repaired.was_valid) result.notes.emplace_back("self-crossing ring repaired");
  return result;
}

}  // namespace mansard
