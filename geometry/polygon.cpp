#include "geometry/polygon.hpp"

#include <algorithm>

namespace mansard {
namespace {

/// Distances below this, in metres, count as touching.
constexpr double touching = 1e-9;

bool on_segment(Vec2 p, Vec2 from, Vec2 to) {
  const Vec2 along = to - from, offset = p - from;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(offset, along) / squared, 0.0, 1.0) : 0.0;
  const Vec2 gap = offset - along * t;
  return dot(gap, gap) <= touching * touching;
}

/// Reverses a ring so that its first edge stays first, walked the other way.
void reverse_ring(Polygon& polygon, std::size_t ring) {
  const auto begin = polygon.ring_begin(ring), end = polygon.ring_ends[ring];
  if (end - begin < 2) return;
  std::reverse(polygon.points.begin() + begin + 2, polygon.points.begin() + end);
  std::swap(polygon.points[begin], polygon.points[begin + 1]);
  std::reverse(polygon.tags.begin() + begin + 1, polygon.tags.begin() + end);
}

}  // namespace

std::vector<uint32_t> next_points(const Polygon& polygon) {
  std::vector<uint32_t> next(polygon.points.size());
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) next[i] = i + 1 == end ? begin : i + 1;
  }
  return next;
}

Polygon rectangle(double width, double height) {
  Polygon result;
  for (const Vec2 p : {Vec2{0, 0}, Vec2{width, 0}, Vec2{width, height}, Vec2{0, height}}) {
    result.add_point(p);
  }
  result.close_ring();
  return result;
}

double area(std::span<const Vec2> ring) {
  double twice = 0;
  // Relative to the first point, so that far-away polygons lose no digits.
  for (std::size_t i = 2; i < ring.size(); ++i) {
    twice += cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
  }
  return twice / 2;
}

double area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const double size = std::abs(area(polygon.ring(r)));
    sum += r == 0 ? size : -size;
  }
  return sum;
}

double perimeter(const Polygon& polygon) {
  double sum = 0;
  for_each_edge(polygon, [&](uint32_t, Vec2 from, Vec2 to) { sum += length(to - from); });
  return sum;
}

Box2 bounds(std::span<const Vec2> points) {
  if (points.empty()) return {};
  Box2 box{points[0], points[0]};
  for (const Vec2 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

bool is_convex(const Polygon& polygon) {
  if (polygon.rings() != 1 || polygon.points.size() < 3) return false;
  const auto ring = polygon.ring(0);
  const std::size_t n = ring.size();
  int turns_of_u = 0;
  double last_u = 0, first_u = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = ring[(i + 1) % n] - ring[i], out = ring[(i + 2) % n] - ring[(i + 1) % n];
    if (cross(in, out) < -1e-12 * (dot(in, in) + dot(out, out))) return false;
    if (in.x == 0) continue;
    if (first_u == 0) first_u = in.x;
    if (last_u * in.x < 0) ++turns_of_u;
    last_u = in.x;
  }
  // Going around once means that u turns back twice; more is a star or a spiral.
  if (first_u * last_u < 0) ++turns_of_u;
  return turns_of_u <= 2 && area(ring) > 0;
}

bool is_axis_rectangle(const Polygon& polygon, double tolerance) {
  if (polygon.rings() != 1 || polygon.points.size() != 4) return false;
  const auto& p = polygon.points;
  const auto level = [&](int i, int j) { return std::abs(p[i].y - p[j].y) <= tolerance; };
  const auto upright = [&](int i, int j) { return std::abs(p[i].x - p[j].x) <= tolerance; };
  const bool first_level = level(0, 1) && level(2, 3) && upright(1, 2) && upright(3, 0);
  const bool first_upright = upright(0, 1) && upright(2, 3) && level(1, 2) && level(3, 0);
  return (first_level || first_upright) && area(polygon.ring(0)) > 0;
}

bool contains(const Polygon& polygon, Vec2 point) {
  bool inside = false, border = false;
  for_each_edge(polygon, [&](uint32_t, Vec2 from, Vec2 to) {
    border = border || on_segment(point, from, to);
    if ((from.y > point.y) == (to.y > point.y)) return;
    const double u = from.x + (to.x - from.x) * ((point.y - from.y) / (to.y - from.y));
    if (point.x < u) inside = !inside;
  });
  return inside || border;
}

void translate(Polygon& polygon, Vec2 by) {
  for (Vec2& p : polygon.points) p = p + by;
}

void mirror_u(Polygon& polygon) {
  for (Vec2& p : polygon.points) p.x = -p.x;
  for (std::size_t r = 0; r < polygon.rings(); ++r) reverse_ring(polygon, r);
}

void orient(Polygon& polygon) {
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const double signed_area = area(polygon.ring(r));
    if (r == 0 ? signed_area < 0 : signed_area > 0) reverse_ring(polygon, r);
  }
}

}  // namespace mansard
