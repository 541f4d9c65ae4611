// Terminals to surfaces.
#include <cmath>

#include "geometry/clip.hpp"
#include "interpreter/component.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/outlined.hpp"

namespace mansard {
namespace {

constexpr double thin = 1e-9;  ///< metres; faces thinner than this are no faces

/// A wall's frame folded over to a face that meets its plane at an angle, as paper would be: the
/// pattern runs on into reveals and over the sides of what stands out.
UvFrame folded(const UvFrame& wall, Vec3 on_face, Vec3 normal) {
  const Vec3 axis = normalized(cross(wall.normal, normal));
  const Vec3 across = cross(wall.normal, axis), face_across = cross(normal, axis);
  const auto turned = [&](Vec3 v) { return axis * dot(axis, v) + face_across * dot(across, v); };
  const double away = dot(wall.origin - on_face, wall.normal) / dot(face_across, wall.normal);
  const Vec3 edge = on_face + face_across * away;  // on both planes
  UvFrame frame = wall;
  frame.origin = edge - turned(edge - wall.origin);
  frame.u = turned(wall.u);
  frame.v = turned(wall.v);
  frame.normal = normal;
  // Moved off the wall the face meets it further along.
  const Vec3 off = wall.normal * ((1 - dot(across, face_across)) / dot(face_across, wall.normal));
  frame.shift_u = wall.u + off * dot(across, wall.u);
  frame.shift_v = wall.v + off * dot(across, wall.v);
  return frame;
}

/// What was drawn since `first` may have its like elsewhere: columns, sills, balusters. A texture
/// runs on over walls and so lies differently on each.
void remember_solid(Surface& surface, const Scope& s, const Material& look, uint32_t first) {
  constexpr uint32_t fewest = 4;  // polygons
  const auto end = static_cast<uint32_t>(surface.polygons());
  if (end - first < fewest || !look.texture.empty()) return;
  surface.placed.push_back({nullptr, s.origin, s.x, s.y, s.z, s.size, first, end});
}

}  // namespace

const Material& Machine::material(uint32_t number) const {
  const std::size_t shared = program.materials.size();
  return number < shared ? program.materials[number] : building->materials[number - shared];
}

uint32_t Machine::add_material(const Material& material) {
  reads |= read_bits::building;
  for (std::size_t i = 0; i < building->materials.size(); ++i) {
    if (building->materials[i] == material)
      return static_cast<uint32_t>(program.materials.size() + i);
  }
  building->materials.push_back(material);
  return static_cast<uint32_t>(program.materials.size() + building->materials.size() - 1);
}

/// A look chosen in the very rule that emitted the terminal beats Materials; one inherited from
/// above does not (as inline and inherited styles in CSS).
uint32_t Machine::look_of(const Shape& shape, uint32_t symbol) {
  const uint32_t table = program.styles[shape.style].materials[symbol];
  if (table == none) return shape.material;
  const bool direct = shape.look_by != Shape::none &&
                      (shape.look_by == shape.node || shape.look_by == nodes_[shape.node].parent);
  if (direct) return shape.material;
  return draw_material(table, shape);
}

/// One alternative by weight.
uint32_t Machine::draw_material(uint32_t table, const Shape& shape) {
  const MaterialTable& materials = program.material_tables[table];
  if (materials.materials.size() == 1) return materials.materials[0];
  reads |= materials.per == VariableSlot::Per::building ? read_bits::building : read_bits::chance;
  double draw =
      unit_interval(stream_of(materials.per, materials.per_symbol, shape, materials.salt)) *
      materials.total;
  std::size_t i = 0;
  while (i + 1 < materials.weights.size() && draw >= materials.weights[i])
    draw -= materials.weights[i++];
  return materials.materials[i];
}

void Machine::draw(const Shape& shape, uint32_t symbol) {
  check_reach(shape, symbol);
  const uint32_t elements = program.styles[shape.style].elements[symbol];
  if (elements != none && rules_of(shape) == none && draw_element(shape, elements)) return;
  if (program.stain_look != none) note_drip(shape, symbol);
  const uint32_t look = look_of(shape, symbol);
  const auto first = static_cast<uint32_t>(building->surface.polygons());
  switch (shape.form) {
    case Form::nothing:
    case Form::line:
      return;
    case Form::rectangle:
      draw_rectangle(shape.scope, texture_frame(shape, shape.scope, look), look);
      break;
    case Form::polygon:
      draw_polygon(shape, look, 0, false);
      break;
    case Form::box:
      draw_box(shape, look);
      remember_solid(building->surface, shape.scope, material(look), first);
      break;
    case Form::prism:
      draw_prism(shape, look);
      remember_solid(building->surface, shape.scope, material(look), first);
      break;
    case Form::mesh:
      draw_mesh(shape, look, mesh_of(shape), own_looks(mesh_of(shape).mesh()));
      if (!mesh_of(shape).borrowed && mesh_of(shape).own.materials.empty())
        remember_solid(building->surface, shape.scope, material(look), first);
      break;
  }
  close_run(symbol, look);
}

/// Beyond this no coordinate holds a micrometre, and far beyond normals are no numbers.
void Machine::check_reach(const Shape& shape, uint32_t symbol) {
  constexpr double furthest = 1e9;  // metres
  const auto within = [](Vec3 v) {
    return std::abs(v.x) <= furthest && std::abs(v.y) <= furthest && std::abs(v.z) <= furthest;
  };
  if (within(shape.scope.origin) && within(shape.scope.size)) return;
  fail({}, "'" + std::string(program.symbols[symbol]) + "' reaches further than a million km",
       "is a size, a height or a shift too large?");
}

void Machine::close_run(uint32_t symbol, uint32_t look) {
  Surface& surface = building->surface;
  const auto end = static_cast<uint32_t>(surface.polygons());
  const uint32_t begin = surface.runs.empty() ? 0 : surface.runs.back().end;
  if (begin == end) return;
  if (end / 16 > options.max_shapes) {
    fail({}, "more than " + std::to_string(options.max_shapes * 16) + " polygons in one building",
         "--max-shapes allows more");
  }
  add_run(symbol, look, end);
}

void Machine::add_run(uint32_t symbol, uint32_t look, uint32_t end) {
  std::vector<Surface::Run>& runs = building->surface.runs;
  if (!runs.empty() && runs.back().symbol == symbol && runs.back().material == look) {
    runs.back().end = end;
  } else {
    runs.push_back({symbol, look, end});
  }
}

/// From the face's lower left corner; on an upright face the height counts from the foot of the
/// building, so that the courses of all its walls are level.
UvFrame Machine::frame_on(const Scope& face) const {
  UvFrame frame{face.origin, face.x, face.y, face.z};
  frame.level = face.y.y > 1 - 1e-9;
  if (frame.level) frame.origin.y = base_elevation;
  return frame;
}

constexpr double near_enough = 0.7;  ///< cosine: planes at less than 45 degrees share a frame

/// The shape's texture frame, so that textures run on across splits; without one the face's own.
/// Only pictures are folded round corners.
UvFrame Machine::texture_frame(const Shape& shape, const Scope& face, uint32_t look) const {
  if (shape.uv_frame == Shape::none) return frame_on(face);
  const UvFrame& wall = uv_frames[shape.uv_frame];
  if (std::abs(dot(wall.normal, face.z)) > near_enough) return wall;
  if (!material(look).has_pictures()) return {face.origin, face.x, face.y, face.z};
  return folded(wall, face.origin, face.z);
}

/// Likewise of a polygon, which may lie askew in the shape's scope.
UvFrame Machine::texture_frame(const Shape& shape, std::span<const Vec3> loop, Vec3 normal,
                               uint32_t look) const {
  const bool framed = shape.uv_frame != Shape::none;
  UvFrame frame = framed ? uv_frames[shape.uv_frame] : frame_on(shape.scope);
  if (std::abs(dot(frame.normal, normal)) >= near_enough) return frame;
  if (framed && material(look).has_pictures()) return folded(frame, loop[0], normal);
  frame.u = frame.shift_u = normalized(loop[1] - loop[0]);
  frame.v = frame.shift_v = cross(normal, frame.u);
  return frame;
}

void Machine::push_face(std::span<const Vec3> loop, Vec3 normal, const UvFrame& frame,
                        uint32_t look) {
  Surface& surface = building->surface;
  const Vec2 metres = frame.in_repeats ? Vec2{1, 1} : material(look).metres;
  const Vec3 u = frame.u * (1 / metres.x), v = frame.v * (1 / metres.y);
  const std::size_t first = surface.points.size();
  surface.points.insert(surface.points.end(), loop.begin(), loop.end());
  surface.uvs.resize(first + loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 d = loop[i] - frame.origin;
    surface.uvs[first + i] = {dot(d, u), dot(d, v)};
  }
  surface.ends.push_back(static_cast<uint32_t>(surface.points.size()));
  surface.normals.push_back(normal);
  placer_.note_polygon(frame, metres);
}

/// Adds a planar polygon.
void Machine::push_polygon(std::span<const Vec3> loop, const Shape& shape, uint32_t look) {
  const Vec3 area = newell(loop);
  const double size = length(area);
  if (!(size > thin * thin)) return;
  const Vec3 normal = area * (1 / size);
  push_face(loop, normal, texture_frame(shape, loop, normal, look), look);
}

/// Most of what is ever drawn: the scope knows the normal.
void Machine::draw_rectangle(const Scope& s, const UvFrame& frame, uint32_t look) {
  if (s.size.x < thin || s.size.y < thin) return;
  const Vec3 right = s.x * s.size.x, up = s.y * s.size.y;
  std::array<Vec3, 4> loop{s.origin, s.origin + right, s.origin + right + up, s.origin + up};
  if (mirrored(s)) std::swap(loop[1], loop[3]);
  push_face(loop, s.z, frame, look);
}

/// `along` metres along the direction in which prisms are drawn.
void Machine::draw_polygon(const Shape& shape, uint32_t look, double along, bool reversed) {
  const PooledPolygon& pooled = polygon_of(shape);
  const PlaneMap map(shape, pooled.natural);
  const bool turned = reversed != mirrored(shape.scope);
  const auto place = [&](Vec2 p) { return shape.scope.at(map(p, along)); };
  const auto push = [&] {
    if (turned) std::reverse(loop_.begin(), loop_.end());
    push_polygon(loop_, shape, look);
  };
  if (!pooled.polygon.has_holes()) {
    loop_.clear();
    for (const Vec2 p : pooled.polygon.points) loop_.push_back(place(p));
    return push();
  }
  const auto triangles = triangulate(pooled.polygon);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    loop_.clear();
    for (std::size_t k = 0; k < 3; ++k)
      loop_.push_back(place(pooled.polygon.points[triangles[i + k]]));
    push();
  }
}

