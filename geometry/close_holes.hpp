// Closing meshes that are open where they stand.
#pragma once

#include "geometry/mesh.hpp"

namespace mansard {

/// Adds a face over each ring of edges that have a face on one side only: under a roof, a spire.
/// Points closer than a micrometre are one. The mesh must have no uvs. Edges that make no ring stay
/// as they are.
void close_holes(Mesh& mesh);

}  // namespace mansard
