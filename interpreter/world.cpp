#include "interpreter/world.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/clip.hpp"
#include "geometry/close_holes.hpp"
#include "interpreter/component.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/surroundings.hpp"

namespace mansard {

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
  solids_.clear();
  blocks_.clear();
  last_section_.solid = Shape::none;
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
  last_section_.solid = Shape::none;
  std::erase_if(solids_, [&](const auto& known) { return known.first >= size; });
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

namespace {

Mesh mesh_in_world(const Machine& machine, const Shape& shape) {
  if (shape.form != Form::mesh) return to_mesh(prism_of(machine, shape));
  const PooledMesh& pooled = machine.mesh_of(shape);
  const MeshMap map(pooled, shape.scope.size);
  const bool turned = mirrored(shape.scope);
  Mesh mesh;
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

}  // namespace

SolidMesh& World::solid_of(const Machine& machine, uint32_t solid) {
  const auto [at, fresh] = solids_.try_emplace(solid);
  if (fresh) at->second = SolidMesh(mesh_in_world(machine, all_[solid].shape));
  return at->second;
}

SolidMesh& World::block_of(const Surroundings& around, uint32_t place) {
  const auto [at, fresh] = blocks_.try_emplace(place);
  if (fresh) at->second = SolidMesh(to_mesh(around.block(place)));
  return at->second;
}

std::vector<Polygon> World::section_of(const Machine& machine, uint32_t solid, const Scope& frame,
                                       double above) {
  const Shape& shape = all_[solid].shape;
  if (shape.form != Form::mesh) return section(prism_of(machine, shape), frame, above);
  const SolidMesh& mesh = solid_of(machine, solid);
  if (!mesh.is_large()) return section(mesh.mesh(), frame, above);
  return large_section(mesh, solid, frame, above);
}

/// Faces of one wall ask about one plane: its section is kept, in a frame that does not depend on
/// who asks first, and the part before each face is cut out.
std::vector<Polygon> World::large_section(const SolidMesh& mesh, uint32_t solid, const Scope& frame,
                                          double above) {
  constexpr double nanometre = 1e-9;
  const double at = std::round((dot(frame.z, frame.origin) + above) / nanometre) * nanometre;
  LastSection& last = last_section_;
  if (last.solid != solid || last.at != at || last.frame.x != frame.x || last.frame.y != frame.y) {
    last.solid = solid;
    last.at = at;
    last.frame = frame;
    last.frame.origin = frame.z * at;
    last.pieces = section(mesh.across(frame.z, at, nullptr), last.frame, 0);
  }
  const Vec3 from = last.frame.to_local(frame.origin);
  std::vector<Polygon> pieces;
  for (const Polygon& whole : last.pieces) {
    for (const Polygon& strip : clip_strip(whole, 0, from.x, from.x + frame.size.x)) {
      for (Polygon& piece : clip_strip(strip, 1, from.y, from.y + frame.size.y)) {
        translate(piece, {-from.x, -from.y});
        pieces.push_back(std::move(piece));
      }
    }
  }
  return pieces;
}

std::vector<Polygon> World::shadow_of(const Machine& machine, uint32_t solid, const Scope& frame,
                                      double low, double high, double beside) {
  const SolidMesh& mesh = solid_of(machine, solid);
  if (!mesh.is_large()) return shadow(mesh.mesh(), frame, low, high, beside);
  const Box3 box = grown(bounds_of(frame), std::max(beside, high));
  const double at = dot(frame.z, frame.origin) + high;
  return shadow(mesh.across(frame.z, at, &box), frame, low, high, beside);
}

}  // namespace mansard
