// Rays against the world's triangles and its ground.
#pragma once

#include <memory>

#include "render/ray_scene.hpp"

namespace mansard {

struct Hit {
  uint32_t triangle = RayScene::sky;
  float t = 0;         ///< in lengths of the ray's direction
  Float3 normal;       ///< unit length, towards where the ray came from
  float u = 0, v = 0;  ///< barycentric

  bool is_sky() const { return triangle == RayScene::sky; }
};

class Tracer {
 public:
  explicit Tracer(const RayScene& world);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  /// The first thing on the ray. Safe from many threads.
  Hit hit(Float3 from, Float3 direction) const;
  /// Likewise, but of surfaces that lie in one plane always the same one is seen: the one that
  /// faces the eye, and of those the last drawn.
  Hit see(Float3 from, Float3 direction) const;
  /// The stain just before what was hit on the same ray; sky for none.
  Hit stain_before(Float3 from, Float3 direction, const Hit& seen) const;
  /// Whether a triangle is in the way; the ground never is.
  bool is_blocked(Float3 from, Float3 direction) const;

 private:
  struct Embree;
  const RayScene& world_;
  std::unique_ptr<Embree> embree_;
  std::unique_ptr<Tracer> stains_;  ///< of the world's stains, when it has any
};

}  // namespace mansard
