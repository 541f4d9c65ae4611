#include "geometry/solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/clip.hpp"

namespace mansard {
namespace {

using std::numbers::pi;

constexpr int most_sides = 4096;

bool is_solid(Vec3 size) { return size.x > 0 && size.y > 0 && size.z > 0; }

int sane(int sides) { return std::clamp(sides, 3, most_sides); }

/// Point i of `sides` on the ellipse that fills width x depth, clockwise from u = width seen with v
/// up, which is counter-clockwise seen from above when v is z.
Vec2 on_ellipse(double width, double depth, int i, int sides) {
  const double angle = -2 * pi * i / sides;
  return {width / 2 * (1 + std::cos(angle)), depth / 2 * (1 + std::sin(angle))};
}

/// Adds `sides` points of a level ring and gives the number of the first.
uint32_t add_ring(Mesh& mesh, Vec2 low, Vec2 size, double y, int sides) {
  const auto first = static_cast<uint32_t>(mesh.points.size());
  for (int i = 0; i < sides; ++i) {
    const Vec2 p = low + on_ellipse(size.x, size.y, i, sides);
    mesh.points.push_back({p.x, y, p.y});
  }
  return first;
}

uint32_t add_point(Mesh& mesh, Vec3 p) {
  mesh.points.push_back(p);
  return static_cast<uint32_t>(mesh.points.size() - 1);
}

void add_face(Mesh& mesh, std::initializer_list<uint32_t> loop, EdgeTag tag = {}) {
  mesh.add_face({loop.begin(), loop.end()}, tag);
}

/// A level face of `sides` points, seen from above or from below.
void add_lid(Mesh& mesh, uint32_t first, int sides, bool up) {
  std::vector<uint32_t> loop(sides);
  for (int i = 0; i < sides; ++i) loop[up ? i : sides - 1 - i] = first + i;
  mesh.add_face(loop);
}

/// Quads between two rings of as many points.
void add_band(Mesh& mesh, uint32_t low, uint32_t high, uint32_t sides) {
  for (uint32_t i = 0; i < sides; ++i) {
    const uint32_t next = (i + 1) % sides;
    add_face(mesh, {low + i, low + next, high + next, high + i});
  }
}

void add_fan(Mesh& mesh, uint32_t first, uint32_t sides, uint32_t apex, bool up) {
  for (uint32_t i = 0; i < sides; ++i) {
    const uint32_t a = first + i, b = first + (i + 1) % sides;
    if (up) {
      add_face(mesh, {a, b, apex});
    } else {
      add_face(mesh, {b, a, apex});
    }
  }
}

Vec2 centroid(std::span<const Vec2> ring) {
  double twice = 0;
  Vec2 sum;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const Vec2 a = ring[i - 1] - ring[0], b = ring[i] - ring[0];
    const double weight = cross(a, b);
    twice += weight;
    sum = sum + (a + b) * weight;
  }
  return twice == 0 ? ring[0] : ring[0] + sum * (1 / (3 * twice));
}

/// The base as one face, or as triangles when it has holes; `first` numbers its first point.
void add_base(Mesh& mesh, const Polygon& base, uint32_t first, bool up) {
  std::vector<uint32_t> loop;
  if (!base.has_holes()) {
    for (uint32_t i = 0; i < base.points.size(); ++i) loop.push_back(first + i);
    if (!up) std::reverse(loop.begin(), loop.end());
    mesh.add_face(loop);
    return;
  }
  const std::vector<uint32_t> triangles = triangulate(base);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const uint32_t a = first + triangles[i], b = first + triangles[i + 1];
    const uint32_t c = first + triangles[i + 2];
    if (up) {
      add_face(mesh, {a, b, c});
    } else {
      add_face(mesh, {c, b, a});
    }
  }
}

