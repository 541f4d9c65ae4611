#include "geometry/clip_boolean.hpp"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/clip.hpp"

namespace mansard {
namespace {

/// Pieces thinner than this, in metres, are noise of rounding.
constexpr double thinnest = 1e-9;
/// Points this near are one, and points this near to a line are on it, in metres.
constexpr double nearest = 1e-8;
/// Cells of Precision::grid, in metres.
constexpr double cell = 1e-9;
/// How far a result's edge may lie from the edge that it came from, in metres.
constexpr double on_source = 1e-7;

/// GEOS reports errors by null; nothing throws.
class Geos {
 public:
  Geos() : handle_(GEOS_init_r()) {}
  ~Geos() { GEOS_finish_r(handle_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;
  GEOSContextHandle_t get() const { return handle_; }

 private:
  GEOSContextHandle_t handle_;
};

class Geometry {
 public:
  Geometry(const Geos& geos, GEOSGeometry* geometry) : geos_(geos.get()), geometry_(geometry) {}
  Geometry(Geometry&& other) noexcept
      : geos_(other.geos_), geometry_(std::exchange(other.geometry_, nullptr)) {}
  Geometry& operator=(Geometry&& other) noexcept {
    std::swap(geometry_, other.geometry_);
    return *this;
  }
  ~Geometry() {
    if (geometry_ != nullptr) GEOSGeom_destroy_r(geos_, geometry_);
  }
  const GEOSGeometry* get() const { return geometry_; }
  GEOSGeometry* release() { return std::exchange(geometry_, nullptr); }

 private:
  GEOSContextHandle_t geos_;
  GEOSGeometry* geometry_;
};

GEOSGeometry* to_ring(const Geos& geos, std::span<const Vec2> ring) {
  const auto n = static_cast<unsigned>(ring.size());
  GEOSCoordSequence* points = GEOSCoordSeq_create_r(geos.get(), n + 1, 2);
  if (points == nullptr) return nullptr;
  for (unsigned i = 0; i <= n; ++i) {
    GEOSCoordSeq_setXY_r(geos.get(), points, i, ring[i % n].x, ring[i % n].y);
  }
  return GEOSGeom_createLinearRing_r(geos.get(), points);
}

Geometry to_geometry(const Geos& geos, const Polygon& polygon) {
  if (!std::isfinite(perimeter(polygon))) return {geos, nullptr};
  std::vector<GEOSGeometry*> rings;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    if (polygon.ring(r).size() >= 3) {
      rings.push_back(to_ring(geos, polygon.ring(r)));
    } else if (r == 0) {
      break;
    }
  }
  if (rings.empty() || std::count(rings.begin(), rings.end(), nullptr) > 0) {
    for (GEOSGeometry* ring : rings) {
      if (ring != nullptr) GEOSGeom_destroy_r(geos.get(), ring);
    }
    return {geos, nullptr};
  }
  Geometry result(geos, GEOSGeom_createPolygon_r(geos.get(), rings[0], rings.data() + 1,
                                                 static_cast<unsigned>(rings.size() - 1)));
  if (result.get() == nullptr || is_convex(polygon)) return result;
  if (GEOSisValid_r(geos.get(), result.get()) == 1) return result;
  GEOSMakeValidParams* params = GEOSMakeValidParams_create_r(geos.get());
  GEOSMakeValidParams_setMethod_r(geos.get(), params, GEOS_MAKE_VALID_STRUCTURE);
  result = {geos, GEOSMakeValidWithParams_r(geos.get(), result.get(), params)};
  GEOSMakeValidParams_destroy_r(geos.get(), params);
  return result;
}

/// The union of all pieces.
Geometry to_geometry(const Geos& geos, std::span<const Polygon> pieces, Precision precision) {
  if (pieces.size() == 1) return to_geometry(geos, pieces[0]);
  std::vector<GEOSGeometry*> parts;
  for (const Polygon& piece : pieces) {
    Geometry part = to_geometry(geos, piece);
    if (part.get() != nullptr) parts.push_back(part.release());
  }
  const Geometry all(geos,
                     GEOSGeom_createCollection_r(geos.get(), GEOS_GEOMETRYCOLLECTION, parts.data(),
                                                 static_cast<unsigned>(parts.size())));
  if (all.get() == nullptr) return {geos, nullptr};
  if (precision == Precision::floating) return {geos, GEOSUnaryUnion_r(geos.get(), all.get())};
  return {geos, GEOSUnaryUnionPrec_r(geos.get(), all.get(), cell)};
}

double ring_length(std::span<const Vec2> ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    sum += length(ring[(i + 1) % ring.size()] - ring[i]);
  }
  return sum;
}

/// Whether the way over `at` goes nowhere: it comes back on the line on which it went.
bool is_spike(Vec2 before, Vec2 at, Vec2 after) {
  const Vec2 in = at - before, out = after - at;
  if (length(in) <= nearest || length(out) <= nearest) return true;
  const double width = std::abs(cross(in, out)) / std::max(length(in), length(out));
  return dot(in, out) < 0 && width <= nearest;
}

void remove_spikes(std::vector<Vec2>& ring) {
  std::vector<Vec2> kept;
  for (const Vec2 p : ring) {
    while (kept.size() > 1 && is_spike(kept[kept.size() - 2], kept.back(), p)) kept.pop_back();
    if (kept.empty() || length(p - kept.back()) > nearest) kept.push_back(p);
  }
  // Where the ring closes.
  for (bool changed = true; changed && kept.size() >= 3;) {
    changed = is_spike(kept[kept.size() - 2], kept.back(), kept.front());
    if (changed) kept.pop_back();
    if (kept.size() < 3 || !is_spike(kept.back(), kept.front(), kept[1])) continue;
    kept.erase(kept.begin());
    changed = true;
  }
  ring = std::move(kept);
}

/// Adds a ring, unless it is thin; false then.
bool add_ring(const Geos& geos, const GEOSGeometry* ring, Polygon& polygon) {
  const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(geos.get(), ring);
  unsigned n = 0;
  if (points == nullptr || GEOSCoordSeq_getSize_r(geos.get(), points, &n) == 0) return false;
  std::vector<Vec2> corners;
  for (unsigned i = 0; i + 1 < n; ++i) {
    Vec2 p;
    GEOSCoordSeq_getXY_r(geos.get(), points, i, &p.x, &p.y);
    corners.push_back(p);
  }
  remove_spikes(corners);
  if (corners.size() < 3) return false;
  if (2 * std::abs(area(corners)) <= thinnest * ring_length(corners)) return false;
  for (const Vec2 p : corners) polygon.add_point(p);
  polygon.close_ring();
  return true;
}

void extract(const Geos& geos, const GEOSGeometry* geometry, std::vector<Polygon>& out) {
  if (geometry == nullptr) return;
  const int type = GEOSGeomTypeId_r(geos.get(), geometry);
  if (type == GEOS_POLYGON && GEOSisEmpty_r(geos.get(), geometry) == 0) {
    Polygon polygon;
    if (!add_ring(geos, GEOSGetExteriorRing_r(geos.get(), geometry), polygon)) return;
    const int holes = GEOSGetNumInteriorRings_r(geos.get(), geometry);
    for (int i = 0; i < holes; ++i) {
      add_ring(geos, GEOSGetInteriorRingN_r(geos.get(), geometry, i), polygon);
    }
    orient(polygon);
    out.push_back(std::move(polygon));
  } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
    const int parts = GEOSGetNumGeometries_r(geos.get(), geometry);
    for (int i = 0; i < parts; ++i) {
      extract(geos, GEOSGetGeometryN_r(geos.get(), geometry, i), out);
    }
  }
}

enum class Operation { intersection, difference };

GEOSGeometry* apply(const Geos& geos, Operation operation, const Geometry& a, const Geometry& b,
                    Precision precision) {
  const bool floating = precision == Precision::floating;
  if (operation == Operation::intersection) {
    return floating ? GEOSIntersection_r(geos.get(), a.get(), b.get())
                    : GEOSIntersectionPrec_r(geos.get(), a.get(), b.get(), cell);
  }
  return floating ? GEOSDifference_r(geos.get(), a.get(), b.get())
                  : GEOSDifferencePrec_r(geos.get(), a.get(), b.get(), cell);
}

std::optional<std::vector<Polygon>> combine(std::span<const Polygon> a, std::span<const Polygon> b,
                                            Operation operation, Precision precision) {
  const Geos geos;
  const Geometry first = to_geometry(geos, a, precision), second = to_geometry(geos, b, precision);
  if (first.get() == nullptr || second.get() == nullptr) return std::nullopt;
  const Geometry combined(geos, apply(geos, operation, first, second, precision));
  if (combined.get() == nullptr) return std::nullopt;
  std::vector<Polygon> result;
  extract(geos, combined.get(), result);
  return result;
}

/// The points of source edges, to put results exactly on them again.
class PointIndex {
 public:
  explicit PointIndex(std::span<const TaggedEdge> sources) {
    for (const TaggedEdge& edge : sources) points_.push_back(edge.from);
    std::sort(points_.begin(), points_.end(), by_u);
  }

