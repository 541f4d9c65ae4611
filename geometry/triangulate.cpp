#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/clip.hpp"
#include "geometry/triangulate_delaunay.hpp"

namespace mansard {
namespace {

/// Rings with more corners go to the Delaunay triangulation at once: cutting ears is quadratic.
constexpr std::size_t most_ears = 48;

double twice_area(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

double triangles_area(std::span<const Vec2> points, std::span<const uint32_t> triangles) {
  double twice = 0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const auto at = [&](std::size_t k) { return points[triangles[i + k]]; };
    twice += std::abs(twice_area(at(0), at(1), at(2)));
  }
  return twice / 2;
}

/// A fan around the first point, when every triangle of it has an area.
std::vector<uint32_t> fan(std::span<const Vec2> ring) {
  std::vector<uint32_t> triangles;
  const std::size_t n = ring.size();
  triangles.reserve(3 * (n - 2));
  for (uint32_t i = 1; i + 1 < n; ++i) {
    const Vec2 in = ring[i] - ring[i - 1], out = ring[i + 1] - ring[i];
    const double scale = dot(in, in) + dot(out, out);
    if (cross(in, out) < -1e-12 * scale) return {};
    if (twice_area(ring[0], ring[i], ring[i + 1]) <= 1e-12 * scale) return {};
    triangles.insert(triangles.end(), {0, i, i + 1});
  }
  const Vec2 last = ring[n - 1] - ring[n - 2], closing = ring[0] - ring[n - 1];
  const Vec2 first = ring[1] - ring[0];
  if (cross(last, closing) < 0 || cross(closing, first) < 0) return {};
  return triangles;
}

/// Cuts off convex corners that hold no other point (Meisters 1975). Always ends; rings that cross
/// themselves are covered as well as can be.
class EarCutter {
 public:
  explicit EarCutter(std::span<const Vec2> ring) : ring_(ring) {
    for (uint32_t i = 0; i < ring.size(); ++i) left_.push_back(i);
  }

  std::vector<uint32_t> run() {
    while (left_.size() > 2) {
      if (!cut_next(true) && !cut_next(false)) left_.pop_back();
    }
    return std::move(triangles_);
  }

 private:
  bool cut_next(bool strictly) {
    const std::size_t n = left_.size();
    for (std::size_t step = 0; step < n; ++step) {
      const std::size_t i = (at_ + step) % n;
      const uint32_t a = left_[(i + n - 1) % n], b = left_[i], c = left_[(i + 1) % n];
      if (!is_ear(a, b, c, strictly)) continue;
      triangles_.insert(triangles_.end(), {a, b, c});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
      at_ = i;  // the next ear is cut elsewhere, for rounder triangles
      return true;
    }
    return false;
  }

  bool is_ear(uint32_t a, uint32_t b, uint32_t c, bool strictly) const {
    const Vec2 p = ring_[a], q = ring_[b], r = ring_[c];
    const Vec2 base = r - p;
    if (twice_area(p, q, r) <= 1e-12 * (dot(base, base) + dot(q - p, q - p))) return false;
    if (!strictly) return true;
    return std::none_of(left_.begin(), left_.end(), [&](uint32_t i) {
      const Vec2 x = ring_[i];
      if (i == a || i == b || i == c) return false;
      return twice_area(p, q, x) >= 0 && twice_area(q, r, x) >= 0 && twice_area(r, p, x) >= 0;
    });
  }

  std::span<const Vec2> ring_;
  std::vector<uint32_t> left_, triangles_;
  std::size_t at_ = 0;
};

bool covers(const Polygon& polygon, std::span<const uint32_t> triangles) {
  const double whole = area(polygon);
  return std::abs(triangles_area(polygon.points, triangles) - whole) <= 1e-9 * whole;
}

/// A loop seen along the axis that its normal is nearest to, counter-clockwise.
Polygon flattened(std::span<const Vec3> loop) {
  const Vec3 normal = newell(loop);
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  Polygon flat;
  for (const Vec3 p : loop) {
    if (z >= x && z >= y) {
      flat.add_point(normal.z > 0 ? Vec2{p.x, p.y} : Vec2{p.y, p.x});
    } else if (y >= x) {
      flat.add_point(normal.y > 0 ? Vec2{p.z, p.x} : Vec2{p.x, p.z});
    } else {
      flat.add_point(normal.x > 0 ? Vec2{p.y, p.z} : Vec2{p.z, p.y});
    }
  }
  flat.close_ring();
  return flat;
}

/// The diagonal from the first corner, unless that one runs outside.
std::vector<uint32_t> triangulate_quad(std::span<const Vec3> loop) {
  const Vec3 normal = newell(loop);
  const auto turns_left = [&](int a, int b, int c) {
    return dot(cross(loop[b] - loop[a], loop[c] - loop[b]), normal) > 0;
  };
  if (turns_left(0, 1, 2) && turns_left(2, 3, 0)) return {0, 1, 2, 0, 2, 3};
  if (turns_left(1, 2, 3) && turns_left(3, 0, 1)) return {0, 1, 3, 1, 2, 3};
  return {0, 1, 2, 0, 2, 3};
}

}  // namespace

std::vector<uint32_t> triangulate(const Polygon& polygon) {
  if (polygon.points.size() < 3 || polygon.ring_ends.empty()) return {};
  const auto outline = polygon.ring(0);
  const bool simple = !polygon.has_holes() && outline.size() <= most_ears;
  if (!polygon.has_holes() && outline.size() >= 3) {
    std::vector<uint32_t> triangles = fan(outline);
    if (!triangles.empty() && covers(polygon, triangles)) return triangles;
  }
  if (simple) {
    std::vector<uint32_t> triangles = EarCutter(outline).run();
    if (covers(polygon, triangles)) return triangles;
  }
  if (std::isfinite(perimeter(polygon))) {
    if (auto triangles = triangulate_delaunay(polygon)) return std::move(*triangles);
  }
  return EarCutter(outline).run();
}

std::vector<uint32_t> triangulate(std::span<const Vec3> loop) {
  if (loop.size() < 3) return {};
  if (loop.size() == 3) return {0, 1, 2};
  if (loop.size() == 4) return triangulate_quad(loop);
  return triangulate(flattened(loop));
}

}  // namespace mansard
