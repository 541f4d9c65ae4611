// What a building shows to whoever stands around it: only the fronts of its faces.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.hpp"

namespace mansard::test {

/// A look at the building that met the back of a face: the face is flipped, or a gap lets one see
/// into the building.
struct Sight {
  std::size_t polygon;
  Vec3 from, at;
};

/// Looks from outside, above the ground, at random places of the surface and of its bounds. What a
/// look of a few millimetres beside does not see is rounding, not a gap.
std::vector<Sight> backs_seen(const Surface& surface, int looks, uint32_t seed);

}  // namespace mansard::test
