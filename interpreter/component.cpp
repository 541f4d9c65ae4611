#include "interpreter/component.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/clip.hpp"
#include "interpreter/corners.hpp"

namespace mansard {
namespace {

/// A frame given within another one.
Scope within(const Scope& outer, Vec3 origin, Vec3 x, Vec3 y, Vec3 z, Vec3 size) {
  return {outer.at(origin), outer.direction(x), outer.direction(y), outer.direction(z), size};
}

/// The parent's attributes with another frame and no geometry yet.
Shape piece_of(const Shape& parent, const Scope& scope) {
  Shape piece = parent;
  piece.scope = scope;
  piece.form = Form::rectangle;
  piece.ground = false;
  piece.geometry = Shape::none;
  piece.cuts = 0;
  piece.open = 0;
  piece.corner_left = piece.corner_right = 180;
  return piece;
}

}  // namespace

Scope box_side_scope(const Scope& box, int side) {
  const auto [w, h, d] = box.size;
  constexpr Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  switch (side) {
    case 0:
      return within(box, {0, 0, d}, x, y, z, {w, h, 0});
    case 1:
      return within(box, {w, 0, d}, -z, y, x, {d, h, 0});
    case 2:
      return within(box, {w, 0, 0}, -x, y, -z, {w, h, 0});
    case 3:
      return within(box, {0, 0, 0}, z, y, -x, {d, h, 0});
    case 4:
      return within(box, {0, h, d}, x, -z, y, {w, d, 0});
    default:
      return within(box, {0, 0, 0}, x, z, -y, {w, d, 0});
  }
}

Shape box_side(const Shape& box, int side) {
  Shape face = piece_of(box, box_side_scope(box.scope, side));
  if (side != 0) face.tag = {};  // a relief's front is the wall it rose from, its sides are not
  if (box.cuts & (1 << side)) face.tag.flags |= EdgeTag::cut;
  if (side == 0) face.corner_left = box.corner_left, face.corner_right = box.corner_right;
  set_box_corners(face, box, side);
  return face;
}

double prism_height(const Shape& prism) {
  return prism.ground ? prism.scope.size.y : prism.scope.size.z;
}

uint32_t prism_walls(const Machine& machine, const Shape& prism) {
  return static_cast<uint32_t>(machine.polygon_of(prism).polygon.points.size());
}

Shape prism_wall(Machine& machine, const Shape& prism, uint32_t i) {
  const PooledPolygon& pooled = machine.polygon_of(prism);
  const Polygon& polygon = pooled.polygon;
  const PlaneMap map(prism, pooled.natural);
  const auto ring = static_cast<std::size_t>(
      std::upper_bound(polygon.ring_ends.begin(), polygon.ring_ends.end(), i) -
      polygon.ring_ends.begin());
  const uint32_t next = i + 1 == polygon.ring_ends[ring] ? polygon.ring_begin(ring) : i + 1;
  const Vec2 from = map.scaled(polygon.points[i]), to = map.scaled(polygon.points[next]);
  const double wide = length(to - from);
  const Vec2 along = normalized(to - from);
  const Vec3 x = map.direction(along), z = map.direction(left_of(along) * -1);
  const Vec3 y = prism.ground ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 size{wide, prism_height(prism), 0};
  Shape wall = piece_of(prism, within(prism.scope, map(polygon.points[i], 0), x, y, z, size));
  wall.tag = polygon.tags[i];
  if (!prism.ground) wall.tag = {static_cast<uint16_t>(wall.tag.flags & EdgeTag::cut)};
  if (prism.ground && machine.program.reads_corners)
    set_prism_corners(wall, polygon, map.scaled({1, 1}), i);
  return wall;
}

Shape lying_face(const Shape& flat) {
  Shape face = flat;
  face.ground = false;
  face.scope.origin = flat.scope.at({0, 0, flat.scope.size.z});
  face.scope.y = -flat.scope.z;
  face.scope.z = flat.scope.y;
  face.scope.size = {flat.scope.size.x, flat.scope.size.z, 0};
  return face;
}

Shape standing_ground(const Shape& face) {
  Shape flat = face;
  flat.ground = true;
  flat.scope.origin = face.scope.at({0, face.scope.size.y, 0});
  flat.scope.y = face.scope.z;
  flat.scope.z = -face.scope.y;
  flat.scope.size = {face.scope.size.x, 0, face.scope.size.y};
  return flat;
}

Shape face_of(Machine& machine, const Shape& parent, std::span<const Vec3> loop,
              std::span<const std::vector<Vec3>> holes, EdgeTag tag,
              std::span<const EdgeTag> edges) {
  Shape face = parent;
  const Vec3 normal = normalized(newell(loop));
  // A face that lies flat keeps the parent's x; any other has y up the face.
  if (std::abs(normal.y) > 1 - 1e-9) {
    face.scope.x = normalized(parent.scope.x - normal * dot(parent.scope.x, normal));
    face.scope.y = cross(normal, face.scope.x);
  } else {
    face.scope.y = normalized(Vec3{0, 1, 0} - normal * normal.y);
    face.scope.x = cross(face.scope.y, normal);
  }
  face.scope.z = normal;
  face.scope.origin = loop[0];
  face.scope.size = {0, 0, 0};
  face.form = Form::polygon;
  face.ground = false;
  face.cuts = face.open = 0;
  face.corner_left = face.corner_right = 180;
  face.tag = tag;
  Polygon polygon;
  const auto add_ring = [&](std::span<const Vec3> ring) {
    for (const Vec3& p : ring) {
      const Vec3 local = face.scope.to_local(p);
      const std::size_t i = polygon.points.size();
      polygon.add_point({local.x, local.y}, i < edges.size() ? edges[i] : tag);
    }
    polygon.close_ring();
  };
  add_ring(loop);
  for (const auto& hole : holes) add_ring(hole);
  machine.adopt(face, std::move(polygon));
  machine.frame_uvs(face);
  return face;
}

namespace {

void push_mesh_faces(Machine& machine, const Shape& shape) {
  const PooledMesh& pooled = machine.mesh_of(shape);
  const MeshMap map(pooled, shape.scope.size);
  const std::size_t first = machine.scratch_shapes.size();
  std::vector<std::vector<Vec3>> loops;
  std::vector<Vec3> loop;
  for (const Mesh::Face& f : pooled.mesh().faces) {
    loop.clear();
    for (const uint32_t corner : pooled.mesh().loop(f)) {
      loop.push_back(shape.scope.at(map(pooled.mesh().points[corner])));
    }
    if (mirrored(shape.scope)) std::reverse(loop.begin(), loop.end());
    if (length(newell(loop)) <= 1e-12) continue;
    machine.scratch_shapes.push_back(face_of(machine, shape, loop, {}, f.tag));
    if (machine.program.reads_corners) loops.push_back(loop);
  }
  if (!machine.program.reads_corners) return;
  const auto faces = std::span(machine.scratch_shapes).subspan(first);
  set_mesh_corners(faces, loops);
  if (!(shape.open & side_back)) return;
  for (Shape& face : faces) {  // a relief's front keeps the corners of the wall that it rose from
    if (dot(face.scope.z, shape.scope.z) < 1 - 1e-9) continue;
    face.corner_left = shape.corner_left;
    face.corner_right = shape.corner_right;
  }
}

void push_framed(Machine& machine, Shape face) {
  if (face.uv_frame == Shape::none) machine.frame_uvs(face);  // relief goes on with its wall's
  machine.scratch_shapes.push_back(face);
}

/// Walls in the order of the edges, then the cap, then the base.
void push_prism_faces(Machine& machine, const Shape& shape) {
  for (uint32_t i = 0, n = prism_walls(machine, shape); i < n; ++i) {
    push_framed(machine, prism_wall(machine, shape, i));
  }
  Shape cap = shape;
  cap.form = Form::polygon;
  cap.open = cap.cuts = 0;
  if (shape.ground) {
    cap.tag = {};
    cap.corner_left = cap.corner_right = 180;
  }
  const uint8_t far_side = shape.ground ? side_top : side_front;
  if (shape.cuts & far_side) cap.tag.flags |= EdgeTag::cut;
  if (shape.ground) {
    cap.scope.origin = shape.scope.at({0, shape.scope.size.y, 0});
    cap.scope.size.y = 0;
    cap = lying_face(cap);
  } else {
    cap.scope.origin = shape.scope.at({0, 0, shape.scope.size.z});
    cap.scope.size.z = 0;
  }
  push_framed(machine, cap);
  if (!(shape.open & prism_base(shape))) {
    const PooledPolygon& pooled = machine.polygon_of(shape);
    Shape base = cap;
    base.tag = {};
    base.corner_left = base.corner_right = 180;
    if (shape.cuts & prism_base(shape)) base.tag.flags = EdgeTag::cut;
    const double w = shape.scope.size.x;
    const double along = prism_height(shape);
    base.scope.origin = cap.scope.at({w, 0, -along});
    base.scope.x = -cap.scope.x;
    base.scope.z = -cap.scope.z;
    PooledPolygon& turned = machine.new_polygon(base);
    turned = pooled;  // into the pool's memory
    mirror_u(turned.polygon);
    translate(turned.polygon, {pooled.natural.x, 0});
    push_framed(machine, base);
  }
}

}  // namespace

void push_faces(Machine& machine, const Shape& shape) {
  auto& out = machine.scratch_shapes;
  switch (shape.form) {
    case Form::nothing:
    case Form::line:
      break;
    case Form::rectangle:
      out.push_back(shape);
      break;
    case Form::polygon:
      out.push_back(shape.ground ? lying_face(shape) : shape);
      break;
    case Form::box:
      for (int side = 0; side < 6; ++side) {
        if (!(shape.open & (1 << side))) push_framed(machine, box_side(shape, side));
      }
      break;
    case Form::prism:
      push_prism_faces(machine, shape);
      break;
    case Form::mesh:
      push_mesh_faces(machine, shape);
      break;
  }
}

}  // namespace mansard
