// Wavefront OBJ and its MTL as a mesh, by tinyobjloader.
#pragma once

#include <optional>
#include <string>
#include <vector>

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
std::optional<ObjFile> read_obj(const std::string& path, std::string& problem);

}  // namespace mansard