  /// The first source point that is the same but for rounding, else p itself.
  Vec2 nearest_to(Vec2 p) const {
    const Vec2 low{p.x - nearest, 0};
    for (auto i = std::lower_bound(points_.begin(), points_.end(), low, by_u);
         i != points_.end() && i->x <= p.x + nearest; ++i) {
      if (std::abs(i->y - p.y) <= nearest) return *i;
    }
    return p;
  }

 private:
  static bool by_u(Vec2 a, Vec2 b) { return a.x < b.x; }
  std::vector<Vec2> points_;
};

/// How far the edge runs along the source, in metres; 0 when it does not lie on it.
double overlap(Vec2 from, Vec2 to, const TaggedEdge& source) {
  const Vec2 along = source.to - source.from;
  const double size = length(along);
  if (size == 0) return 0;
  const Vec2 direction = along * (1 / size);
  const Vec2 a = from - source.from, b = to - source.from;
  const double reach = std::max({std::abs(from.x), std::abs(from.y), std::abs(to.x)});
  const double tolerance = std::max(on_source, 1e-12 * reach);
  if (std::abs(cross(direction, a)) > tolerance) return 0;
  if (std::abs(cross(direction, b)) > tolerance) return 0;
  const double low = std::min(dot(direction, a), dot(direction, b));
  const double high = std::max(dot(direction, a), dot(direction, b));
  return std::min(high, size) - std::max(low, 0.0);
}

EdgeTag find_tag(Vec2 from, Vec2 to, std::span<const TaggedEdge> sources) {
  EdgeTag tag{EdgeTag::cut, EdgeTag::no_wall};
  double best = 0;
  for (const TaggedEdge& source : sources) {
    const double shared = overlap(from, to, source);
    if (shared <= best + on_source && !(best == 0 && shared > 0)) continue;
    best = shared;
    tag = source.tag;
  }
  return tag;
}

/// Drops corners that are none. Compares with the last corner kept, so that a chain of small bends
/// stays.
Polygon without_straight_points(const Polygon& polygon) {
  Polygon result;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const auto ring = polygon.ring(r);
    const EdgeTag* tags = polygon.tags.data() + polygon.ring_begin(r);
    const std::size_t n = ring.size();
    Vec2 before = ring[n - 1];
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 chord = normalized(ring[(i + 1) % n] - before), step = ring[i] - before;
      const bool straight = std::abs(cross(chord, step)) <= thinnest && dot(chord, step) > 0 &&
                            dot(chord, ring[(i + 1) % n] - ring[i]) > 0;
      if (straight && tags[i] == tags[(i + n - 1) % n]) continue;
      result.add_point(ring[i], tags[i]);
      before = ring[i];
    }
    result.close_ring();
  }
  return result;
}

