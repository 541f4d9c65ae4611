// Boxes to draw, and what their pictures show.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

#include "render/picture.hpp"

namespace mansard::test {

inline void add_quad(Surface& surface, Vec3 a, Vec3 b, Vec3 c, Vec3 d, uint32_t material) {
  surface.points.insert(surface.points.end(), {a, b, c, d});
  surface.uvs.insert(surface.uvs.end(), {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  surface.ends.push_back(static_cast<uint32_t>(surface.points.size()));
  surface.normals.push_back(normalized(cross(b - a, c - a)));
  surface.runs.push_back({0, material, static_cast<uint32_t>(surface.ends.size())});
}

/// A box from the origin to `size`; its front looks to +z.
inline Surface box(Vec3 size, uint32_t material = 0) {
  const double x = size.x, y = size.y, z = size.z;
  Surface surface;
  add_quad(surface, {0, 0, z}, {x, 0, z}, {x, y, z}, {0, y, z}, material);
  add_quad(surface, {x, 0, z}, {x, 0, 0}, {x, y, 0}, {x, y, z}, material);
  add_quad(surface, {x, 0, 0}, {0, 0, 0}, {0, y, 0}, {x, y, 0}, material);
  add_quad(surface, {0, 0, 0}, {0, 0, z}, {0, y, z}, {0, y, 0}, material);
  add_quad(surface, {0, y, z}, {x, y, z}, {x, y, 0}, {0, y, 0}, material);
  return surface;
}

inline Scene box_scene(Vec3 size, Paint paint = {}) {
  Scene scene;
  scene.paints.push_back(paint);
  scene.add(box(size));
  return scene;
}

inline PictureOptions small(int width = 96, int height = 64) {
  PictureOptions options;
  options.width = width;
  options.height = height;
  options.threads = 2;
  return options;
}

inline PictureOptions from(Vec3 eye, Vec3 target) {
  PictureOptions options = small();
  options.camera = {Camera::View::free, eye, target, 35};
  return options;
}

using Color = std::array<int, 3>;

/// The mean of 3 x 3 pixels about a place given in parts of the picture, from the top left.
inline Color color_at(const Picture& picture, double x, double y) {
  const int px = std::clamp(static_cast<int>(x * picture.width), 1, picture.width - 2);
  const int py = std::clamp(static_cast<int>(y * picture.height), 1, picture.height - 2);
  Color sum{};
  for (int k = 0; k < 9; ++k) {
    const int at = (py - 1 + k / 3) * picture.width + px - 1 + k % 3;
    for (int c = 0; c < 3; ++c) sum[c] += picture.rgb[static_cast<std::size_t>(3 * at + c)];
  }
  for (int& c : sum) c /= 9;
  return sum;
}

inline int brightness(Color c) { return c[0] + c[1] + c[2]; }

inline std::filesystem::path scratch(const std::string& name) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "mansard_test_render";
  std::filesystem::create_directories(folder);
  return folder / name;
}

}  // namespace mansard::test
