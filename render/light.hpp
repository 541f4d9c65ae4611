// Sun, sky and what they do to surfaces.
#pragma once

#include <cstdint>

#include "render/trace.hpp"

namespace mansard {

/// Light from a direction in which nothing is in the way (unit length).
Float3 sky_light(Float3 direction);

/// Well-spread numbers for a pixel: a block of 4 x 4 pixels shares one sequence (Roberts's R2), of
/// which every pixel takes its own part, so that blurring within a block averages an even spread.
class Spread {
 public:
  Spread(int x, int y, int samples);
  struct Spot {
    float x, y;
  };
  /// Evenly spread over the unit disc; streams are independent.
  Spot on_disc(int i, int stream) const;

 private:
  uint32_t block_;
  uint32_t first_;
};

/// What falls on a pixel's surface.
struct Light {
  Float3 ambient;  ///< from the sky and one bounce
  float sun = 0;   ///< the part of the sun's disc that is seen
};

class Lighting {
 public:
  /// The sun stands over the left shoulder of who looks along `view`.
  Lighting(const RayScene& world, const Tracer& tracer, Float3 view);

  Light gather(Float3 point, Float3 normal, const Spread& spread, int samples) const;
  /// What is seen from a point in a direction (unit length), without further bounces.
  Float3 radiance(Float3 point, Float3 direction) const;
  /// Light that a surface throws back, of what falls on it.
  Float3 reflected(Float3 color, Float3 normal, const Light& light) const;
  Float3 sun() const { return sun_; }

 private:
  const RayScene& world_;
  const Tracer& tracer_;
  Float3 sun_, sun_x_, sun_y_;
};

}  // namespace mansard
