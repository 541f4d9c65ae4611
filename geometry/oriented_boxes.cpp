#include "geometry/oriented_boxes.hpp"

#include <array>
#include <cmath>

namespace mansard {
namespace {

using Axes = std::array<Vec3, 3>;

Axes axes_of(const Scope& s) { return {s.x, s.y, s.z}; }

Vec3 middle(const Scope& s) { return s.at(s.size * 0.5); }

/// How far the box reaches from its middle along a unit direction.
double reach(const Scope& s, Vec3 along) {
  return (std::abs(dot(s.x, along)) * s.size.x + std::abs(dot(s.y, along)) * s.size.y +
          std::abs(dot(s.z, along)) * s.size.z) /
         2;
}

}  // namespace

bool meet(const Scope& a, const Scope& b, double by) {
  const Vec3 between = middle(b) - middle(a);
  const auto parts = [&](Vec3 along) {
    return std::abs(dot(between, along)) > reach(a, along) + reach(b, along) + by;
  };
  const Axes of_a = axes_of(a), of_b = axes_of(b);
  for (const Vec3 along : of_a) {
    if (parts(along)) return false;
  }
  for (const Vec3 along : of_b) {
    if (parts(along)) return false;
  }
  for (const Vec3 one : of_a) {
    for (const Vec3 other : of_b) {
      const Vec3 across = cross(one, other);
      const double sine = length(across);
      if (sine > 1e-6 && parts(across * (1 / sine))) return false;  // else nearly one of the axes
    }
  }
  return true;
}

}  // namespace mansard
