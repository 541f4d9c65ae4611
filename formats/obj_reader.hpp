// Wavefront OBJ and its MTL as a mesh, by tinyobjloader.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "formats/mesh_limits.hpp"
#include "geometry/mesh.hpp"

namespace mansard {

struct ObjFile {
  struct Object {
    std::string name;             ///< of the `o` line, else of the `g` line; may be empty
    uint32_t begin = 0, end = 0;  ///< its faces
  };
  Mesh mesh;  ///< faces exactly as in the file, of three corners and more
  std::vector<Object> objects;
};

/// On failure nothing, and `problem` says why: "no such file", "line 3: face of unknown vertex".
std::optional<ObjFile> read_obj(const std::string& path, std::string& problem,
                                const MeshLimits& limits = {});
/// The same of a text whose MTL files and pictures lie in `folder`.
std::optional<ObjFile> read_obj_text(std::string content, const std::filesystem::path& folder,
                                     std::string& problem, const MeshLimits& limits = {});

}  // namespace mansard
