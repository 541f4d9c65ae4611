// Looks as the materials, textures and images of a glTF file.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "formats/spool.hpp"
#include "formats/surface_writer.hpp"

namespace mansard {

/// Numbers the looks that are used, in the order in which they come.
class GltfLooks {
 public:
  uint32_t material_of(uint32_t look);
  /// The members "materials", "textures" and "images" of the document, as far as there are any, as
  /// text. Pictures go into `pictures`, where there is one, as views from `first_view` on; else
  /// they are copied beside the model. Throws Failure for a picture that is neither PNG nor JPEG.
  std::string members(std::span<const Look> looks, const std::string& model, Spool* pictures,
                      std::size_t first_view);
  /// Of each picture in the spool: where it begins, and its bytes.
  std::span<const std::pair<uint64_t, uint64_t>> views() const { return views_; }

 private:
  std::vector<uint32_t> materials_;  ///< by look
  std::vector<uint32_t> used_;       ///< looks
  std::vector<std::pair<uint64_t, uint64_t>> views_;
};

/// A path as the relative address of a file beside the model.
std::string as_uri(std::string_view name);

}  // namespace mansard
