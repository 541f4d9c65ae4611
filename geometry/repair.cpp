#include "geometry/repair.hpp"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "geometry/polygon.hpp"

namespace mansard {
namespace {

using Ring = std::vector<Vec2>;
using Rings = std::vector<Ring>;

constexpr double least_piece = 1e-2;  ///< square metres: repairs may break off crumbs
/// Beyond these a ring is a scribble, and GEOS takes seconds and gigabytes for what it encloses.
constexpr std::size_t most_crossings = 1000, most_tests = 50'000'000;

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

GEOSGeometry* linear_ring(GEOSContextHandle_t geos, const Ring& ring) {
  const auto size = static_cast<unsigned>(ring.size());
  GEOSCoordSequence* points = GEOSCoordSeq_create_r(geos, size + 1, 2);
  for (unsigned i = 0; i <= size; ++i) {
    GEOSCoordSeq_setXY_r(geos, points, i, ring[i % size].x, ring[i % size].y);
  }
  return GEOSGeom_createLinearRing_r(geos, points);
}

Geometry to_geos(GEOSContextHandle_t geos, const Rings& rings) {
  GEOSGeometry* outline = linear_ring(geos, rings[0]);
  std::vector<GEOSGeometry*> holes;
  for (std::size_t i = 1; i < rings.size(); ++i) holes.push_back(linear_ring(geos, rings[i]));
  return {GEOSGeom_createPolygon_r(geos, outline, holes.data(), holes.size()), Destroy{geos}};
}

Ring from_geos(GEOSContextHandle_t geos, const GEOSGeometry* ring) {
  const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(geos, ring);
  unsigned size = 0;
  GEOSCoordSeq_getSize_r(geos, points, &size);
  Ring result(size > 0 ? size - 1 : 0);
  for (unsigned i = 0; i < result.size(); ++i) {
    GEOSCoordSeq_getXY_r(geos, points, i, &result[i].x, &result[i].y);
  }
  return result;
}

void collect(GEOSContextHandle_t geos, const GEOSGeometry* from, std::vector<Rings>& to) {
  if (GEOSGeomTypeId_r(geos, from) != GEOS_POLYGON) {
    const int parts = GEOSGetNumGeometries_r(geos, from);
    const bool is_collection = GEOSGeomTypeId_r(geos, from) > GEOS_POLYGON;
    for (int i = 0; is_collection && i < parts; ++i) {
      collect(geos, GEOSGetGeometryN_r(geos, from, i), to);
    }
    return;
  }
  if (GEOSisEmpty_r(geos, from)) return;
  Rings& rings = to.emplace_back();
  rings.push_back(from_geos(geos, GEOSGetExteriorRing_r(geos, from)));
  for (int i = 0; i < GEOSGetNumInteriorRings_r(geos, from); ++i) {
    rings.push_back(from_geos(geos, GEOSGetInteriorRingN_r(geos, from, i)));
  }
}

/// The first edge first again, if the repair left it.
void start_at(Ring& ring, Vec2 first, Vec2 second) {
  if (area(ring) < 0) std::reverse(ring.begin(), ring.end());
  auto start = ring.end();
  for (auto p = ring.begin(); p != ring.end(); ++p) {
    const Vec2 next = p + 1 == ring.end() ? ring.front() : *(p + 1);
    if ((*p == first && next == second) || (*p == second && next == first)) start = p;
  }
  if (start == ring.end()) start = std::find(ring.begin(), ring.end(), first);
  if (start != ring.end()) std::rotate(ring.begin(), start, ring.end());
}

struct Edge {
  Vec2 a, b;
  double left, right;
};

bool cross_each_other(const Edge& e, const Edge& f) {
  if (std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y)) return false;
  if (std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y)) return false;
  const auto divides = [](const Edge& by, const Edge& other) {
    const Vec2 along = by.b - by.a;
    return cross(along, other.a - by.a) * cross(along, other.b - by.a) < 0;
  };
  return divides(e, f) && divides(f, e);
}

/// Sweeps from left to right and gives up as soon as it is clear.
bool is_scribble(const Rings& rings) {
  std::vector<Edge> edges;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      edges.push_back({a, b, std::min(a.x, b.x), std::max(a.x, b.x)});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& e, const Edge& f) { return e.left < f.left; });
  std::size_t crossings = 0, tests = 0;
  for (auto e = edges.begin(); e != edges.end(); ++e) {
    for (auto f = e + 1; f != edges.end() && f->left <= e->right; ++f) {
      crossings += cross_each_other(*e, *f);
      if (crossings > most_crossings || ++tests > most_tests) return true;
    }
  }
  return false;
}

}  // namespace

RepairedRings repair(const Rings& rings) {
  const Context geos;
  const Geometry geometry = to_geos(geos.handle, rings);
  if (!geometry) return {};
  if (GEOSisValid_r(geos.handle, geometry.get()) == 1) return {true, false, {}};
  if (is_scribble(rings)) return {false, true, {}};
  GEOSMakeValidParams* how = GEOSMakeValidParams_create_r(geos.handle);
  GEOSMakeValidParams_setMethod_r(geos.handle, how, GEOS_MAKE_VALID_STRUCTURE);
  const Geometry valid(GEOSMakeValidWithParams_r(geos.handle, geometry.get(), how),
                       Destroy{geos.handle});
  GEOSMakeValidParams_destroy_r(geos.handle, how);
  RepairedRings result;
  if (!valid) return result;
  collect(geos.handle, valid.get(), result.pieces);
  std::erase_if(result.pieces, [](const Rings& piece) {
    double size = std::abs(area(piece[0]));
    for (std::size_t i = 1; i < piece.size(); ++i) size -= std::abs(area(piece[i]));
    return size < least_piece;
  });
  for (Rings& piece : result.pieces) start_at(piece[0], rings[0][0], rings[0][1]);
  return result;
}

}  // namespace mansard
