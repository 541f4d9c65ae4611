// What every solid must be.
#pragma once

#include <array>
#include <map>
#include <utility>

#include "geometry/clip.hpp"
#include "geometry/mesh.hpp"

namespace mansard::test {

/// Every edge has its opposite, whichever number a place has.
inline bool is_closed(const Mesh& mesh) {
  using Place = std::array<long long, 3>;
  const auto place = [&](uint32_t i) {
    const Vec3 p = mesh.points[i];
    return Place{std::llround(p.x * 1e6), std::llround(p.y * 1e6), std::llround(p.z * 1e6)};
  };
  std::map<std::pair<Place, Place>, int> balance;
  for (const Mesh::Face& face : mesh.faces) {
    const auto loop = mesh.loop(face);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Place a = place(loop[i]), b = place(loop[(i + 1) % loop.size()]);
      if (a == b) continue;
      ++balance[{a, b}];
      --balance[{b, a}];
    }
  }
  for (const auto& [edge, count] : balance) {
    if (count != 0) return false;
  }
  return true;
}

/// Positive for faces that look outwards.
inline double volume(const Mesh& mesh) {
  double sum = 0;
  for (const Mesh::Face& face : mesh.faces) {
    std::vector<Vec3> loop;
    for (const uint32_t c : mesh.loop(face)) loop.push_back(mesh.points[c] - mesh.points[0]);
    sum += dot(loop[0], newell(loop)) / 6;
  }
  return sum;
}

/// Largest distance of a corner from its face's plane, in metres.
inline double unevenness(const Mesh& mesh) {
  double most = 0;
  for (const Mesh::Face& face : mesh.faces) {
    std::vector<Vec3> loop;
    for (const uint32_t c : mesh.loop(face)) loop.push_back(mesh.points[c]);
    const Vec3 normal = normalized(newell(loop));
    for (const Vec3 p : loop) most = std::max(most, std::abs(dot(normal, p - loop[0])));
  }
  return most;
}

}  // namespace mansard::test
