// Reading meshes for elements and `insert`.
#pragma once

#include <optional>
#include <string>

#include "geometry/mesh.hpp"

namespace mansard {

/// OBJ by tinyobjloader, everything else by Assimp; y up, as the file has it. On failure nothing,
/// and `problem` says why in a few words ("no such file", "line 3: face of unknown vertex").
std::optional<Mesh> read_mesh(const std::string& path, std::string& problem);

}  // namespace mansard
