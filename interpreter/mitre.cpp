#include "interpreter/mitre.hpp"

#include <array>
#include <numbers>

#include "geometry/clip_outline.hpp"
#include "interpreter/outline.hpp"

namespace mansard {
namespace {

constexpr double on_border = 1e-6;  // metres

/// How far the front reaches beyond the end of a wall, below 0 in a niche; nothing where it is
/// square.
std::optional<double> reach(double depth, double angle) {
  if (angle == 180 || angle < 30 || angle > 330) return {};
  return depth / std::tan(angle * std::numbers::pi / 360);
}

/// Moves the border at x = `end` to x = `to` along the edges that meet it.
void extend(Polygon& outline, double end, double to) {
  const std::vector<uint32_t> next = next_points(outline);
  std::vector<uint32_t> before(next.size());
  for (uint32_t i = 0; i < next.size(); ++i) before[next[i]] = i;
  const std::vector<Vec2> points = outline.points;
  const auto is_border = [&](uint32_t i) { return std::abs(points[i].x - end) <= on_border; };
  for (uint32_t i = 0; i < points.size(); ++i) {
    if (!is_border(i) || is_border(before[i]) == is_border(next[i])) continue;
    const Vec2 inner = points[is_border(next[i]) ? before[i] : next[i]];
    const double rise = (points[i].y - inner.y) / (points[i].x - inner.x);
    outline.points[i] = {to, points[i].y + rise * (to - end)};
  }
  for (uint32_t i = 0; i < points.size(); ++i) {
    if (is_border(i) && is_border(before[i]) && is_border(next[i])) outline.points[i].x = to;
  }
}

struct End {
  double x = 0;                 ///< of the wall
  std::optional<double> reach;  ///< outwards
};

/// Front and sides of the prism; none at mitred ends.
Mesh band(const Polygon& outline, const std::array<double, 2>& ends,
          const std::array<End, 2>& walls, double depth, EdgeTag front) {
  Mesh mesh;
  const auto count = static_cast<uint32_t>(outline.points.size());
  for (const double z : {0.0, depth}) {
    for (const Vec2 p : outline.points) mesh.points.push_back({p.x, p.y, z});
  }
  const std::vector<uint32_t> next = next_points(outline);
  std::vector<uint32_t> numbers;
  for (uint32_t i = 0; i < count; ++i) {
    numbers.push_back(count + i);
    const auto at_end = [&](std::size_t end) {
      return walls[end].reach && std::abs(outline.points[i].x - ends[end]) <= on_border &&
             std::abs(outline.points[next[i]].x - ends[end]) <= on_border;
    };
    if (at_end(0) || at_end(1)) continue;
    mesh.add_face(std::array{i, next[i], count + next[i], count + i});
  }
  add_flat(mesh, outline, std::move(numbers), front, false);
  return mesh;
}

}  // namespace

std::optional<Shape> mitred(Machine& machine, const Shape& face, double depth) {
  if (std::abs(face.scope.z.y) > 1e-6 || std::abs(face.scope.y.y) < 1 - 1e-6) return {};
  const double width = face.scope.size.x;
  const std::array<End, 2> walls{End{0, reach(depth, face.corner_left)},
                                 End{width, reach(depth, face.corner_right)}};
  if (!walls[0].reach && !walls[1].reach) return {};
  Polygon outline = plan_of(machine, face);
  std::array<double, 2> ends{0, width};
  for (const std::size_t i : {0, 1}) {
    const double outwards = i == 0 ? -1 : 1;
    if (walls[i].reach && *walls[i].reach > 0) {
      ends[i] += outwards * *walls[i].reach;
      extend(outline, walls[i].x, ends[i]);
    }
  }
  Mesh mesh = band(outline, ends, walls, depth, face.tag);
  for (const std::size_t i : {0, 1}) {
    if (!walls[i].reach) continue;
    const double outwards = i == 0 ? -1 : 1;
    const Vec3 normal = normalized({outwards * depth, 0, -*walls[i].reach});
    mesh = clip_open(mesh, normal, normal.x * walls[i].x);
  }
  if (mesh.faces.empty()) return {};
  Shape solid = face;
  machine.adopt(solid, std::move(mesh));
  solid.cuts = 0;
  solid.open = side_back;
  solid.uv_frame = Shape::none;
  return solid;
}

}  // namespace mansard
