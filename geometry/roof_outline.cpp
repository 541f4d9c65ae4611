// Outlines moved outwards or inwards, with as many points as before.
#include <algorithm>
#include <cmath>

#include "geometry/clean.hpp"
#include "geometry/roof_parts.hpp"

namespace mansard {
namespace {

// Solves n1.w = -d1, n2.w = -d2: the way of a corner whose walls move by d1 and d2.
Vec2 corner_way(Vec2 n1, Vec2 n2, double d1, double d2) {
  const double determinant = cross(n1, n2);
  if (std::abs(determinant) < 1e-6) {
    return normalized(n1 + n2) * -(std::abs(d1) < std::abs(d2) ? d1 : d2);
  }
  return {-(d1 * n2.y - d2 * n1.y) / determinant, -(n1.x * d2 - n2.x * d1) / determinant};
}

std::vector<Vec2> ways(const Polygon& polygon, const std::vector<double>& outwards) {
  std::vector<Vec2> result(polygon.points.size());
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t before = i == begin ? end - 1 : i - 1, after = i + 1 == end ? begin : i + 1;
      const Vec2 n1 = left_of(normalized(polygon.points[i] - polygon.points[before]));
      const Vec2 n2 = left_of(normalized(polygon.points[after] - polygon.points[i]));
      result[i] = corner_way(n1, n2, outwards[before], outwards[i]);
    }
  }
  return result;
}

// The points at edges that turned round or touch others.
std::vector<char> troubled(const Polygon& old, const Polygon& moved) {
  std::vector<char> bad(old.points.size(), 0);
  const std::vector<uint32_t> next = next_points(old);
  for (std::size_t i = 0; i < next.size(); ++i) {
    const Vec2 d = old.points[next[i]] - old.points[i];
    const Vec2 m = moved.points[next[i]] - moved.points[i];
    if (dot(d, m) < 0.01 * dot(d, d)) bad[i] = bad[next[i]] = 1;
  }
  for (const Contact& c : contacts(moved, 1e-6)) {
    bad[c.point] = bad[next[c.point]] = bad[c.edge] = bad[next[c.edge]] = 1;
  }
  return bad;
}

}  // namespace

MovedOutline move_outline(const Polygon& polygon, const std::vector<double>& outwards) {
  const std::size_t n = polygon.points.size();
  const std::vector<Vec2> way = ways(polygon, outwards);
  double most = 0;
  for (const double d : outwards) most = std::max(most, std::abs(d));
  MovedOutline outline{polygon.points, std::vector<double>(n, 1)};
  for (std::size_t i = 0; i < n; ++i) {
    if (length(way[i]) > 4 * most) outline.shares[i] = 4 * most / length(way[i]);
  }
  Polygon moved = polygon;
  constexpr int attempts = 8;
  for (int attempt = 0; attempt <= attempts; ++attempt) {
    for (std::size_t i = 0; i < n; ++i) {
      moved.points[i] = polygon.points[i] + way[i] * outline.shares[i];
    }
    const std::vector<char> bad = troubled(polygon, moved);
    if (std::count(bad.begin(), bad.end(), 1) == 0) {
      outline.points = std::move(moved.points);
      return outline;
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (bad[i]) outline.shares[i] = attempt + 1 < attempts ? outline.shares[i] / 2 : 0;
    }
  }
  outline.shares.assign(n, 0);
  return outline;
}

}  // namespace mansard
