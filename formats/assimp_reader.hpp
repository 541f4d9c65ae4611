// Assimp, for the process that reads meshes.
#pragma once

#include <string>

#include "formats/mesh_limits.hpp"
#include "geometry/mesh.hpp"

namespace mansard {

/// As one mesh in the root's frame. False on failure, with the reason in `problem`. Opens only what
/// `limits` allow. May throw, crash and never return.
bool read_by_assimp(const std::string& path, const MeshLimits& limits, Mesh& mesh,
                    std::string& problem);

}  // namespace mansard
