// Meshes on faces that are no rectangles.
#pragma once

#include "interpreter/machine.hpp"

namespace mansard {

/// Whether meshes end at the outline of the face: on polygons that do not lie level. What lies
/// level carries meshes, whatever its outline.
bool cuts_meshes(const Shape& face);

/// The mesh as it stands in a scope of `size` at the face's own, ended at its outline.
Mesh outlined(const Machine& machine, const Shape& face, const PooledMesh& mesh, Vec3 size);

}  // namespace mansard
