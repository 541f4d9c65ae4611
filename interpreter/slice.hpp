// Cutting a shape into slabs along an axis of its scope.
#pragma once

#include <optional>
#include <vector>

#include "interpreter/axes.hpp"
#include "interpreter/machine.hpp"

namespace mansard {

/// Part i of n of a split along the axis (none: a diagonal), in the given round of its group.
inline void mark_part(Shape& piece, std::optional<Axis> axis, std::size_t i, std::size_t n,
                      std::size_t round) {
  piece.split_index = static_cast<uint32_t>(i);
  piece.split_count = static_cast<uint32_t>(n);
  piece.split_round = static_cast<uint32_t>(round);
  if (axis == Axis::y) piece.level = static_cast<uint32_t>(i);
}

/// From `low` to `high` metres along an axis. `length` is high - low but for rounding: the same for
/// parts of the same size wherever they lie.
struct Stretch {
  double low = 0, high = 0, length = 0;
};

/// Calls f(piece) for each piece of the shape within the stretch: one for rectangles and boxes,
/// maybe several for concave polygons. Sides that the cut makes are marked.
template <class F>
void for_each_slice(Machine& machine, const Shape& shape, Axis axis, const Stretch& stretch, F f);

/// True for forms that the scope alone describes along this axis, so that slicing moves numbers
/// only.
inline bool slices_by_scope(const Shape& shape, Axis axis) {
  switch (shape.form) {
    case Form::polygon:
      return false;
    case Form::prism:
      return axis == (shape.ground ? Axis::y : Axis::z);
    case Form::mesh:
      return false;
    default:
      return true;
  }
}

/// The slab of a shape that slices by its scope.
inline Shape slab(const Shape& shape, Axis axis, const Stretch& stretch) {
  constexpr double touch = 1e-9;
  Shape piece = shape;
  const Vec3 direction = axis == Axis::x   ? shape.scope.x
                         : axis == Axis::y ? shape.scope.y
                                           : shape.scope.z;
  const double whole = along(shape.scope.size, axis);
  piece.scope.origin = shape.scope.origin + direction * stretch.low;
  along(piece.scope.size, axis) = stretch.length;
  const uint8_t low_side = axis == Axis::x ? side_left : axis == Axis::y ? side_bottom : side_back;
  const uint8_t high_side = axis == Axis::x ? side_right : axis == Axis::y ? side_top : side_front;
  if (axis == Axis::x && stretch.low > touch) piece.corner_left = 180;  // inside (corners.hpp)
  if (axis == Axis::x && stretch.high < whole - touch) piece.corner_right = 180;
  if (stretch.low > touch) {
    piece.cuts |= low_side;
    piece.open &= static_cast<uint8_t>(~low_side);
  }
  if (stretch.high < whole - touch) {
    piece.cuts |= high_side;
    piece.open &= static_cast<uint8_t>(~high_side);
  }
  return piece;
}

/// The slabs of any other shape.
std::vector<Shape> slabs(Machine& machine, const Shape& shape, Axis axis, double low, double high);

template <class F>
void for_each_slice(Machine& machine, const Shape& shape, Axis axis, const Stretch& stretch, F f) {
  if (slices_by_scope(shape, axis)) {
    Shape piece = slab(shape, axis, stretch);
    f(piece);
  } else {
    for (Shape& piece : slabs(machine, shape, axis, stretch.low, stretch.high)) f(piece);
  }
}

}  // namespace mansard
