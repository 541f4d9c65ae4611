// The scene made ready for rays: only triangles that can be drawn, shifted near zero (so that
// single precision is enough), standing on a ground plane at height zero.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/float3.hpp"
#include "render/picture.hpp"
#include "render/texture.hpp"

namespace mansard {

struct RayScene {
  /// Triangle numbers that are not triangles.
  static constexpr uint32_t sky = 0xffffffff, ground = 0xfffffffe;

  struct Look {
    Float3 color;  ///< linear, colours the texture
    bool glass = false;
    std::shared_ptr<const Texture> texture;  ///< null for none
    float roughness = 1, metallic = 0, relief = 1;
    std::shared_ptr<const Texture> roughness_map, metallic_map, normal_map;  ///< null for none
  };
  /// How a place of a surface shines.
  struct Gloss {
    float roughness, metallic;
    Float3 normal;  ///< leaning as the picture of normals says
  };

  std::vector<Float3> corners;       ///< three a triangle, in the world's frame
  std::vector<uint32_t> source;      ///< number of the scene's triangle, ascending
  std::vector<uint32_t> look;        ///< one a triangle, into looks
  std::vector<uint32_t> face;        ///< one a triangle
  std::vector<Look> looks;           ///< the last is for triangles without a paint
  Vec3 origin;                       ///< of this frame, in the scene's
  std::unique_ptr<RayScene> stains;  ///< those of the scene, in the same frame; null for none
  Float3 low, high;                  ///< bounds of corners; low.y is just above 0
  float radius = 10;                 ///< metres from the middle of the bounds, on the ground

  explicit RayScene(const Scene& scene);
  /// In the frame of another world: on its ground, in its light, seen by its lenses.
  RayScene(const Scene& scene, const RayScene& frame);

  std::size_t triangles() const { return source.size(); }
  Float3 middle() const { return (low + high) * 0.5F; }
  Float3 to_world(Vec3 p) const { return to_float(p - origin); }

  /// The surface's colour where a pixel sees it: `u` and `v` are barycentric, `pixel` the size in
  /// metres of what the pixel covers.
  Float3 color_at(uint32_t triangle, float u, float v, float pixel) const;
  /// Likewise; `normal` is the plain surface's. Not of the ground.
  Gloss gloss_at(uint32_t triangle, float u, float v, float pixel, Float3 normal) const;
  /// The same for a surface of this colour behind one of `stains`.
  Float3 stained(Float3 color, uint32_t triangle, float u, float v, float pixel) const;
  const Look& look_of(uint32_t triangle) const { return looks[look[triangle]]; }

 private:
  enum class Layer : uint8_t { surfaces, stains };
  RayScene(const Scene& scene, const RayScene& frame, Layer layer);
  void read_stains(const Scene& scene);
  void read_looks(const Scene& scene);
  Vec2 uv_at(uint32_t triangle, float u, float v) const;
  void find_triangles(const Scene& scene, Layer layer);
  void read_triangles(const Scene& scene);
  void stand_on_ground();

  std::vector<Vec2> uvs_;           ///< three a triangle, empty when nothing has a texture
  std::vector<float> uvs_a_metre_;  ///< one a triangle, likewise
};

}  // namespace mansard
