// Where a picture is taken from.
#pragma once

#include <span>

#include "render/trace.hpp"

namespace mansard {

/// A pinhole with a film that may be shifted up, as architects' cameras are, so that what is
/// upright stays upright.
struct Lens {
  Float3 eye;
  Float3 forward;    ///< to the middle of the film, at distance 1
  Float3 right, up;  ///< from there to the film's border

  /// Not of unit length. x and y are -1..1, y upwards.
  Float3 ray(float x, float y) const { return forward + right * x + up * y; }
};

/// For `iso` and `street` the whole scene fills the picture; but from the street one sees the
/// street when the scene is larger than 200 m.
Lens aim(const RayScene& world, const Tracer& tracer, const PictureOptions& options);

/// An eye in the frame of the world and the level direction in which it looks.
struct Stand {
  Float3 eye, direction;
};
/// In the middle of a large scene, 1.7 m above the ground, between buildings, looking along the
/// longest free way.
Stand find_street(const RayScene& world, const Tracer& tracer);

}  // namespace mansard
