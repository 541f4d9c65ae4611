#include "interpreter/corners.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace mansard {
namespace {

constexpr float straight = 180;
constexpr double degrees = 180 / 3.14159265358979323846;

/// Nothing turns there.
bool is_inside(EdgeTag beside) { return beside.has(EdgeTag::party) || beside.has(EdgeTag::cut); }

}  // namespace

double corner_angle(Vec2 along, Vec2 then) {
  return 180 - std::atan2(cross(along, then), dot(along, then)) * degrees;
}

void set_box_corners(Shape& wall, const Shape& box, int side) {
  if (side == 0 && (box.open & side_back)) return;
  const auto angle = [&](int beside) { return box.cuts & (1 << beside) ? straight : 90.0F; };
  wall.corner_left = side < 4 ? angle((side + 3) % 4) : straight;
  wall.corner_right = side < 4 ? angle((side + 1) % 4) : straight;
}

void set_prism_corners(Shape& wall, const Polygon& plan, Vec2 stretch, uint32_t i) {
  const auto ring = static_cast<std::size_t>(
      std::upper_bound(plan.ring_ends.begin(), plan.ring_ends.end(), i) - plan.ring_ends.begin());
  const uint32_t begin = plan.ring_begin(ring), end = plan.ring_ends[ring];
  const uint32_t before = i == begin ? end - 1 : i - 1, next = i + 1 == end ? begin : i + 1;
  const auto along = [&](uint32_t edge) {
    const Vec2 way = plan.points[edge + 1 == end ? begin : edge + 1] - plan.points[edge];
    return Vec2{way.x * stretch.x, way.y * stretch.y};
  };
  const auto angle = [&](uint32_t from, uint32_t to, uint32_t beside) {
    if (is_inside(plan.tags[beside])) return straight;
    return static_cast<float>(corner_angle(along(from), along(to)));
  };
  wall.corner_left = angle(before, i, before);
  wall.corner_right = angle(i, next, next);
}

namespace {

/// Places that are equal to a micrometre.
using Place = std::array<int64_t, 3>;
Place place_of(Vec3 p) {
  return {std::llround(p.x * 1e6), std::llround(p.y * 1e6), std::llround(p.z * 1e6)};
}

using Borders = std::map<std::pair<Place, Place>, std::size_t>;  ///< of directed edges: the face

/// `side` is 1 for the right end, where a face's loop leads up, and -1 for the left one.
float mesh_angle(std::span<const Shape> faces, std::size_t own, std::span<const Vec3> loop,
                 const Borders& borders, double side) {
  const Shape& wall = faces[own];
  double longest = 0;
  std::size_t at = loop.size();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 way = loop[(i + 1) % loop.size()] - loop[i];
    const double rise = side * dot(way, wall.scope.y);
    if (rise > longest && rise > 0.7 * length(way)) {
      longest = rise;
      at = i;
    }
  }
  if (at == loop.size()) return straight;
  const Vec3 from = loop[at], to = loop[(at + 1) % loop.size()];
  const auto known = borders.find({place_of(to), place_of(from)});
  if (known == borders.end() || is_inside(faces[known->second].tag)) return straight;
  const Vec3 normal = wall.scope.z, beside = faces[known->second].scope.z;
  const Vec3 up = normalized(to - from);
  return static_cast<float>(180 - std::atan2(dot(cross(normal, beside), up), dot(normal, beside)) *
                                      degrees);
}

}  // namespace

void set_mesh_corners(std::span<Shape> faces, std::span<const std::vector<Vec3>> loops) {
  Borders borders;
  for (std::size_t f = 0; f < loops.size(); ++f) {
    for (std::size_t i = 0; i < loops[f].size(); ++i) {
      borders.insert({{place_of(loops[f][i]), place_of(loops[f][(i + 1) % loops[f].size()])}, f});
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (std::abs(faces[f].scope.z.y) > 0.7) continue;  // no wall
    faces[f].corner_left = mesh_angle(faces, f, loops[f], borders, -1);
    faces[f].corner_right = mesh_angle(faces, f, loops[f], borders, 1);
  }
}

}  // namespace mansard
