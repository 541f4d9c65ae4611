// The door of the module mansard_draco.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace mansard {

/// Triangles for Draco, and what came of them.
struct DracoTriangles {
  enum class Kind : uint8_t { position, normal, uv, tangent };
  struct Attribute {
    Kind kind;
    std::span<const float> values;  ///< three a vertex, of uvs two, of tangents four
  };
  std::span<const Attribute> attributes;  ///< their numbers are Draco's ids
  std::span<const uint32_t> indices;
  // ---- what was encoded
  std::string bytes;
  uint32_t vertices = 0, triangles = 0;  ///< that the decoder will give
};

}  // namespace mansard

/// Places are rounded to a grid of 2^-13 m, the same for all that one origin has, so that no gaps
/// open between the parts of a building (finer for what is smaller than 8 m); texture coordinates
/// and tangents to 2^-12 of a repeat or of their length, normals to a tenth of a degree. False on
/// failure, with the reason in `problem`.
extern "C" bool mansard_encode_draco(mansard::DracoTriangles& triangles, std::string& problem);
