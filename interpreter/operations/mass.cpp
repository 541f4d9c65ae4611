// Masses and relief.
#include <array>
#include <cmath>

#include "geometry/solids.hpp"
#include "interpreter/component.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/mitre.hpp"
#include "interpreter/operations/functions.hpp"

namespace mansard {
namespace {

void need_flat(Context& c) {
  if (is_flat(c.shape)) return;
  c.machine.fail(c.call.at,
                 "'" + std::string(c.call.operation->name) +
                     "' needs a flat shape, this one is a solid or has no surface",
                 "take its faces first: comp { side : A | top : B }");
}

double positive(Context& c, std::size_t i, double value) {
  if (value < 0) {
    c.fail(i, "'" + std::string(c.call.operation->parameter_name(i)) +
                  "' can not be negative, it is " + number_text(value));
  }
  return value;
}

/// A mass stands with y up, whichever way its base was held.
Shape raised(const Shape& base, double height) {
  Shape solid = base;
  if (!solid.ground && base.scope.z.y > 0.7071) {
    solid = standing_ground(base);
    solid.open = side_bottom;
  } else if (base.mass) {
    solid.open = side_bottom;
  }
  if (solid.ground) {
    solid.scope.size.y = height;
  } else {
    solid.scope.size.z = height;
    solid.open = side_back;
  }
  if (solid.form == Form::rectangle) {
    solid.form = Form::box;
    solid.ground = false;
  } else {
    solid.form = Form::prism;
  }
  if (rises(base)) solid.uv_frame = Shape::none;  // relief goes on with its wall's
  return solid;
}

}  // namespace

namespace operation {

void extrude(Context& c, double height, std::optional<std::string_view> corners) {
  positive(c, 0, height);
  if (corners && *corners != "square" && *corners != "mitre") {
    c.fail(1, "corners = \"" + std::string(*corners) + "\" is not known here",
           "write \"square\" or \"mitre\"");
  }
  need_flat(c);
  const bool mass = rises(c.shape), mitre = corners == "mitre";
  if (mass && mitre) {
    c.fail(1, "only bands on walls have mitred corners, and this lies flat",
           "take its walls first: comp { side : FACADE }");
  }
  if (height == 0 || (!mass && c.machine.lod <= 2)) return c.become(c.shape);
  if (auto band = mitre ? mitred(c.machine, c.shape, height) : std::nullopt) return c.become(*band);
  Shape solid = raised(c.shape, height);
  solid.massive = mass;
  if (mass) {
    solid.mass = true;
    if (c.machine.lod == 1) {
      c.machine.finish_early(solid);
      c.shape = solid;
      return;
    }
  }
  c.become(solid);
}

}  // namespace operation

namespace {

/// A face that the recess leaves around its inner face, looking into the opening.
Shape reveal(const Shape& outer, Vec3 origin, Vec3 x, Vec3 y, Vec2 size) {
  Shape face = outer;
  face.form = Form::rectangle;
  face.geometry = Shape::none;
  face.cuts = face.open = 0;
  face.tag = {};
  face.scope.origin = outer.scope.at(origin);
  face.scope.x = outer.scope.direction(x);
  face.scope.y = outer.scope.direction(y);
  face.scope.z = outer.scope.direction(cross(x, y));
  face.scope.size = {size.x, size.y, 0};
  return face;
}

/// Jambs keep y up, sill and lintel have y along the depth.
void rectangle_reveals(Context& c, double depth) {
  const double w = c.shape.scope.size.x, h = c.shape.scope.size.y;
  constexpr Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  std::array<Shape, 4> faces{reveal(c.shape, {0, 0, 0}, x, -z, {w, depth}),
                             reveal(c.shape, {w, 0, -depth}, z, y, {depth, h}),
                             reveal(c.shape, {0, h, -depth}, x, z, {w, depth}),
                             reveal(c.shape, {0, 0, 0}, -z, y, {depth, h})};
  for (Shape& face : faces) c.named_part(1, face);
}

void polygon_reveals(Context& c, double depth) {
  for_each_edge(plan_of(c.machine, c.shape), [&](uint32_t, Vec2 a, Vec2 b) {
    const Vec2 along = normalized(b - a);
    Shape face = reveal(c.shape, {b.x, b.y, -depth}, {-along.x, -along.y, 0}, {0, 0, 1},
                        {length(b - a), depth});
    c.named_part(1, face);
  });
}

}  // namespace

namespace operation {

void detrude(Context& c, double depth) {
  positive(c, 0, depth);
  need_flat(c);
  if (c.shape.ground) c.shape = lying_face(c.shape);
  Shape inner = c.shape;
  const bool moved = depth > 0 && c.machine.lod == 3;
  if (moved) inner.scope.origin = c.shape.scope.at({0, 0, -depth});
  c.named_part(0, inner);
  if (!moved || !c.wants(1)) return;
  c.shape.form == Form::rectangle ? rectangle_reveals(c, depth) : polygon_reveals(c, depth);
}

void taper(Context& c, double height) {
  positive(c, 0, height);
  need_flat(c);
  if (height == 0) return c.become(c.shape);
  if (!rises(c.shape) && c.machine.lod <= 2) return c.become(c.shape);
  Shape flat = c.shape.ground ? c.shape : standing_ground(c.shape);
  flat.geometry = c.machine.add_mesh(tapered(plan_of(c.machine, c.shape), height));
  flat.form = Form::mesh;
  flat.ground = false;
  flat.scope.size.y = height;
  flat.mass = flat.mass || rises(c.shape);
  flat.uv_frame = Shape::none;
  if (c.machine.lod == 1 && !c.shape.mass) {
    c.machine.finish_early(flat);
    c.shape = flat;
    return;
  }
  c.become(flat);
}

}  // namespace operation
}  // namespace mansard
