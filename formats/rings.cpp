#include "formats/rings.hpp"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace mansard {
namespace {

constexpr double same_point = 1e-6;   ///< metres
constexpr double least_area = 1e-6;   ///< square metres
constexpr double least_piece = 1e-2;  ///< square metres: repairs may break off crumbs

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

// GEOS, with every handle owned.

struct Context {
  GEOSContextHandle_t handle = GEOS_init_r();
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { GEOS_finish_r(handle); }
};

struct Destroy {
  GEOSContextHandle_t handle;
  void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(handle, g); }
};
using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;

GEOSGeometry* linear_ring(GEOSContextHandle_t geos, const RawRing& ring) {
  const auto size = static_cast<unsigned>(ring.size());
  GEOSCoordSequence* points = GEOSCoordSeq_create_r(geos, size + 1, 2);
  for (unsigned i = 0; i <= size; ++i) {
    GEOSCoordSeq_setXY_r(geos, points, i, ring[i % size].x, ring[i % size].y);
  }
  return GEOSGeom_createLinearRing_r(geos, points);
}

Geometry to_geos(GEOSContextHandle_t geos, const RawPolygon& rings) {
  GEOSGeometry* outline = linear_ring(geos, rings[0]);
  std::vector<GEOSGeometry*> holes;
  for (std::size_t i = 1; i < rings.size(); ++i) holes.push_back(linear_ring(geos, rings[i]));
  return {GEOSGeom_createPolygon_r(geos, outline, holes.data(), holes.size()), Destroy{geos}};
}

RawRing from_geos(GEOSContextHandle_t geos, const GEOSGeometry* ring) {
  const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(geos, ring);
  unsigned size = 0;
  GEOSCoordSeq_getSize_r(geos, points, &size);
  RawRing result(size > 0 ? size - 1 : 0);
  for (unsigned i = 0; i < result.size(); ++i) {
    GEOSCoordSeq_getXY_r(geos, points, i, &result[i].x, &result[i].y);
  }
  return result;
}

void collect(GEOSContextHandle_t geos, const GEOSGeometry* from, std::vector<RawPolygon>& to) {
  if (GEOSGeomTypeId_r(geos, from) != GEOS_POLYGON) {
    const int parts = GEOSGetNumGeometries_r(geos, from);
    const bool is_collection = GEOSGeomTypeId_r(geos, from) > GEOS_POLYGON;
    for (int i = 0; is_collection && i < parts; ++i) {
      collect(geos, GEOSGetGeometryN_r(geos, from, i), to);
    }
    return;
  }
  if (GEOSisEmpty_r(geos, from)) return;
  RawPolygon& rings = to.emplace_back();
  rings.push_back(from_geos(geos, GEOSGetExteriorRing_r(geos, from)));
  for (int i = 0; i < GEOSGetNumInteriorRings_r(geos, from); ++i) {
    rings.push_back(from_geos(geos, GEOSGetInteriorRingN_r(geos, from, i)));
  }
}

/// The first edge first again, if the repair left it.
void start_at(RawRing& ring, Vec2 first, Vec2 second) {
  if (area(ring) < 0) std::reverse(ring.begin(), ring.end());
  auto start = ring.end();
  for (auto p = ring.begin(); p != ring.end(); ++p) {
    const Vec2 next = p + 1 == ring.end() ? ring.front() : *(p + 1);
    if ((*p == first && next == second) || (*p == second && next == first)) start = p;
  }
  if (start == ring.end()) start = std::find(ring.begin(), ring.end(), first);
  if (start != ring.end()) std::rotate(ring.begin(), start, ring.end());
}

struct Repair {
  bool was_valid = false;
  std::vector<RawPolygon> pieces;
};

/// Every ring becomes the area it winds around, then holes are taken from outlines (GEOS'
/// "structure"; Martinez-Llario et al. 2017): overlaps of a ring with itself do not become courts.
Repair repair(const RawPolygon& rings) {
  const Context geos;
  const Geometry geometry = to_geos(geos.handle, rings);
  if (!geometry) return {};
  if (GEOSisValid_r(geos.handle, geometry.get()) == 1) return {true, {}};
  GEOSMakeValidParams* how = GEOSMakeValidParams_create_r(geos.handle);
  GEOSMakeValidParams_setMethod_r(geos.handle, how, GEOS_MAKE_VALID_STRUCTURE);
  const Geometry valid(GEOSMakeValidWithParams_r(geos.handle, geometry.get(), how),
                       Destroy{geos.handle});
  GEOSMakeValidParams_destroy_r(geos.handle, how);
  Repair result;
  if (!valid) return result;
  collect(geos.handle, valid.get(), result.pieces);
  std::erase_if(result.pieces, [](const RawPolygon& piece) {
    double size = std::abs(area(piece[0]));
    for (std::size_t i = 1; i < piece.size(); ++i) size -= std::abs(area(piece[i]));
    return size < least_piece;
  });
  for (RawPolygon& piece : result.pieces) start_at(piece[0], rings[0][0], rings[0][1]);
  return result;
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

  Repair repaired = repair(rings);
  if (repaired.was_valid) repaired.pieces.push_back(std::move(rings));
  for (const RawPolygon& piece : repaired.pieces) {
    Polygon polygon = to_polygon(piece);
    if (area(polygon) >= least_area) result.polygons.push_back(std::move(polygon));
  }
  if (result.polygons.empty()) return {{}, {"has no area"}};
  if (!repaired.was_valid) result.notes.emplace_back("self-crossing ring repaired");
  return result;
}

}  // namespace mansard
