#include "tests/library/fights.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/clip.hpp"

namespace mansard::test {
namespace {

constexpr double same_plane = 0.0005;  // metres
constexpr double least_area = 0.0001;  // square metres

double coordinate(Vec3 p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

bool boxes_meet(const Box3& a, const Box3& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (coordinate(a.low, axis) > coordinate(b.high, axis) + same_plane) return false;
    if (coordinate(b.low, axis) > coordinate(a.high, axis) + same_plane) return false;
  }
  return true;
}

/// What is left of a convex loop on the inner side of the edge from a to b of a triangle that looks
/// along `normal`.
std::vector<Vec3> clipped(const std::vector<Vec3>& loop, Vec3 a, Vec3 b, Vec3 normal) {
  std::vector<Vec3> result;
  const Vec3 inwards = cross(normal, b - a);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 p = loop[i], q = loop[(i + 1) % loop.size()];
    const double at_p = dot(inwards, p - a), at_q = dot(inwards, q - a);
    if (at_p >= 0) result.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
      result.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
  }
  return result;
}

using Triangle = std::array<Vec3, 3>;

std::vector<Triangle> triangles(std::span<const Vec3> loop) {
  std::vector<Triangle> result;
  const auto numbers = triangulate(loop);
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    result.push_back({loop[numbers[i]], loop[numbers[i + 1]], loop[numbers[i + 2]]});
  }
  return result;
}

/// The overlap of two faces that are nearly parallel, as far as it lies in one plane.
Fight overlap(const Surface& surface, std::size_t first, std::size_t second) {
  Fight fight{first, second, 0, {}};
  const Vec3 plane = surface.normals[second], corner = surface.loop(second)[0];
  for (const Triangle& one : triangles(surface.loop(first))) {
    for (const Triangle& other : triangles(surface.loop(second))) {
      const Vec3 normal = cross(other[1] - other[0], other[2] - other[0]);
      std::vector<Vec3> common{one.begin(), one.end()};
      for (std::size_t i = 0; i < 3 && common.size() >= 3; ++i) {
        common = clipped(common, other[i], other[(i + 1) % 3], normal);
      }
      const auto off = [&](Vec3 p) { return std::abs(dot(plane, p - corner)) > same_plane; };
      if (common.size() < 3 || std::ranges::any_of(common, off)) continue;
      fight.area += length(newell(common)) / 2;
      fight.at = common[0];
    }
  }
  return fight;
}

/// May they share a plane? Cheap, and never wrongly no.
bool may_share_plane(const Surface& surface, std::size_t a, std::size_t b) {
  if (std::abs(dot(surface.normals[a], surface.normals[b])) < 0.999) return false;
  const Vec3 plane = surface.normals[b], corner = surface.loop(b)[0];
  double low = 1e300, high = -1e300;
  for (const Vec3 p : surface.loop(a)) {
    low = std::min(low, dot(plane, p - corner));
    high = std::max(high, dot(plane, p - corner));
  }
  return low <= same_plane && high >= -same_plane;
}

}  // namespace

std::vector<Fight> fights(const Surface& surface) {
  const std::size_t n = surface.polygons();
  std::vector<Box3> boxes;
  for (std::size_t i = 0; i < n; ++i) boxes.push_back(bounds(surface.loop(i)));
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::size_t i) { return boxes[i].low.y; });
  std::vector<Fight> found;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = order[i];
    for (std::size_t j = i + 1; j < n; ++j) {
      const std::size_t b = order[j];
      if (boxes[b].low.y > boxes[a].high.y + same_plane) break;
      if (!boxes_meet(boxes[a], boxes[b]) || !may_share_plane(surface, a, b)) continue;
      const Fight fight = overlap(surface, a, b);
      if (fight.area > least_area) found.push_back(fight);
    }
  }
  return found;
}

}  // namespace mansard::test