/// An arc from (width, height - rise) over (width / 2, height) to (0, height - rise), `radius` and
/// its stretch given by the half angle that it spans, on a rectangle.
Polygon arched(double width, double height, double rise, double half_angle, int steps) {
  Polygon result;
  result.add_point({0, 0});
  result.add_point({width, 0});
  const double foot = height - rise;
  const double flat = std::cos(half_angle), wide = std::sin(half_angle);
  for (int i = 0; i <= steps; ++i) {
    if (foot <= 0 && (i == 0 || i == steps)) continue;  // the arc starts on the ground
    const double angle = half_angle * (1 - 2.0 * i / steps);
    const double u = i == 0 ? width : i == steps ? 0 : width / 2 * (1 + std::sin(angle) / wide);
    const double v = i == 0 || i == steps ? 0 : (std::cos(angle) - flat) / (1 - flat);
    result.add_point({u, foot + rise * v});
  }
  result.close_ring();
  return result;
}

Polygon ellipse(double width, double height, int sides) {
  Polygon result;
  for (int i = sides; i-- > 0;) result.add_point(on_ellipse(1, 1, i, sides));
  result.close_ring();
  // Few sides do not reach all four sides of the rectangle by themselves.
  const Box2 box = bounds(result.points);
  for (Vec2& p : result.points) {
    const Vec2 share = p - box.low;
    p = {share.x / box.size().x * width, share.y / box.size().y * height};
  }
  return result;
}

struct Wings {
  double front = 0, right = 0, back = 0, left = 0;
};

Polygon loop_of(std::initializer_list<Vec2> points) {
  Polygon result;
  for (const Vec2 p : points) result.add_point(p);
  result.close_ring();
  return result;
}

/// The ring, to start at its lowest, leftmost point.
Polygon from_lowest(const Polygon& polygon) {
  const auto lowest =
      std::min_element(polygon.points.begin(), polygon.points.end(),
                       [](Vec2 a, Vec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); });
  Polygon result = polygon;
  std::rotate_copy(polygon.points.begin(), lowest, polygon.points.end(), result.points.begin());
  return result;
}

/// The rectangle without the part that no wing covers. Wings of no depth leave their side open.
Polygon wings_of(double width, double depth, Wings wings) {
  if (!(width > 0 && depth > 0)) return {};
  const double u0 = std::max(wings.left, 0.0), u1 = width - std::max(wings.right, 0.0);
  const double v0 = std::max(wings.front, 0.0), v1 = depth - std::max(wings.back, 0.0);
  if (u0 >= u1 || v0 >= v1) return rectangle(width, depth);
  Polygon court = rectangle(u1 - u0, v1 - v0);
  translate(court, {u0, v0});
  const bool inside = u0 > 0 && u1 < width && v0 > 0 && v1 < depth;
  if (inside) {
    Polygon result = rectangle(width, depth);
    for (const Vec2 p : {Vec2{u0, v0}, Vec2{u0, v1}, Vec2{u1, v1}, Vec2{u1, v0}}) {
      result.add_point(p, {EdgeTag::court, EdgeTag::no_wall});
    }
    result.close_ring();
    return result;
  }
  // Wings that do not touch each other are several polygons: only the first is an answer.
  const auto rest = difference(rectangle(width, depth), court);
  return rest.empty() ? Polygon{} : from_lowest(rest.front());
}

}  // namespace

Mesh cylinder(Vec3 size, int sides) {
  Mesh mesh;
  if (!is_solid(size)) return mesh;
  sides = sane(sides);
  const uint32_t low = add_ring(mesh, {}, {size.x, size.z}, 0, sides);
  const uint32_t high = add_ring(mesh, {}, {size.x, size.z}, size.y, sides);
  add_band(mesh, low, high, sides);
  add_lid(mesh, high, sides, true);
  add_lid(mesh, low, sides, false);
  return mesh;
}

Mesh cone(Vec3 size, int sides) {
  Mesh mesh;
  if (!is_solid(size)) return mesh;
  sides = sane(sides);
  const uint32_t low = add_ring(mesh, {}, {size.x, size.z}, 0, sides);
  add_fan(mesh, low, sides, add_point(mesh, {size.x / 2, size.y, size.z / 2}), true);
  add_lid(mesh, low, sides, false);
  return mesh;
}

