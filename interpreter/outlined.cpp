#include "interpreter/outlined.hpp"

#include "geometry/clip_outline.hpp"
#include "interpreter/outline.hpp"

namespace mansard {

bool cuts_meshes(const Shape& face) {
  constexpr double level = 0.9998;  // cosine of a degree
  return face.form == Form::polygon && !face.ground && std::abs(face.scope.z.y) < level;
}

Mesh outlined(const Machine& machine, const Shape& face, const PooledMesh& mesh, Vec3 size) {
  Mesh placed = mesh.mesh();
  const MeshMap map(mesh, size);
  for (Vec3& p : placed.points) p = map(p);
  return clip_by_outline(placed, plan_of(machine, face));
}

}  // namespace mansard
