// The oriented box that every shape carries (Müller et al. 2006 §3.1): an origin, three orthonormal
// axes and a size in metres along each. World coordinates are right-handed with y up; x points east
// and -z north.
#pragma once

#include "geometry/vector.hpp"

namespace mansard {

struct Scope {
  Vec3 origin;
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  Vec3 size;

  constexpr Vec3 at(Vec3 local) const { return origin + x * local.x + y * local.y + z * local.z; }
  constexpr Vec3 direction(Vec3 local) const { return x * local.x + y * local.y + z * local.z; }
  constexpr Vec3 to_local(Vec3 world) const {
    const Vec3 d = world - origin;
    return {dot(d, x), dot(d, y), dot(d, z)};
  }
};

/// Left-handed: loops that are counter-clockwise in it are clockwise in the world.
constexpr bool mirrored(const Scope& scope) { return dot(cross(scope.x, scope.y), scope.z) < 0; }

}  // namespace mansard