void Machine::draw_box(const Shape& shape, uint32_t look) {
  for (int side = 0; side < 6; ++side) {
    if (shape.open & (1 << side)) continue;
    const Scope face = box_side_scope(shape.scope, side);
    draw_rectangle(face, texture_frame(shape, face, look), look);
  }
}

void Machine::draw_prism(const Shape& shape, uint32_t look) {
  const uint32_t walls = prism_walls(*this, shape);
  for (uint32_t i = 0; i < walls; ++i) {
    const Scope wall = prism_wall(*this, shape, i).scope;
    draw_rectangle(wall, texture_frame(shape, wall, look), look);
  }
  draw_polygon(shape, look, prism_height(shape), false);
  if (!(shape.open & prism_base(shape))) draw_polygon(shape, look, 0, true);
}

/// Numbers of the materials that the mesh's own file gave it.
std::span<const uint32_t> Machine::own_looks(const Mesh& mesh) {
  looks_.clear();
  for (const Mesh::Material& m : mesh.materials) looks_.push_back(add_material(material_from(m)));
  return looks_;
}

void Machine::draw_mesh(const Shape& shape, uint32_t look, const PooledMesh& pooled,
                        std::span<const uint32_t> own_looks) {
  const Mesh& mesh = pooled.mesh();
  const Scope& s = shape.scope;
  const MeshMap map(pooled, s.size);
  const bool turned = mirrored(s);
  Surface& surface = building->surface;
  const auto first = static_cast<uint32_t>(surface.polygons());
  bool alike = pooled.borrowed;  // wherever it stands
  for (const Mesh::Face& face : mesh.faces) {
    loop_.clear();
    for (const uint32_t corner : mesh.loop(face)) {
      loop_.push_back(s.at(map(mesh.points[corner])));
    }
    if (turned) std::reverse(loop_.begin(), loop_.end());
    const bool own_look = face.material < own_looks.size();
    const uint32_t face_look = own_look ? own_looks[face.material] : look;
    alike = alike && (own_look || !material(look).has_pictures());
    const std::size_t before = surface.uvs.size();
    push_polygon(loop_, shape, face_look);
    if (own_look && !mesh.uvs.empty() && surface.uvs.size() > before) {
      placer_.forget_texture();
      for (std::size_t i = 0; i < loop_.size(); ++i) {
        surface.uvs[before + i] = mesh.uvs[turned ? face.end - 1 - i : face.begin + i];
      }
    }
    if (own_look) close_run(shape.symbol, face_look);
  }
  if (!alike) return;
  surface.placed.push_back({&mesh, s.at(map({})), s.x, s.y, s.z, map.scale(), first,
                            static_cast<uint32_t>(surface.polygons())});
}

