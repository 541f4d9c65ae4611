// The lines of an OBJ.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "formats/numbers.hpp"
#include "formats/surface_writer.hpp"
#include "formats/text_buffer.hpp"

namespace mansard {

/// How many of each the file has; OBJ counts them from 1 through the whole file.
struct ObjCounts {
  uint64_t points = 0, uvs = 0, normals = 0;
};

class ObjText {
 public:
  explicit ObjText(Up up) : up_(up) {}

  void comment(std::string_view lines);
  /// Letters that readers stumble over become '_'.
  void name(std::string_view key, std::string_view name);
  void points(std::span<const Vec3> points);
  void uvs(std::span<const Vec2> uvs);
  void normal(const Vec3& normal);
  /// The surface's polygon; `normal` is the number of its normal in the file, and `before` counts
  /// what was there before the surface.
  void face(const Surface& surface, std::size_t polygon, uint64_t normal, const ObjCounts& before);
  void put(std::string_view text) { text_.put(text); }

  std::string_view text() const { return text_.text(); }
  void clear() { text_.clear(); }

 private:
  char* put_vector(char* to, Vec3 v) const;

  TextBuffer text_;
  Up up_;
  CountedText point_, uv_, normal_;  ///< of a corner
};

}  // namespace mansard
