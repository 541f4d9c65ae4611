// Reading meshes for elements and `insert`.
#pragma once

#include <optional>
#include <string>

#include "formats/mesh_limits.hpp"
#include "geometry/mesh.hpp"

namespace mansard {

/// OBJ by tinyobjloader, everything else by Assimp; y up, as the file has it. On failure nothing,
/// and `problem` says why in a few words ("no such file", "line 3: face of unknown vertex").
std::optional<Mesh> read_mesh(const std::string& path, std::string& problem,
                              const MeshLimits& limits = {});

/// What was read as the house wants it: points at one place are one, crooked faces are divided,
/// those without an area are gone, a closed mesh looks outwards. Nothing where that can not be, or
/// nothing remains.
std::optional<Mesh> tidied(Mesh mesh, std::string& problem);

}  // namespace mansard
