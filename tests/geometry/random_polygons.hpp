// Random polygons with holes, and what every polygon that comes out must be.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/polygon.hpp"
#include "tests/geometry/roof_input.hpp"

namespace mansard::test {

/// Stars with star-shaped holes, right-angled plans on a one-metre grid (cuts through grid lines
/// hit many points and edges at once), combs, and the shapes of RandomFootprints. All simple.
class RandomPolygons {
 public:
  explicit RandomPolygons(unsigned seed) : random_(seed), footprints_(seed) {}

  Polygon next() {
    Polygon p;
    switch (below(4)) {
      case 0:
        p = star();
        break;
      case 1:
        p = skyline();
        break;
      case 2:
        p = comb();
        break;
      default:
        p = footprints_.next();
        orient(p);
        break;
    }
    for (std::size_t i = 0; i < p.tags.size(); ++i) p.tags[i].wall = static_cast<uint16_t>(i);
    return p;
  }

  double between(double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random_);
  }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  /// A unit direction; often along an axis.
  Vec2 direction() {
    if (below(2) == 0) return std::array<Vec2, 4>{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}}[below(4)];
    const double angle = between(0, 2 * std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
  }
  /// Through the polygon; often through a corner or on a grid line.
  double offset(const Polygon& p, Vec2 normal) {
    if (below(3) == 0) return dot(normal, p.points[below(static_cast<int>(p.points.size()))]);
    double low = 1e300, high = -1e300;
    for (const Vec2 q : p.points) {
      low = std::min(low, dot(normal, q));
      high = std::max(high, dot(normal, q));
    }
    const double at = between(low, high);
    return below(3) == 0 ? std::round(at) : at;
  }

 private:
  Polygon star() {
    Polygon p;
    add_star(p, {}, 4, 12, 3 + below(12), 1);
    if (below(2) == 0) {
      add_star(p, {-1.4, 0}, 0.3, 1.2, 3 + below(6), -1);
      add_star(p, {1.4, 0.2}, 0.3, 1.2, 3 + below(6), -1);
    }
    return p;
  }
  void add_star(Polygon& p, Vec2 centre, double low, double high, int n, int turn) {
    for (int i = 0; i < n; ++i) {
      const double angle = turn * 2 * std::numbers::pi * i / n, radius = between(low, high);
      // Triangles and quads about the centre could miss it; keep those regular.
      const double r = n < 5 ? high : radius;
      p.add_point(centre + Vec2{std::cos(angle), std::sin(angle)} * r);
    }
    p.close_ring();
  }

  /// Towers of whole heights side by side, with square holes in some.
  Polygon skyline() {
    const int n = 1 + below(7);
    std::vector<int> heights;
    for (int i = 0; i < n; ++i) heights.push_back(2 + below(5));
    Polygon p;
    p.add_point({0, 0});
    p.add_point({3.0 * n, 0});
    for (int i = n; i-- > 0;) {
      if (i + 1 == n || heights[i] != heights[i + 1]) {
        p.add_point({3.0 * (i + 1), double(heights[i])});
      }
      if (i == 0 || heights[i] != heights[i - 1]) p.add_point({3.0 * i, double(heights[i])});
    }
    p.close_ring();
    for (int i = 0; i < n; ++i) {
      if (heights[i] < 3 || below(2) == 0) continue;
      const double u = 3.0 * i + 1, top = heights[i] - 1.0;
      for (const Vec2 q : {Vec2{u, 1}, {u, top}, {u + 1, top}, {u + 1, 1}}) p.add_point(q);
      p.close_ring();
    }
    return p;
  }

  /// Teeth up and down, that one line cuts many times.
  Polygon comb() {
    Polygon p;
    const int teeth = 2 + below(3);
    for (int i = 0; i < teeth; ++i) {
      p.add_point({2.0 * i, -1.0 - below(3)});
      p.add_point({2.0 * i + 1, below(2) == 0 ? 0.0 : between(-0.5, 0.5)});
    }
    p.add_point({2.0 * teeth, -1});
    for (int i = teeth; i-- > 0;) {
      p.add_point({2.0 * i + 1, 4.0 + below(3)});
      p.add_point({2.0 * i, below(2) == 0 ? 2.0 : between(1, 3)});
    }
    p.close_ring();
    return p;
  }

  std::mt19937 random_;
  RandomFootprints footprints_;
};

inline double total_area(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& p : polygons) sum += area(p);
  return sum;
}

/// Oriented rings with areas, one tag a point, no repeated or infinite points.
inline bool well_formed(const Polygon& p) {
  if (p.rings() == 0 || p.tags.size() != p.points.size()) return false;
  if (p.ring_ends.back() != p.points.size()) return false;
  for (std::size_t r = 0; r < p.rings(); ++r) {
    const auto ring = p.ring(r);
    if (ring.size() < 3 || (r == 0 ? area(ring) <= 0 : area(ring) >= 0)) return false;
  }
  bool fine = area(p) > 0;
  for_each_edge(p, [&](uint32_t, Vec2 a, Vec2 b) {
    fine = fine && std::isfinite(a.x) && std::isfinite(a.y) && a != b;
  });
  return fine;
}

inline bool well_formed(const std::vector<Polygon>& polygons) {
  for (const Polygon& p : polygons) {
    if (!well_formed(p)) return false;
  }
  return true;
}

/// No edge crosses another in the middle of both; touching is allowed. Quadratic.
inline bool crosses_itself(const Polygon& p) {
  std::vector<std::pair<Vec2, Vec2>> edges;
  for_each_edge(p, [&](uint32_t, Vec2 a, Vec2 b) { edges.push_back({a, b}); });
  const auto side = [](Vec2 a, Vec2 b, Vec2 c) {
    const double turn = cross(b - a, c - a);
    return std::abs(turn) <= 1e-7 * length(b - a) ? 0 : turn > 0 ? 1 : -1;
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const auto [a, b] = edges[i];
      const auto [c, d] = edges[j];
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return true;
    }
  }
  return false;
}

/// Real footprints whose rings do not cross.
inline std::vector<Named> simple_footprints(std::size_t step) {
  std::vector<Named> found = real_footprints(step);
  if (found.empty()) MESSAGE("no real footprints beside the project; skipped");
  std::erase_if(found, [](const Named& n) {
    return n.polygon.points.size() > 400 || !well_formed(n.polygon) || crosses_itself(n.polygon);
  });
  for (Named& n : found) {
    for (std::size_t i = 0; i < n.polygon.tags.size(); ++i) {
      n.polygon.tags[i].wall = static_cast<uint16_t>(i);
    }
  }
  return found;
}

}  // namespace mansard::test