/// One alternative by weight.
const ElementTable::Choice& Machine::choose_element(const ElementTable& table, const Shape& shape) {
  double draw = unit_interval(mix(shape.seed, hash_of("element"))) * table.total;
  std::size_t chosen = 0;
  while (chosen + 1 < table.choices.size() && draw >= table.choices[chosen].weight) {
    draw -= table.choices[chosen++].weight;
  }
  return table.choices[chosen];
}

/// One alternative, fitted to the scope and cut by its outline; a flat scope keeps the mesh's own
/// depth.
bool Machine::draw_element(const Shape& shape, uint32_t number) {
  const ElementTable& table = program.element_tables[number];
  if (table.choices.empty() || shape.form == Form::line) return false;
  if (table.choices.size() > 1) reads |= read_bits::chance;
  const ElementTable::Choice& choice = choose_element(table, shape);
  const std::size_t level = lod >= 3 ? 0 : choice.meshes.size() - 1;
  const Mesh* const mesh = choice.meshes[level];
  if (!mesh) return false;
  PooledMesh pooled;
  pooled.borrowed = mesh;
  const Box3 box = bounds(mesh->points);
  pooled.low = box.low;
  pooled.natural = box.size();
  Shape fitted = shape;
  if (fitted.scope.size.z < thin) fitted.scope.size.z = pooled.natural.z;
  if (program.stain_look != none) note_drip(fitted, shape.symbol);
  const uint32_t look = look_of(shape, shape.symbol);
  if (cuts_meshes(shape)) {
    pooled.own = outlined(*this, shape, pooled, fitted.scope.size);
    pooled.borrowed = nullptr;
    pooled.low = {};
    pooled.natural = fitted.scope.size;
  }
  draw_mesh(fitted, look, pooled, choice.materials[level]);
  close_run(shape.symbol, look);
  return true;
}

}  // namespace mansard
