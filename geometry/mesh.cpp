#include "geometry/mesh.hpp"

#include <algorithm>

namespace mansard {

Box3 bounds(std::span<const Vec3> points) {
  if (points.empty()) return {};
  Box3 box{points[0], points[0]};
  for (const Vec3 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

Vec3 newell(std::span<const Vec3> loop) {
  Vec3 sum;
  // Relative to the first point, so that far-away loops lose no digits.
  for (std::size_t i = 2; i < loop.size(); ++i) {
    sum = sum + cross(loop[i - 1] - loop[0], loop[i] - loop[0]);
  }
  return sum;
}

}  // namespace mansard
