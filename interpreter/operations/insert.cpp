// Meshes and solids that fill the scope.
#include <algorithm>
#include <cmath>

#include "geometry/solids.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"
#include "interpreter/outlined.hpp"
#include "styles/library.hpp"

namespace mansard {
namespace {

constexpr std::string_view missing = "no such file";

void become_solid(Context& c, Mesh&& mesh) {
  c.shape.geometry = c.machine.add_mesh(std::move(mesh));
  c.shape.form = Form::mesh;
  c.shape.ground = false;
  c.shape.uv_frame = Shape::none;
  c.become(c.shape);
}

int sides_or(Context& c, std::optional<double> sides, int fallback) {
  if (!sides) return fallback;
  if (*sides < 3 || *sides > 256) {
    c.fail(0, "a round solid has 3 to 256 sides, not " + number_text(*sides));
  }
  return static_cast<int>(std::lround(*sides));
}

void need_size(Context& c) {
  const Vec3 s = c.shape.scope.size;
  if (s.x > 0 && s.y > 0 && s.z > 0) return;
  c.machine.fail(c.call.at, "a scope of " + size_text(s) + " holds no solid",
                 "give it a size first: s(1, 1, 1)");
}

/// Beside the script, then on the style path. `problem` is that of the first place that has it.
const Mesh* find_mesh(Context& c, const std::string& path, std::string& problem) {
  const std::string folder = Library::folder_of(c.call.at);
  const bool absolute = path.starts_with('/');
  const std::string beside = absolute || folder.empty() ? path : folder + "/" + path;
  const Program& program = c.machine.program;
  MeshSource& source = c.machine.mesh_source;
  if (const Mesh* mesh = source.mesh(beside, problem)) return mesh;
  if (absolute) return nullptr;
  for (const std::string& other : program.mesh_folders) {
    std::string elsewhere;
    const Mesh* const mesh = source.mesh(other + "/" + path, elsewhere);
    if (mesh) return mesh;
    if (problem == missing) problem = elsewhere;
  }
  return nullptr;
}

void end_at_outline(Context& c, const Shape& face) {
  Shape& shape = c.shape;
  Mesh left = outlined(c.machine, face, c.machine.mesh_of(shape), shape.scope.size);
  if (left.faces.empty()) {
    shape.form = Form::nothing;
    return;
  }
  shape.scope = face.scope;
  c.machine.adopt(shape, std::move(left));
}

}  // namespace

namespace operation {

void insert(Context& c, std::string_view path, std::optional<std::string_view> fit) {
  const Shape face = c.shape;
  put_mesh(c, path, fit);
  if (cuts_meshes(face)) end_at_outline(c, face);
  c.become(c.shape);
}

void put_mesh(Context& c, std::string_view path, std::optional<std::string_view> fit) {
  const std::string_view mode = fit.value_or("fit");
  if (mode != "fit" && mode != "keep" && mode != "keep_ratio") {
    c.fail(1, "\"" + std::string(mode) + "\" is no way to fit a mesh",
           "\"fit\", \"keep\" or \"keep_ratio\"");
  }
  std::string problem;
  const Mesh* const mesh = find_mesh(c, std::string(path), problem);
  if (!mesh) c.fail(0, "mesh \"" + std::string(path) + "\" can not be read: " + problem);
  Shape& shape = c.shape;
  shape.geometry = c.machine.borrow_mesh(*mesh);
  shape.form = Form::mesh;
  shape.ground = false;
  shape.uv_frame = Shape::none;
  const Vec3 natural = c.machine.mesh_of(shape).natural;
  Vec3& size = shape.scope.size;
  if (mode == "keep") size = natural;
  if (mode == "keep_ratio") {
    double scale = 1e300;
    if (size.x > 0 && natural.x > 0) scale = std::min(scale, size.x / natural.x);
    if (size.y > 0 && natural.y > 0) scale = std::min(scale, size.y / natural.y);
    if (size.z > 0 && natural.z > 0) scale = std::min(scale, size.z / natural.z);
    if (scale < 1e300) size = natural * scale;
  }
  if (size.x <= 0) size.x = natural.x;
  if (size.y <= 0) size.y = natural.y;
  if (size.z <= 0) size.z = natural.z;
}

void box(Context& c) {
  need_size(c);
  c.shape.massive = is_flat(c.shape) ? rises(c.shape) : is_solid(c.shape) && c.shape.massive;
  c.shape.form = Form::box;
  c.shape.geometry = Shape::none;
  c.shape.ground = false;
  c.shape.cuts = c.shape.open = 0;
  c.become(c.shape);
}

void quad(Context& c) {
  c.shape.form = Form::rectangle;
  c.shape.geometry = Shape::none;
  c.shape.ground = false;
  c.shape.scope.size.z = 0;
  c.become(c.shape);
}

void cylinder(Context& c, std::optional<double> sides) {
  need_size(c);
  become_solid(c, mansard::cylinder(c.shape.scope.size, sides_or(c, sides, 24)));
}

void sphere(Context& c, std::optional<double> sides) {
  need_size(c);
  become_solid(c, mansard::sphere(c.shape.scope.size, sides_or(c, sides, 24)));
}

void cone(Context& c, std::optional<double> sides) {
  need_size(c);
  become_solid(c, mansard::cone(c.shape.scope.size, sides_or(c, sides, 24)));
}

}  // namespace operation
}  // namespace mansard
