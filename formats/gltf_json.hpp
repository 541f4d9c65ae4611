// What a glTF document says of itself and of a building.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/surface_writer.hpp"

namespace mansard {

/// Of a document, before its lists.
struct GltfHead {
  std::string comment;                       ///< a line each: style, seed, origin
  std::vector<std::string_view> extensions;  ///< without which nothing is where it belongs
  uint64_t bytes = 0;                        ///< of the binary part
  std::string uri;                           ///< where that is; empty: in the file itself
};

/// The document without its closing brace.
std::string json_text(const GltfHead& head);

/// A building's node, at `origin`, with its id, style and properties; without the closing brace.
std::string gltf_node(const NamedSurface& building, const Vec3& origin);

/// In quotes; bytes that are no UTF-8 are replaced.
std::string json_text(std::string_view text);

}  // namespace mansard
