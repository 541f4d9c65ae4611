// The binary part of a glTF file and the accessors into it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "formats/gltf_primitive.hpp"
#include "formats/spool.hpp"

namespace mansard {

/// The items of one of the document's lists.
class GltfList {
 public:
  explicit GltfList(const std::string& model) : spool_(model) {}
  /// Returns the item's number.
  uint64_t add(std::string_view item) {
    if (count_ > 0) spool_.put(",");
    spool_.put(item);
    return count_++;
  }
  bool empty() const { return count_ == 0; }
  uint64_t bytes() const { return spool_.bytes(); }
  void copy_to(OutputFile& out) { spool_.copy_to(out); }

 private:
  Spool spool_;
  uint64_t count_ = 0;
};

class GltfBuffers {
 public:
  explicit GltfBuffers(const std::string& model);

  /// Takes the primitive's vertices and indices. Returns its members "attributes" and "indices".
  std::string add(const GltfPrimitive& primitive);
  /// How many views those of vertices and indices are, when nothing more comes.
  std::size_t vertex_views() const;
  /// The document's bufferViews, one after the other, those of pictures last; empty for none.
  std::string views(std::span<const std::pair<uint64_t, uint64_t>> pictures) const;

  uint64_t bytes() const;
  void copy_to(OutputFile& out);
  /// Pictures, each from a multiple of four, behind all vertices.
  Spool& pictures() { return pictures_; }
  GltfList& accessors() { return accessors_; }

 private:
  uint64_t add_vectors(std::size_t view, std::span<const float> values, uint32_t width,
                       const GltfPrimitive* bounded);
  uint64_t add_indices(const GltfPrimitive& primitive);

  std::array<Spool, 4> vertices_;  ///< by view
  Spool pictures_;
  GltfList accessors_;
};

}  // namespace mansard
