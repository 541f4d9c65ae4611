#include "interpreter/outline.hpp"

#include <algorithm>

#include "geometry/clip.hpp"

namespace mansard {
namespace {

Polygon marked_rectangle(const Shape& shape) {
  Polygon plan = rectangle(shape.scope.size.x, shape.scope.size.y);
  constexpr uint8_t sides[] = {side_bottom, side_right, side_top, side_left};
  for (std::size_t i = 0; i < 4; ++i) {
    plan.tags[i] = {static_cast<uint16_t>(shape.tag.flags & ~EdgeTag::cut), shape.tag.wall};
    if (shape.cuts & sides[i]) plan.tags[i].flags |= EdgeTag::cut;
  }
  return plan;
}

}  // namespace

Polygon plan_of(const Machine& machine, const Shape& shape) {
  switch (shape.form) {
    case Form::rectangle:
      return marked_rectangle(shape);
    case Form::box:
      return rectangle(shape.scope.size.x, shape.scope.size.z);
    case Form::polygon:
    case Form::prism: {
      const PooledPolygon& pooled = machine.polygon_of(shape);
      const PlaneMap map(shape, pooled.natural);
      Polygon plan = pooled.polygon;
      for (Vec2& p : plan.points) p = map.scaled(p);
      return plan;
    }
    default:
      return {};
  }
}

void add_flat(Mesh& mesh, const Polygon& polygon, std::vector<uint32_t> numbers, EdgeTag tag,
              bool reversed) {
  const auto add = [&](std::vector<uint32_t> loop) {
    if (reversed) std::reverse(loop.begin(), loop.end());
    mesh.add_face(loop, tag);
  };
  if (!polygon.has_holes()) return add(std::move(numbers));
  const auto triangles = triangulate(polygon);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    add({numbers[triangles[i]], numbers[triangles[i + 1]], numbers[triangles[i + 2]]});
  }
}

}  // namespace mansard
