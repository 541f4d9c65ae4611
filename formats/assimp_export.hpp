// The door of the module mansard_triangles.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace mansard {

/// Three numbers a vertex, three indices a triangle.
struct Triangles {
  std::span<const float> positions, normals;
  std::span<const uint32_t> indices;
};

}  // namespace mansard

/// The bytes of a file in the format of this Assimp name ("plyb", "stlb"). At least one triangle;
/// takes some 300 bytes of memory for each. False on failure, with the reason in `problem`.
extern "C" bool mansard_write_mesh(const char* format, const mansard::Triangles& triangles,
                                   std::string& bytes, std::string& problem);
