// Pictures on surfaces.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/float3.hpp"

namespace mansard {

/// A picture that repeats in both directions, with halved copies of itself so that it does not
/// flicker where a pixel covers much of it (Williams 1983, Pyramidal Parametrics).
class Texture {
 public:
  /// `colors` are linear, rows from the top; sizes at least 1.
  Texture(int width, int height, std::vector<Float3> colors);

  /// Bilinear within a level, linear between two. `uv` counts repeats, v upwards; `pixel` is the
  /// size of what is looked at, in repeats.
  Float3 at(Vec2 uv, float pixel) const;
  Float3 mean() const { return levels_.back().colors.front(); }

 private:
  struct Level {
    int width, height;
    std::vector<Float3> colors;
    Float3 at(Vec2 uv) const;
  };
  std::vector<Level> levels_;  ///< each half the size of the one before, down to 1 x 1
};

/// Null when the file is missing or is no picture.
std::shared_ptr<const Texture> read_texture(const std::string& path);
/// Likewise of a picture whose pixels are no colours but numbers: normals, roughness.
std::shared_ptr<const Texture> read_values(const std::string& path);
/// Both of a file's bytes.
std::shared_ptr<const Texture> decode_texture(const std::string& bytes);
std::shared_ptr<const Texture> decode_values(const std::string& bytes);

}  // namespace mansard
