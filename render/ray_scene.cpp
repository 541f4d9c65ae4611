#include "render/ray_scene.hpp"

#include <algorithm>
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
  find_triangles(scene, Layer::surfaces);
  read_triangles(scene);
  stand_on_ground();
  read_stains(scene);
}

RayScene::RayScene(const Scene& scene, const RayScene& frame)
    : RayScene(scene, frame, Layer::surfaces) {
  read_stains(scene);
}

RayScene::RayScene(const Scene& scene, const RayScene& frame, Layer layer) {
  read_looks(scene);
  find_triangles(scene, layer);
  origin = frame.origin;
  read_triangles(scene);
  low = frame.low;
  high = frame.high;
  radius = frame.radius;
}

void RayScene::read_looks(const Scene& scene) {
  using Read = std::shared_ptr<const Texture> (*)(const std::string&);
  std::map<std::pair<std::string, Read>, std::shared_ptr<const Texture>> textures;
  const auto texture = [&](const std::string& path, Read read) {
    if (path.empty()) return std::shared_ptr<const Texture>();
    const auto [known, is_new] = textures.try_emplace({path, read});
    if (is_new) known->second = read(path);
    return known->second;
  };
  for (const Paint& paint : scene.paints) {
    const Finish& finish = paint.finish;
    const auto picture =
        paint.picture.empty()
            ? texture(paint.texture, paint.stains ? read_values : read_texture)
            : texture(paint.picture, paint.stains ? decode_values : decode_texture);
    looks.push_back({valid_color(picture ? paint.tint : paint.color), paint.glass, picture,
                     static_cast<float>(finish.roughness), static_cast<float>(finish.metallic),
                     static_cast<float>(finish.relief), texture(finish.roughness_map, read_values),
                     texture(finish.metallic_map, read_values),
                     texture(finish.normal_map, read_values)});
  }
  looks.push_back({valid_color(Paint{}.color), false, nullptr, 1, 0, 1, nullptr, nullptr, nullptr});
}

/// Those that can be drawn, and from their bounds the frame's origin.
void RayScene::find_triangles(const Scene& scene, Layer layer) {
  // The frame's origin is a whole number of metres, so that the shift itself rounds nothing.
  const std::size_t count = scene.points.size() / 9;
  constexpr float infinite = std::numeric_limits<float>::infinity();
  Float3 least{infinite, infinite, infinite}, most = -least;
  for (std::size_t t = 0; t < count; ++t) {
    const bool is_stain = t < scene.paint.size() && scene.paint[t] < scene.paints.size() &&
                          scene.paints[scene.paint[t]].stains;
    if (is_stain != (layer == Layer::stains) || !is_drawable(scene, t)) continue;
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
  for (const Look& l : looks)
    has_texture = has_texture || l.texture || l.roughness_map || l.metallic_map || l.normal_map;
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

void RayScene::read_stains(const Scene& scene) {
  if (std::ranges::none_of(scene.paints, &Paint::stains)) return;
  stains.reset(new RayScene(scene, *this, Layer::stains));
  if (stains->triangles() == 0) stains.reset();
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
  if (!seen.texture) return seen.color;
  if (uvs_.empty()) return seen.color * seen.texture->mean();
  return seen.color * seen.texture->at(uv_at(triangle, u, v), pixel * uvs_a_metre_[triangle]);
}

Vec2 RayScene::uv_at(uint32_t triangle, float u, float v) const {
  const Vec2* at = &uvs_[3 * std::size_t{triangle}];
  return at[0] + (at[1] - at[0]) * u + (at[2] - at[0]) * v;
}

RayScene::Gloss RayScene::gloss_at(uint32_t triangle, float u, float v, float pixel,
                                   Float3 normal) const {
  const Look& seen = look_of(triangle);
  Gloss gloss{seen.roughness, seen.metallic, normal};
  if (uvs_.empty()) return gloss;
  const Vec2 uv = uv_at(triangle, u, v);
  const float size = pixel * uvs_a_metre_[triangle];
  if (seen.roughness_map) gloss.roughness *= seen.roughness_map->at(uv, size).y;
  if (seen.metallic_map) gloss.metallic *= seen.metallic_map->at(uv, size).z;
  if (!seen.normal_map) return gloss;
  // The directions in which the picture runs on the surface, from the triangle's corners.
  const std::size_t first = 3 * std::size_t{triangle};
  const Float3 a = corners[first + 1] - corners[first], b = corners[first + 2] - corners[first];
  const Vec2 ua = uvs_[first + 1] - uvs_[first], ub = uvs_[first + 2] - uvs_[first];
  const double turn = cross(ua, ub);
  if (turn == 0) return gloss;
  const auto sign = static_cast<float>(turn > 0 ? 1 : -1);
  const Float3 right =
      normalized((a * static_cast<float>(ub.y) - b * static_cast<float>(ua.y)) * sign);
  const Float3 up =
      normalized((b * static_cast<float>(ua.x) - a * static_cast<float>(ub.x)) * sign);
  const Float3 leaning = seen.normal_map->at(uv, size);
  gloss.normal = normalized(normal + right * (seen.relief * (2 * leaning.x - 1)) +
                            up * (seen.relief * (2 * leaning.y - 1)));
  return gloss;
}

Float3 RayScene::stained(Float3 color, uint32_t triangle, float u, float v, float pixel) const {
  const Look& layer = stains->look_of(triangle);
  if (!layer.texture || stains->uvs_.empty()) return color;
  const Vec2 uv = stains->uv_at(triangle, u, v);
  const Float3 dark = layer.texture->at(uv, pixel * stains->uvs_a_metre_[triangle]);
  return mix(color, layer.color, dark.x);
}

}  // namespace mansard
