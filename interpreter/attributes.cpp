// What expressions can read of a shape.
#include <cmath>

#include "geometry/offset.hpp"
#include "interpreter/component.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/measure.hpp"

namespace mansard {
namespace {

double heading(Vec3 direction) {
  const double degrees = std::atan2(direction.x, -direction.z) * 180 / 3.14159265358979323846;
  return degrees < 0 ? degrees + 360 : degrees;
}

double slope_of(Vec3 normal) {
  return std::acos(std::min(1.0, std::abs(normal.y))) * 180 / 3.14159265358979323846;
}

}  // namespace

/// Flat shapes: of the shape itself; solids: of all their faces together, volumes by the divergence
/// theorem.
double Machine::measure(Attribute which, const Shape& shape) {
  const bool flat = shape.form == Form::rectangle || shape.form == Form::polygon;
  switch (which) {
    case Attribute::area:
      if (shape.form == Form::rectangle) return shape.scope.size.x * shape.scope.size.y;
      if (shape.form == Form::polygon) return mansard::area(plan_of(*this, shape));
      break;
    case Attribute::perimeter:
      return shape.form == Form::nothing ? 0 : mansard::perimeter(plan_of(*this, shape));
    case Attribute::inradius:
      if (shape.form == Form::rectangle)
        return std::min(shape.scope.size.x, shape.scope.size.y) / 2;
      return mansard::inradius(plan_of(*this, shape));
    case Attribute::edges:
      return shape.form == Form::mesh ? static_cast<double>(mesh_of(shape).mesh().faces.size())
                                      : static_cast<double>(plan_of(*this, shape).points.size());
    case Attribute::volume: {
      if (flat || shape.form == Form::nothing || shape.form == Form::line) return 0;
      if (shape.form == Form::box)
        return shape.scope.size.x * shape.scope.size.y * shape.scope.size.z;
      if (shape.form == Form::prism)
        return mansard::area(plan_of(*this, shape)) * prism_height(shape);
      break;
    }
    default:
      return 0;
  }
  const std::size_t first = scratch_shapes.size();
  Shape closed = shape;
  closed.open = 0;
  push_faces(*this, closed);
  double sum = 0;
  for (std::size_t i = first; i < scratch_shapes.size(); ++i) {
    const Shape face = scratch_shapes[i];
    const double size = face.form == Form::rectangle ? face.scope.size.x * face.scope.size.y
                                                     : mansard::area(plan_of(*this, face));
    sum += which == Attribute::area
               ? size
               : size * dot(face.scope.z, face.scope.origin - shape.scope.origin) / 3;
  }
  scratch_shapes.resize(first);
  return sum;
}

double Machine::attribute_number(Attribute which, const Shape& s) {
  switch (which) {
    case Attribute::width:
      return s.scope.size.x;
    case Attribute::height:
      return s.scope.size.y;
    case Attribute::depth:
      return s.scope.size.z;
    case Attribute::tx:
      return s.scope.origin.x;
    case Attribute::ty:
      return s.scope.origin.y;
    case Attribute::tz:
      return s.scope.origin.z;
    case Attribute::facing:
      return heading(s.scope.z);
    case Attribute::slope:
      return s.ground ? 0 : slope_of(s.scope.z);
    case Attribute::elevation:
      return s.scope.origin.y - base_elevation;
    case Attribute::split_index:
      return s.split_index;
    case Attribute::split_count:
      return s.split_count;
    case Attribute::split_round:
      return s.split_round;
    case Attribute::comp_index:
      return s.comp_index;
    case Attribute::comp_count:
      return s.comp_count;
    case Attribute::corner_left:
      return static_cast<double>(s.corner_left);
    case Attribute::corner_right:
      return static_cast<double>(s.corner_right);
    case Attribute::level:
      return s.level;
    case Attribute::index:
      return s.index;
    case Attribute::seed:
      return unit_interval(s.seed);
    default:
      return measure(which, s);
  }
}

Value Machine::attribute(Attribute which, const Shape* shape, uint32_t id) {
  if (!shape) fail(program.spans[id], "there is no shape to read here");
  reads |= 1u << static_cast<int>(which);
  if (measuring) measurer_->check_read(which, *shape, id);
  switch (which) {
    case Attribute::is_rectangle:
      return Value::of(shape->form == Form::rectangle ||
                       ((shape->form == Form::polygon || shape->form == Form::prism) &&
                        is_axis_rectangle(plan_of(*this, *shape), 1e-6)))
          .from(id);
    case Attribute::is_convex:
      return Value::of((shape->form != Form::polygon && shape->form != Form::prism) ||
                       mansard::is_convex(plan_of(*this, *shape)))
          .from(id);
    case Attribute::is_planar:
      return Value::of(shape->form == Form::rectangle || shape->form == Form::polygon).from(id);
    case Attribute::comp_name:
      return (shape->comp_name == Shape::none ? Value::of(std::string_view{})
                                              : Value::of(program.symbols[shape->comp_name]))
          .from(id);
    case Attribute::symbol:
      return Value::of_symbol(shape->symbol).from(id);
    case Attribute::index:
      if (std::isnan(shape->index)) {
        fail(program.spans[id], "the index of this shape is not set",
             "a symbol sets it where it is emitted: FLOOR[split.index]");
      }
      return Value::of(shape->index).from(id);
    default:
      return Value::of(attribute_number(which, *shape)).from(id);
  }
}

}  // namespace mansard
