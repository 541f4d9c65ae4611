#include "interpreter/street_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mansard {
namespace {

constexpr uint32_t nobody = 0xffffffff;
constexpr double never = std::numeric_limits<double>::infinity();

Vec2 end_of(const Polygon& polygon, const std::vector<uint32_t>& next, uint32_t edge) {
  return polygon.points[next[edge]];
}

/// Angle inside the footprint between an edge and the next one, degrees.
double angle_inside(Vec2 along, Vec2 then) {
  return 180 - std::atan2(cross(along, then), dot(along, then)) * 180 / 3.14159265358979323846;
}

void mark_corners(Polygon& polygon, const std::vector<uint32_t>& next) {
  constexpr double blunt = 150;
  for (uint32_t i = 0; i < next.size(); ++i) {
    const uint32_t j = next[i];
    if (!polygon.tags[i].has(EdgeTag::street) || !polygon.tags[j].has(EdgeTag::street)) continue;
    const Vec2 along = end_of(polygon, next, i) - polygon.points[i];
    const Vec2 then = end_of(polygon, next, j) - polygon.points[j];
    if (!(angle_inside(along, then) < blunt)) continue;
    polygon.tags[i].flags |= EdgeTag::corner;
    polygon.tags[j].flags |= EdgeTag::corner;
  }
}

}  // namespace

void StreetEdges::mark(Polygon& polygon, uint32_t footprint) const {
  std::vector<uint32_t> free;
  std::vector<double> lengths(polygon.points.size(), 0);
  for_each_edge(polygon, [&](uint32_t i, Vec2 a, Vec2 b) {
    lengths[i] = length(b - a);
    if (polygon.tags[i].flags & (EdgeTag::party | EdgeTag::court)) return;
    if (std::isfinite(lengths[i]) && lengths[i] > 0) free.push_back(i);
  });
  std::vector<uint32_t> street = that_see(polygon, free);
  if (street.empty()) street = with_room(polygon, free, footprint);
  if (street.empty()) street = std::move(free);
  if (street.empty()) return;
  uint32_t longest = street[0];
  for (const uint32_t i : street) {
    polygon.tags[i].flags |= EdgeTag::street;
    if (lengths[i] > lengths[longest]) longest = i;
  }
  polygon.tags[longest].flags |= EdgeTag::main;
  mark_corners(polygon, next_points(polygon));
}

std::vector<uint32_t> StreetEdges::that_see(const Polygon& polygon,
                                            const std::vector<uint32_t>& free) const {
  if (streets_.empty()) return {};
  const std::vector<uint32_t> next = next_points(polygon);
  std::vector<double> distances;
  double nearest = never;
  for (const uint32_t i : free) {
    const Vec2 a = polygon.points[i], b = end_of(polygon, next, i);
    const Vec2 outwards = left_of(normalized(b - a)) * -1;
    double distance = never;
    for (const double at : {1.0 / 2, 1.0 / 6, 5.0 / 6}) {
      const double reach = std::min({street_reach, distance, nearest + street_spread});
      distance = std::min(distance, sight(mix(a, b, at), outwards, reach));
    }
    distances.push_back(distance);
    nearest = std::min(nearest, distance);
  }
  std::vector<uint32_t> found;
  for (std::size_t k = 0; k < free.size(); ++k) {
    if (distances[k] < never && distances[k] <= nearest + street_spread) found.push_back(free[k]);
  }
  return found;
}

/// Metres to the nearest street that is seen ahead.
double StreetEdges::sight(Vec2 from, Vec2 outwards, double reach) const {
  constexpr double cosine = 0.70710678;  // 45 degrees
  std::vector<Vec2> places;
  streets_.nearest_points(from, reach, places);
  for (const Vec2 place : places) {
    const Vec2 way = place - from;
    const double far = length(way);
    if (dot(way, outwards) < cosine * far) continue;
    if (far <= tolerance_ || !is_blocked(from + outwards * tolerance_, place, nobody)) return far;
  }
  return never;
}

/// Whether an edge of a footprint, `but` this one, crosses the line.
bool StreetEdges::is_blocked(Vec2 from, Vec2 to, uint32_t but) const {
  std::vector<uint32_t> near;
  grid_.near(from, to, near);
  const Vec2 way = to - from;
  return std::ranges::any_of(near, [&](uint32_t n) {
    const GridEdge& other = grid_.edge(n);
    if (other.footprint == but) return false;
    const double s1 = cross(way, other.from - from), s2 = cross(way, other.to - from);
    if ((s1 > 0) == (s2 > 0)) return false;
    const double along = dot(mix(other.from, other.to, s1 / (s1 - s2)) - from, way) / dot(way, way);
    return along >= 0 && along <= 1;
  });
}

std::vector<uint32_t> StreetEdges::with_room(const Polygon& polygon,
                                             const std::vector<uint32_t>& free,
                                             uint32_t footprint) const {
  const std::vector<uint32_t> next = next_points(polygon);
  std::vector<uint32_t> found;
  for (const uint32_t i : free) {
    const Vec2 a = polygon.points[i], b = end_of(polygon, next, i);
    const Vec2 outwards = left_of(normalized(b - a)) * -1;
    const Vec2 from = mix(a, b, 0.5) + outwards * tolerance_;
    if (!is_blocked(from, from + outwards * street_clearance, footprint)) found.push_back(i);
  }
  return found;
}

}  // namespace mansard
