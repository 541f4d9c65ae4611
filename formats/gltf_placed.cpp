#include "formats/gltf_placed.hpp"

#include <algorithm>
#include <cmath>

namespace mansard {

namespace {

/// Of the rotation whose columns are x, y and z (Shepperd 1978): the largest component first.
std::array<double, 4> quaternion(Vec3 x, Vec3 y, Vec3 z) {
  const std::array<double, 4> squares{1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z,
                                      1 + x.x + y.y + z.z};
  const auto largest = std::ranges::max_element(squares) - squares.begin();
  const double twice = std::sqrt(squares[static_cast<std::size_t>(largest)]), d = 0.5 / twice;
  switch (largest) {
    case 0:
      return {twice / 2, (x.y + y.x) * d, (x.z + z.x) * d, (y.z - z.y) * d};
    case 1:
      return {(x.y + y.x) * d, twice / 2, (y.z + z.y) * d, (z.x - x.z) * d};
    case 2:
      return {(x.z + z.x) * d, (y.z + z.y) * d, twice / 2, (x.y - y.x) * d};
    default:
      return {(y.z - z.y) * d, (z.x - x.z) * d, (x.y - y.x) * d, twice / 2};
  }
}

bool is_mirrored(const Surface::Placed& p) { return dot(cross(p.x, p.y), p.z) < 0; }

}  // namespace

/// A mirrored one is turned the right way round, and mirrored by its scale.
GltfPlace place_of(const Surface::Placed& placed, Vec3 origin) {
  const double side = is_mirrored(placed) ? -1 : 1;
  return {placed.origin - origin,
          quaternion(placed.x * side, placed.y, placed.z),
          {placed.scale.x * side, placed.scale.y, placed.scale.z}};
}

bool is_shared(const Surface::Placed& placed) {
  constexpr uint32_t fewest = 8;
  constexpr double thinnest = 1e-6;
  const Vec3 s = placed.scale;
  return placed.end - placed.begin >= fewest && std::min({s.x, s.y, s.z}) > thinnest;
}

Surface own_frame(const Surface& surface, const Surface::Placed& placed) {
  Surface own;
  const Vec3 s = placed.scale;
  const bool uvs = surface.uvs.size() == surface.points.size();
  for (uint32_t i = placed.begin; i < placed.end; ++i) {
    for (uint32_t p = surface.begin(i); p < surface.ends[i]; ++p) {
      const Vec3 d = surface.points[p] - placed.origin;
      own.points.push_back(
          {dot(d, placed.x) / s.x, dot(d, placed.y) / s.y, dot(d, placed.z) / s.z});
      own.uvs.push_back(uvs ? surface.uvs[p] : Vec2{});
    }
    if (is_mirrored(placed)) {
      const auto first = static_cast<std::ptrdiff_t>(own.begin(own.polygons()));
      std::reverse(own.points.begin() + first, own.points.end());
      std::reverse(own.uvs.begin() + first, own.uvs.end());
    }
    own.ends.push_back(static_cast<uint32_t>(own.points.size()));
    const Vec3 n = surface.normals[i];
    own.normals.push_back(
        normalized(Vec3{dot(n, placed.x) * s.x, dot(n, placed.y) * s.y, dot(n, placed.z) * s.z}));
  }
  for (const Surface::Run& run : surface.runs) {
    const uint32_t end = std::min(run.end, placed.end);
    if (end <= placed.begin || (!own.runs.empty() && own.runs.back().end == own.polygons()))
      continue;
    own.runs.push_back({run.symbol, run.material, end - placed.begin});
  }
  return own;
}

std::optional<uint64_t> GltfShared::find(const Surface& surface, const Surface::Placed& placed) {
  auto& [mesh, looks] = key_;
  mesh = placed.mesh;
  looks.clear();
  auto run = std::ranges::upper_bound(surface.runs, placed.begin, {}, &Surface::Run::end);
  for (;; ++run) {
    const uint32_t end = std::min(run->end, placed.end);
    looks.insert(looks.end(), {run->material, end - placed.begin});
    if (end == placed.end) break;
  }
  known_ = all_.find(key_);
  if (known_ == all_.end()) known_ = all_.try_emplace(key_).first;
  return known_->second;
}

}  // namespace mansard
