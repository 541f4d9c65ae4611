#include "geometry/distance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mansard {

Nearest3 nearest_pair(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
  double s = 0, t = 0;
  if (uu > 0 && vv > 0) {
    const double cross_squared = uu * vv - uv * uv;
    if (cross_squared > 1e-14 * uu * vv)
      s = std::clamp((uv * vw - uw * vv) / cross_squared, 0.0, 1.0);
    t = (uv * s + vw) / vv;
    if (t < 0 || t > 1) {
      t = std::clamp(t, 0.0, 1.0);
      s = std::clamp((uv * t - uw) / uu, 0.0, 1.0);
    }
  } else if (uu > 0) {
    s = std::clamp(-uw / uu, 0.0, 1.0);
  } else if (vv > 0) {
    t = std::clamp(vw / vv, 0.0, 1.0);
  }
  const Vec3 p = a + u * s, q = c + v * t;
  return {p, q, length(q - p)};
}

Nearest2 nearest_pair(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto flat = [](Vec2 p) { return Vec3{p.x, p.y, 0}; };
  const Nearest3 pair = nearest_pair(flat(a), flat(b), flat(c), flat(d));
  return {{pair.first.x, pair.first.y}, {pair.second.x, pair.second.y}, pair.distance};
}

namespace {

bool is_over(const Triangle& t, Vec3 normal, Vec3 p) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(cross(t[(i + 1) % 3] - t[i], p - t[i]), normal) < 0) return false;
  }
  return true;
}

/// The foot of p on the triangle's inside.
std::optional<Vec3> foot(const Triangle& t, Vec3 normal, Vec3 p) {
  const double size = dot(normal, normal);
  if (size == 0) return std::nullopt;
  const Vec3 q = p - normal * (dot(p - t[0], normal) / size);
  if (!is_over(t, normal, q)) return std::nullopt;
  return q;
}

/// Where the segment goes through the triangle.
std::optional<Vec3> piercing(const Triangle& t, Vec3 normal, Vec3 from, Vec3 to) {
  const double a = dot(from - t[0], normal), b = dot(to - t[0], normal);
  if ((a > 0) == (b > 0) || a == b) return std::nullopt;
  const Vec3 q = mix(from, to, a / (a - b));
  if (!is_over(t, normal, q)) return std::nullopt;
  return q;
}

}  // namespace

Nearest3 nearest_pair(const Triangle& a, const Triangle& b) {
  const Vec3 normal_a = cross(a[1] - a[0], a[2] - a[0]);
  const Vec3 normal_b = cross(b[1] - b[0], b[2] - b[0]);
  Nearest3 best = nearest_pair(a[0], a[1], b[0], b[1]);
  const auto take = [&](Vec3 on_a, Vec3 on_b) {
    const double distance = length(on_b - on_a);
    if (distance < best.distance) best = {on_a, on_b, distance};
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 a1 = a[i], a2 = a[(i + 1) % 3], b1 = b[i], b2 = b[(i + 1) % 3];
    for (std::size_t j = 0; j < 3; ++j) {
      const Nearest3 pair = nearest_pair(a1, a2, b[j], b[(j + 1) % 3]);
      if (pair.distance < best.distance) best = pair;
    }
    if (const auto q = foot(a, normal_a, b1)) take(*q, b1);
    if (const auto q = foot(b, normal_b, a1)) take(a1, *q);
    if (const auto q = piercing(a, normal_a, b1, b2)) take(*q, *q);
    if (const auto q = piercing(b, normal_b, a1, a2)) take(*q, *q);
  }
  return best;
}

}  // namespace mansard
