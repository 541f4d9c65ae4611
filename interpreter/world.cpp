#include "interpreter/world.hpp"

#include <algorithm>
#include <array>

#include "geometry/close_holes.hpp"
#include "interpreter/component.hpp"
#include "interpreter/machine.hpp"

namespace mansard {

bool is_solid(const Shape& shape) {
  return shape.form == Form::box || shape.form == Form::prism || shape.form == Form::mesh;
}

Box3 bounds_of(const Scope& scope) {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] =
        scope.at({i & 1 ? scope.size.x : 0, i & 2 ? scope.size.y : 0, i & 4 ? scope.size.z : 0});
  }
  return bounds(corners);
}

void World::clear() {
  all_.clear();
  meshes_.clear();
}

uint32_t World::add(const Shape& shape, bool active) {
  all_.push_back({shape, bounds_of(shape.scope), active});
  return size() - 1;
}

void World::freeze() {
  boxes_.clear();
  for (const Occluder& occluder : all_) boxes_.push_back(occluder.box);
  index_.build(boxes_);
}

void World::go_back(uint32_t size, uint32_t frozen_then) {
  std::erase_if(meshes_, [&](const auto& known) { return known.first >= size; });
  all_.resize(size);
  if (frozen() == frozen_then) return;
  boxes_.resize(frozen_then);
  for (uint32_t i = 0; i < frozen_then; ++i) boxes_[i] = all_[i].box;
  index_.build(boxes_);
}

bool World::is_above(uint32_t solid, uint32_t of) const {
  for (; of != Shape::none; of = all_[of].shape.solid) {
    if (of == solid) return true;
  }
  return false;
}

namespace {

/// A box stands on its base, so that walls cut it along its axis.
Prism prism_of(const Machine& machine, const Shape& shape) {
  const Scope& s = shape.scope;
  Prism prism;
  if (shape.form == Form::prism && !shape.ground) {
    prism = {s.origin, s.x, s.y, s.z, plan_of(machine, shape), s.size.z};
  } else {
    prism = {s.at({0, 0, s.size.z}), s.x, -s.z, s.y, plan_of(machine, shape), s.size.y};
  }
  return prism;
}

}  // namespace

const Mesh& World::mesh_of(const Machine& machine, uint32_t solid) {
  const auto [at, fresh] = meshes_.try_emplace(solid);
  if (!fresh) return at->second;
  const Shape& shape = all_[solid].shape;
  if (shape.form != Form::mesh) {
    at->second = to_mesh(prism_of(machine, shape));
    return at->second;
  }
  const PooledMesh& pooled = machine.mesh_of(shape);
  const MeshMap map(pooled, shape.scope.size);
  const bool turned = mirrored(shape.scope);
  Mesh& mesh = at->second;
  for (const Vec3 p : pooled.mesh().points) mesh.points.push_back(shape.scope.at(map(p)));
  std::vector<uint32_t> loop;
  for (const Mesh::Face& face : pooled.mesh().faces) {
    const auto corners = pooled.mesh().loop(face);
    loop.assign(corners.begin(), corners.end());
    if (turned) std::reverse(loop.begin(), loop.end());
    mesh.add_face(loop);
  }
  close_holes(mesh);
  return mesh;
}

std::vector<Polygon> World::section_of(const Machine& machine, uint32_t solid, const Scope& frame,
                                       double above) {
  const Shape& shape = all_[solid].shape;
  if (shape.form != Form::mesh) return section(prism_of(machine, shape), frame, above);
  return section(mesh_of(machine, solid), frame, above);
}

std::vector<Polygon> World::shadow_of(const Machine& machine, uint32_t solid, const Scope& frame,
                                      double low, double high, double beside) {
  return shadow(mesh_of(machine, solid), frame, low, high, beside);
}

}  // namespace mansard
