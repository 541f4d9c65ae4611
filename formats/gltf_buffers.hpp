// The binary part of a glTF file and the accessors into it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/gltf_parts.hpp"
#include "formats/gltf_placed.hpp"
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
  uint64_t size() const { return count_; }
  uint64_t bytes() const { return spool_.bytes(); }
  void copy_to(OutputFile& out) { spool_.copy_to(out); }

 private:
  Spool spool_;
  uint64_t count_ = 0;
};

class GltfBuffers {
 public:
  GltfBuffers(const std::string& model, bool draco);

  /// Takes a primitive's bytes. Returns its members "attributes", "indices" and, for what Draco
  /// compressed, "extensions".
  std::string add(const GltfPart& part, std::string_view bytes);
  /// Takes places of instances. Returns the member "attributes" of EXT_mesh_gpu_instancing.
  std::string add(std::span<const GltfPlace> instances);
  /// How many views there are before those of pictures, when nothing more comes.
  std::size_t view_count() const { return draco_ ? views_.size() : order_.size(); }
  /// The document's bufferViews, those of pictures last. Once, when nothing more comes.
  GltfList& finish_views(std::span<const std::pair<uint64_t, uint64_t>> pictures);

  uint64_t bytes() const;
  void copy_to(OutputFile& out);
  /// Pictures, each from a multiple of four, behind all else.
  Spool& pictures() { return pictures_; }
  GltfList& accessors() { return accessors_; }
  const GltfList& accessors() const { return accessors_; }

 private:
  enum Kind : uint8_t { points, normals, indices, uvs, tangents, instances };
  std::size_t view_of(Kind kind);
  void add_view(uint64_t offset, uint64_t bytes, std::string_view rest);
  uint64_t add_vectors(Kind kind, std::string_view bytes, uint32_t width, const GltfPart& part);
  uint64_t add_indices(const GltfPart& part, std::string_view bytes);
  std::string add_draco(const GltfPart& part, std::string_view bytes);

  bool draco_;
  std::array<Spool, 6> kinds_;  ///< of primitives that are not compressed, and of instances
  std::vector<Kind> order_;     ///< of the kinds' views: as they first come
  Spool compressed_;            ///< a view each primitive
  Spool pictures_;
  GltfList views_, accessors_;
};

}  // namespace mansard
