#include "render/ray_scene.hpp"

#include <limits>
#include <map>

namespace mansard {
namespace {

constexpr Float3 ground_color{0.90F, 0.885F, 0.855F};
/// Metres; what is farther out is taken for an error in the input.
constexpr float farthest = 1e8F;

Float3 corner(const Scene& scene, std::size_t number) {
  return {scene.points[3 * number], scene.points[3 * number + 1], scene.points[3 * number + 2]};
}

bool is_drawable(Float3 a, Float3 b, Float3 c) {
  for (const Float3 p : {a, b, c}) {
    if (!is_finite(p) || std::abs(p.x) > farthest || std::abs(p.y) > farthest ||
        std::abs(p.z) > farthest) {
      return false;
    }
  }
  const Float3 normal = cross(b - a, c - a);
  return dot(normal, normal) > 1e-16F;
}

bool is_drawable(const Scene& scene, std::size_t triangle) {
  return is_drawable(corner(scene, 3 * triangle), corner(scene, 3 * triangle + 1),
                     corner(scene, 3 * triangle + 2));
}

/// Within 0..1, whatever was given.
Float3 valid_color(Vec3 color) {
  const auto valid = [](double c) {
    return std::isfinite(c) ? static_cast<float>(std::clamp(c, 0.0, 1.0)) : 0.5F;
  };
  return {valid(color.x), valid(color.y), valid(color.z)};
}

}  // namespace

RayScene::RayScene(const Scene& scene) {
  read_looks(scene);
  find_triangles(scene);
  read_triangles(scene);
  stand_on_ground();
}

RayScene::RayScene(const Scene& scene, const RayScene& frame) {
  read_looks(scene);
  find_triangles(scene);
  origin = frame.origin;
  read_triangles(scene);
  low = frame.low;
  high = frame.high;
  radius = frame.radius;
}

void RayScene::read_looks(const Scene& scene) {
  std::map<std::string, std::shared_ptr<const Texture>> textures;
  for (const Paint& paint : scene.paints) {
    Look next{valid_color(paint.color), paint.glass, nullptr};
    if (!paint.texture.empty()) {
      const auto [known, is_new] = textures.try_emplace(paint.texture);
      if (is_new) known->second = read_texture(paint.texture);
      next.texture = known->second;
      if (next.texture) next.color = next.texture->mean();
    }
    looks.push_back(next);
  }
  looks.push_back({valid_color(Paint{}.color), false, nullptr});
}

/// Those that can be drawn, and from their bounds the frame's origin.
void RayScene::find_triangles(const Scene& scene) {
  // The frame's origin is a whole number of metres, so that the shift itself rounds nothing.
  const std::size_t count = scene.points.size() / 9;
  constexpr float infinite = std::numeric_limits<float>::infinity();
  Float3 least{infinite, infinite, infinite}, most = -least;
  for (std::size_t t = 0; t < count; ++t) {
    if (!is_drawable(scene, t)) continue;
    source.push_back(static_cast<uint32_t>(t));
    for (std::size_t k = 3 * t; k < 3 * t + 3; ++k) {
      const Float3 p = corner(scene, k);
      least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
      most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
    }
  }
  if (source.empty()) return;
  origin = {std::round((least.x + most.x) / 2.0), least.y, std::round((least.z + most.z) / 2.0)};
}

void RayScene::read_triangles(const Scene& scene) {
  bool has_texture = false;
  for (const Look& l : looks) has_texture = has_texture || l.texture != nullptr;
  has_texture = has_texture && scene.uvs.size() * 3 >= scene.points.size() * 2;
  const auto no_paint = static_cast<uint32_t>(looks.size() - 1);
  for (const uint32_t t : source) {
    look.push_back(t < scene.paint.size() ? std::min(scene.paint[t], no_paint) : no_paint);
    face.push_back(t < scene.face.size() ? scene.face[t] : t);
    for (std::size_t k = 3 * std::size_t{t}; k < 3 * std::size_t{t} + 3; ++k) {
      const Float3 p = corner(scene, k);
      corners.push_back(to_float(Vec3{p.x, p.y, p.z} - origin));
      if (has_texture) uvs_.push_back({scene.uvs[2 * k], scene.uvs[2 * k + 1]});
    }
    if (!has_texture) continue;
    const std::size_t first = corners.size() - 3;
    const double area =
        length(cross(corners[first + 1] - corners[first], corners[first + 2] - corners[first]));
    const double uv_area =
        std::abs(cross(uvs_[first + 1] - uvs_[first], uvs_[first + 2] - uvs_[first]));
    uvs_a_metre_.push_back(static_cast<float>(std::sqrt(uv_area / area)));
  }
}

void RayScene::stand_on_ground() {
  if (source.empty()) {
    low = {-5, 0, -5};
    high = {5, 5, 5};
    return;
  }
  constexpr float infinite = std::numeric_limits<float>::infinity();
  low = {infinite, infinite, infinite};
  high = -low;
  for (const Float3 p : corners) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Float3 half = (high - low) * 0.5F;
  radius = std::max(1.0F, std::sqrt(half.x * half.x + half.z * half.z));
  // Floors that lie on the ground must win against it.
  const float gap = std::max(0.01F, 2e-5F * radius);
  for (Float3& p : corners) p.y += gap;
  low.y += gap;
  high.y += gap;
  origin.y -= gap;
}

Float3 RayScene::color_at(uint32_t triangle, float u, float v, float pixel) const {
  if (triangle == ground) return ground_color;
  const Look& seen = look_of(triangle);
  if (!seen.texture || uvs_.empty()) return seen.color;
  const Vec2* at = &uvs_[3 * std::size_t{triangle}];
  const Vec2 uv = at[0] + (at[1] - at[0]) * u + (at[2] - at[0]) * v;
  return seen.texture->at(uv, pixel * uvs_a_metre_[triangle]);
}

}  // namespace mansard
