// The primitives of one building as bytes for a glTF file.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "formats/gltf_primitive.hpp"

namespace mansard {

/// What its accessors say. Its bytes are, uncompressed: normals, positions, texture coordinates and
/// tangents as far as it has them, then indices and zeros up to a multiple of four.
struct GltfPart {
  uint32_t look = 0;
  uint64_t vertices = 0, corners = 0;  ///< corners of triangles, which are the indices
  bool uvs = false, tangents = false;
  std::array<float, 3> low{}, high{};
  std::size_t begin = 0;  ///< of its bytes

  /// As short as the vertices allow; 65535 is no index.
  bool short_indices() const { return vertices <= std::numeric_limits<uint16_t>::max(); }
};

/// Keeps its memory from building to building.
class GltfParts {
 public:
  explicit GltfParts(bool draco) : draco_(draco) {}
  void clear() {
    parts_.clear();
    bytes_.clear();
  }
  /// Throws Failure for what Draco can not compress.
  void add(const GltfPrimitive& primitive, uint32_t look);

  std::size_t size() const { return parts_.size(); }
  const GltfPart& operator[](std::size_t number) const { return parts_[number]; }
  std::string_view bytes(std::size_t number) const {
    const std::size_t begin = parts_[number].begin;
    const std::size_t end = number + 1 < size() ? parts_[number + 1].begin : bytes_.size();
    return {bytes_.data() + begin, end - begin};
  }

 private:
  void put(const void* bytes, std::size_t count);
  void add_plain(const GltfPrimitive& primitive);
  void add_draco(const GltfPrimitive& primitive, GltfPart& part);

  bool draco_;
  std::vector<GltfPart> parts_;
  std::vector<char> bytes_;
};

}  // namespace mansard
