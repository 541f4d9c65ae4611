// Assimp in a process of its own: on hostile files it may crash, run on or take all memory.
#pragma once

#include <optional>
#include <string>

#include "formats/mesh_limits.hpp"
#include "geometry/mesh.hpp"

namespace mansard {

/// Everything Assimp reads (glTF, GLB, FBX, COLLADA, PLY, ...) as one mesh in its root's frame. On
/// failure nothing, and `problem` says why.
std::optional<Mesh> read_apart(const std::string& path, const MeshLimits& limits,
                               std::string& problem);

}  // namespace mansard
