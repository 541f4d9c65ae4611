// Moving, turning and sizing the scope.
#include <algorithm>
#include <cmath>

#include "geometry/solids.hpp"
#include "interpreter/component.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"

namespace mansard {
namespace {

/// Rodrigues: v turned about the unit axis by `angle` degrees.
Vec3 turned(Vec3 v, Vec3 axis, double angle) {
  const double a = angle * 3.14159265358979323846 / 180, c = std::cos(a), s = std::sin(a);
  return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

void turn(Scope& scope, Vec3 about, Vec3 axis, double angle) {
  if (angle == 0) return;
  scope.origin = about + turned(scope.origin - about, axis, angle);
  scope.x = turned(scope.x, axis, angle);
  scope.y = turned(scope.y, axis, angle);
  scope.z = turned(scope.z, axis, angle);
}

/// The shape's faces as a mesh in the world.
Mesh world_mesh(Context& c) {
  Mesh mesh;
  auto& faces = c.machine.scratch_shapes;
  const std::size_t first = faces.size();
  push_faces(c.machine, c.shape);
  for (std::size_t i = first; i < faces.size(); ++i) {
    const Scope& scope = faces[i].scope;
    add_flat(mesh, plan_of(c.machine, faces[i]), faces[i].tag, mirrored(scope), [&](Vec2 p) {
      return scope.at({p.x, p.y, 0});
    });
  }
  faces.resize(first);
  return mesh;
}

/// In a frame that lies or stands with it, a flat shape stays one.
bool stays_flat(Context& c, const Scope& frame) {
  if (c.shape.form != Form::rectangle && c.shape.form != Form::polygon) return false;
  const Shape face = c.shape.ground ? lying_face(c.shape) : c.shape;
  const Vec3 normal = face.scope.z;
  const bool lies = dot(frame.y, normal) > 1 - 1e-9, stands = dot(frame.z, normal) > 1 - 1e-9;
  if (mirrored(face.scope) || (!lies && !stands)) return false;
  Polygon plan = plan_of(c.machine, face);
  Scope scope = frame;
  scope.origin = face.scope.origin;
  for (Vec2& p : plan.points) {
    const Vec3 q = scope.to_local(face.scope.at({p.x, p.y, 0}));
    p = lies ? Vec2{q.x, -q.z} : Vec2{q.x, q.y};
  }
  c.shape.scope = scope;
  c.shape.form = Form::polygon;
  c.shape.ground = lies;
  c.shape.uv_frame = Shape::none;
  c.machine.adopt(c.shape, std::move(plan));
  return true;
}

/// A line keeps x along itself, and y as upright as that leaves it.
void stand_line(Scope& line) {
  const Vec3 y = Vec3{0, 1, 0} - line.x * line.x.y;
  if (length(y) < 1e-9) return;
  line.y = normalized(y);
  line.z = cross(line.x, line.y);
}

}  // namespace

namespace operation {

void t(Context& c, Length x, Length y, Length z) {
  Scope& scope = c.shape.scope;
  scope.origin = scope.at({x.metres(scope.size.x), y.metres(scope.size.y), z.metres(scope.size.z)});
}

/// About x, then the new y, then the new z, through the pivot.
void r(Context& c, double x, double y, double z) {
  Scope& scope = c.shape.scope;
  const Vec3 about = scope.at(c.shape.pivot);
  turn(scope, about, scope.x, x);
  turn(scope, about, scope.y, y);
  turn(scope, about, scope.z, z);
  c.shape.uv_frame = Shape::none;
}

void s(Context& c, Length x, Length y, Length z) {
  Vec3& size = c.shape.scope.size;
  const Vec3 asked{x.metres(size.x), y.metres(size.y), z.metres(size.z)};
  const double values[] = {asked.x, asked.y, asked.z};
  for (std::size_t i = 0; i < 3; ++i) {
    if (values[i] < 0) c.fail(i, "a size can not be negative, it is " + number_text(values[i]));
  }
  size = asked;
}

void center(Context& c, std::string_view axes) {
  Scope& scope = c.shape.scope;
  const Scope& around = *c.env.frame;
  const Vec3 middle = scope.to_local(around.at(around.size * 0.5));
  Vec3 move;
  for (const char axis : axes) {
    switch (axis | 0x20) {
      case 'x':
        move.x = middle.x - scope.size.x / 2;
        break;
      case 'y':
        move.y = middle.y - scope.size.y / 2;
        break;
      case 'z':
        move.z = middle.z - scope.size.z / 2;
        break;
      default:
        c.fail(0, "\"" + std::string(axes) + "\" names no axes", "write axes like \"xz\"");
    }
  }
  scope.origin = scope.at(move);
}

void mirror(Context& c, std::optional<std::string_view> axis) {
  Scope& scope = c.shape.scope;
  const std::string_view which = axis.value_or("x");
  if (which == "x" || which == "X") {
    scope.origin = scope.at({scope.size.x, 0, 0});
    scope.x = -scope.x;
  } else if (which == "y" || which == "Y") {
    scope.origin = scope.at({0, scope.size.y, 0});
    scope.y = -scope.y;
  } else if (which == "z" || which == "Z") {
    scope.origin = scope.at({0, 0, scope.size.z});
    scope.z = -scope.z;
  } else {
    c.fail(0, "\"" + std::string(which) + "\" is not an axis", "write \"x\", \"y\" or \"z\"");
  }
}

/// Another frame about the same geometry: "axes" stands y up and keeps the heading of x, "world"
/// has x east, "geometry" lays x along the first edge of the first face.
void align(Context& c, std::string_view to) {
  Mesh mesh = world_mesh(c);
  Scope scope;
  if (to == "axes") {
    const Vec3 x = c.shape.scope.x, flat{x.x, 0, x.z};
    if (length(flat) > 1e-9) scope.x = normalized(flat);
  } else if (to == "geometry") {
    if (!mesh.faces.empty()) {
      const auto loop = mesh.loop(mesh.faces[0]);
      scope.x = normalized(mesh.points[loop[1]] - mesh.points[loop[0]]);
    }
    if (std::abs(scope.x.y) > 0.999) scope.x = {1, 0, 0};
  } else if (to != "world") {
    c.fail(0, "\"" + std::string(to) + "\" is nothing to align to",
           "\"axes\", \"geometry\" or \"world\"");
  }
  if (c.shape.form == Form::line) return stand_line(c.shape.scope);
  scope.y = normalized(Vec3{0, 1, 0} - scope.x * scope.x.y);
  scope.z = cross(scope.x, scope.y);
  if (stays_flat(c, scope)) return;
  for (Vec3& p : mesh.points) p = scope.to_local(p);
  const Box3 box = bounds(mesh.points);
  scope.origin = scope.at(box.low);
  scope.size = box.size();
  c.shape.scope = scope;
  if (mesh.faces.empty()) return;
  c.shape.form = Form::mesh;
  c.shape.ground = false;
  c.shape.uv_frame = Shape::none;
  c.shape.geometry = c.machine.add_mesh(std::move(mesh));
}

void pivot(Context& c, Length x, Length y, Length z) {
  const Vec3 size = c.shape.scope.size;
  c.shape.pivot = {x.metres(size.x), y.metres(size.y), z.metres(size.z)};
}

}  // namespace operation
}  // namespace mansard
