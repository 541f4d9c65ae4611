#include "interpreter/slice.hpp"

#include "geometry/clip.hpp"
#include "interpreter/outline.hpp"

namespace mansard {
namespace {

std::vector<Shape> polygon_slabs(Machine& machine, const Shape& shape, Axis axis, double low,
                                 double high) {
  const Polygon outline = plan_of(machine, shape);
  if (axis == Axis::z) {  // on the ground v runs against z
    const double depth = shape.scope.size.z;
    std::swap(low, high);
    low = depth - low;
    high = depth - high;
  }
  std::vector<Shape> pieces;
  for (Polygon& part : clip_strip(outline, axis == Axis::x ? 0 : 1, low, high)) {
    Shape piece = shape;
    machine.adopt(piece, std::move(part));
    pieces.push_back(piece);
  }
  return pieces;
}

std::vector<Shape> mesh_slabs(Machine& machine, const Shape& shape, Axis axis, double low,
                              double high) {
  const PooledMesh& pooled = machine.mesh_of(shape);
  Mesh scaled = pooled.mesh();
  const MeshMap map(pooled, shape.scope.size);
  for (Vec3& p : scaled.points) p = map(p);
  Vec3 direction;
  along(direction, axis) = 1;
  Mesh part = clip(clip(scaled, direction, high), -direction, -low);
  if (part.faces.empty()) return {};
  Shape piece = shape;
  machine.adopt(piece, std::move(part));
  return {piece};
}

}  // namespace

std::vector<Shape> slabs(Machine& machine, const Shape& shape, Axis axis, double low, double high) {
  if (shape.form == Form::mesh) return mesh_slabs(machine, shape, axis, low, high);
  return polygon_slabs(machine, shape, axis, low, high);
}

}  // namespace mansard
