// Faces that lie in one plane over each other: pictures flicker between them (z-fighting).
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/mesh.hpp"

namespace mansard::test {

struct Fight {
  std::size_t first, second;  ///< polygons of the surface
  double area;                ///< square metres that both cover
  Vec3 at;                    ///< a place where they do
};

/// Pairs of polygons whose planes are the same within 0.5 mm where they overlap, by more than
/// 1 square centimetre; whether they look the same way or opposite ways.
std::vector<Fight> fights(const Surface& surface);

}  // namespace mansard::test
