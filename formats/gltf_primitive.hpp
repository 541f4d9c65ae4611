// Polygons as the triangles of a glTF primitive.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.hpp"

namespace mansard {

/// Vertices are shared where place, normal and texture agree. Keeps its memory from one primitive
/// to the next.
class GltfPrimitive {
 public:
  /// Tangents, for pictures of normals, need texture coordinates.
  void clear(bool with_uvs, bool with_tangents = false);
  /// A polygon of the surface, its points less `origin`. One without area is left out.
  void add(const Surface& surface, std::size_t polygon, Vec3 origin);

  bool empty() const { return indices_.empty(); }
  bool has_uvs() const { return with_uvs_; }
  std::span<const float> positions() const { return positions_; }
  std::span<const float> normals() const { return normals_; }
  std::span<const float> uvs() const { return uvs_; }
  /// Four numbers a vertex: where u grows, and 1, or -1 where the picture is mirrored.
  std::span<const float> tangents() const { return tangents_; }
  std::span<const uint32_t> indices() const { return indices_; }
  uint32_t vertices() const { return static_cast<uint32_t>(positions_.size() / 3); }
  std::array<float, 3> low() const { return low_; }
  std::array<float, 3> high() const { return high_; }

 private:
  using Vertex = std::array<float, 8>;
  uint32_t vertex(const Vertex& v);
  bool same(uint32_t number, const Vertex& v) const;

  bool with_uvs_ = false, with_tangents_ = false;
  std::vector<float> positions_, normals_, uvs_, tangents_;
  std::array<float, 4> tangent_{};  ///< of the polygon
  std::vector<uint32_t> indices_;
  std::vector<uint32_t> loop_;   ///< numbers of the polygon's vertices
  std::vector<uint32_t> slots_;  ///< of vertices by hash; a number of before age_ is free
  std::vector<uint32_t> slot_ages_;
  uint32_t age_ = 0;
  std::array<float, 3> low_{}, high_{};
};

}  // namespace mansard