bool apart(const Polygon& a, const Polygon& b) {
  const Box2 p = bounds(a.points), q = bounds(b.points);
  return p.high.x <= q.low.x || q.high.x <= p.low.x || p.high.y <= q.low.y || q.high.y <= p.low.y;
}

/// Edges of a, then those of b, which are also cuts.
std::vector<TaggedEdge> sources_of(const Polygon& a, const Polygon& b) {
  std::vector<TaggedEdge> sources = tagged_edges(a);
  for (TaggedEdge edge : tagged_edges(b)) {
    edge.tag.flags |= EdgeTag::cut;
    sources.push_back(edge);
  }
  return sources;
}

}  // namespace

std::vector<Polygon> unite(std::span<const Polygon> pieces, Precision precision) {
  const Geos geos;
  std::vector<Polygon> result;
  extract(geos, to_geometry(geos, pieces, precision).get(), result);
  return result;
}

std::vector<Polygon> intersect(std::span<const Polygon> a, std::span<const Polygon> b,
                               Precision precision) {
  if (a.empty() || b.empty()) return {};
  return combine(a, b, Operation::intersection, precision).value_or(std::vector<Polygon>{});
}

std::vector<Polygon> subtract(std::span<const Polygon> from, std::span<const Polygon> pieces,
                              Precision precision) {
  if (from.empty()) return {};
  if (pieces.empty()) return {from.begin(), from.end()};
  return combine(from, pieces, Operation::difference, precision)
      .value_or(std::vector<Polygon>(from.begin(), from.end()));
}

std::vector<TaggedEdge> tagged_edges(const Polygon& polygon) {
  std::vector<TaggedEdge> edges;
  for_each_edge(polygon, [&](uint32_t i, Vec2 from, Vec2 to) {
    edges.push_back({from, to, polygon.tags[i]});
  });
  return edges;
}

void take_tags(std::vector<Polygon>& polygons, std::span<const TaggedEdge> sources) {
  const PointIndex originals(sources);
  for (Polygon& polygon : polygons) {
    for (Vec2& p : polygon.points) p = originals.nearest_to(p);
    std::vector<EdgeTag> tags;
    for_each_edge(polygon, [&](uint32_t, Vec2 from, Vec2 to) {
      tags.push_back(find_tag(from, to, sources));
    });
    polygon.tags = std::move(tags);
    polygon = without_straight_points(polygon);
  }
}

std::vector<Polygon> intersection(const Polygon& a, const Polygon& b) {
  if (a.empty() || b.empty() || apart(a, b)) return {};
  auto result = intersect({&a, 1}, {&b, 1}, Precision::grid);
  take_tags(result, sources_of(a, b));
  return result;
}

std::vector<Polygon> difference(const Polygon& a, const Polygon& b) {
  if (a.empty()) return {};
  if (b.empty() || apart(a, b)) return {a};
  auto result = subtract({&a, 1}, {&b, 1}, Precision::grid);
  take_tags(result, sources_of(a, b));
  return result;
}

}  // namespace mansard
