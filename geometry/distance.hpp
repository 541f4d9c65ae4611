// How far segments and triangles are from each other (Ericson 2005, Real-Time Collision Detection
// §5.1), in metres.
#pragma once

#include <array>

#include "geometry/vector.hpp"

namespace mansard {

struct Nearest2 {
  Vec2 first, second;  ///< the two nearest points, the first one on a-b
  double distance = 0;
};
struct Nearest3 {
  Vec3 first, second;
  double distance = 0;
};
using Triangle = std::array<Vec3, 3>;

/// Of the segments a-b and c-d, either of which may be a point.
Nearest2 nearest_pair(Vec2 a, Vec2 b, Vec2 c, Vec2 d);
Nearest3 nearest_pair(Vec3 a, Vec3 b, Vec3 c, Vec3 d);
/// Of triangles, either of which may be a line or a point; the points are the same where they
/// cross.
Nearest3 nearest_pair(const Triangle& a, const Triangle& b);

}  // namespace mansard