Mesh sphere(Vec3 size, int sides) {
  Mesh mesh;
  if (!is_solid(size)) return mesh;
  sides = sane(sides);
  const int bands = std::max(2, sides / 2);
  const Vec2 centre{size.x / 2, size.z / 2};
  uint32_t below = 0;
  for (int b = 1; b < bands; ++b) {
    const double angle = pi * b / bands, share = std::sin(angle);
    const Vec2 width{size.x * share, size.z * share};
    const double y = size.y / 2 * (1 - std::cos(angle));
    const uint32_t ring = add_ring(mesh, centre - width * 0.5, width, y, sides);
    if (b > 1) add_band(mesh, below, ring, sides);
    below = ring;
  }
  add_fan(mesh, 0, sides, add_point(mesh, {centre.x, 0, centre.y}), false);
  add_fan(mesh, below, sides, add_point(mesh, {centre.x, size.y, centre.y}), true);
  return mesh;
}

Mesh tapered(const Polygon& base, double height) {
  Mesh mesh;
  if (base.empty() || height == 0) return mesh;
  const double depth = bounds(base.points).high.y;
  for (const Vec2 p : base.points) mesh.points.push_back({p.x, 0, depth - p.y});
  const Vec2 middle = centroid(base.ring(0));
  const uint32_t apex = add_point(mesh, {middle.x, height, depth - middle.y});
  for_each_edge(base, [&](uint32_t i, Vec2 from, Vec2 to) {
    if (from == to) return;
    const auto ring = std::upper_bound(base.ring_ends.begin(), base.ring_ends.end(), i);
    const uint32_t next = i + 1 < *ring ? i + 1 : base.ring_begin(ring - base.ring_ends.begin());
    add_face(mesh, {i, next, apex}, base.tags[i]);
  });
  return mesh;
}

Mesh prism(const Polygon& base, double depth, double height) {
  Mesh mesh;
  if (base.points.size() < 3 || height == 0) return mesh;
  const auto n = static_cast<uint32_t>(base.points.size());
  for (const double y : {std::min(height, 0.0), std::max(height, 0.0)}) {
    for (const Vec2 p : base.points) mesh.points.push_back({p.x, y, depth - p.y});
  }
  for (std::size_t r = 0; r < base.rings(); ++r) {
    const uint32_t begin = base.ring_begin(r), end = base.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t next = i + 1 == end ? begin : i + 1;
      if (base.points[i] == base.points[next]) continue;
      add_face(mesh, {i, next, n + next, n + i}, base.tags[i]);
    }
  }
  add_base(mesh, base, n, true);
  add_base(mesh, base, 0, false);
  return mesh;
}

Polygon figure(std::string_view name, double width, double height, int sides) {
  if (!(width > 0 && height > 0)) return {};
  sides = sane(sides);
  const int steps = std::max(2, sides / 2);
  if (name == "circle") return ellipse(width, height, sides);
  if (name == "arch") return arched(width, height, std::min(width / 2, height), pi / 2, steps);
  if (name == "segment") {
    const double rise = std::min(width / 5, height / 2);
    // A chord of width w under an arc of rise r spans 2 atan2(2 r, w) to each side.
    return arched(width, height, rise, 2 * std::atan2(2 * rise, width), steps);
  }
  return {};
}

Polygon shape_l(double width, double depth, double front, double left) {
  if (!(front > 0 || left > 0)) return {};
  if (front > 0 && left > 0 && front < depth && left < width) {
    return loop_of({{0, 0}, {width, 0}, {width, front}, {left, front}, {left, depth}, {0, depth}});
  }
  return wings_of(width, depth, {.front = front, .left = left});
}

Polygon shape_u(double width, double depth, double front, double left, double right) {
  if (!(front > 0 || left > 0 || right > 0)) return {};
  if (front > 0 && left > 0 && right > 0 && front < depth && left + right < width) {
    const double inner = width - right;
    return loop_of({{0, 0},
                    {width, 0},
                    {width, depth},
                    {inner, depth},
                    {inner, front},
                    {left, front},
                    {left, depth},
                    {0, depth}});
  }
  return wings_of(width, depth, {.front = front, .right = right, .left = left});
}

Polygon shape_o(double width, double depth, double front, double right, double back, double left) {
  if (!(front > 0 || right > 0 || back > 0 || left > 0)) return {};
  return wings_of(width, depth, {.front = front, .right = right, .back = back, .left = left});
}

}  // namespace mansard
