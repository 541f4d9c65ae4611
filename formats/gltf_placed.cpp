#include "formats/gltf_placed.hpp"

#include <algorithm>
#include <bit>
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

/// Measured: a node takes some 230 bytes of text and a client's draw call, an instance on the
/// graphics card 40 bytes, a polygon of four corners 110. So nodes pay from some eight polygons on,
/// and windows made of a pane and four reveals stay polygons; instances pay for every box.
bool GltfShared::is_worth_it(const Surface::Placed& placed) const {
  if (instancing_ == Instancing::copies) return false;
  const uint32_t fewest = instancing_ == Instancing::gpu ? 4 : 8;
  constexpr double thinnest = 1e-6;
  const Vec3 s = placed.scale;
  return placed.end - placed.begin >= fewest && std::min({s.x, s.y, s.z}) > thinnest;
}

namespace {

/// The polygons as their own frame has them, to a hundred-thousandth of their extent.
GltfSharable::Hash hash_of_polygons(const Surface& surface, const Surface::Placed& placed) {
  GltfSharable::Hash hash{1, 2};
  const auto add = [&](uint64_t value) {
    hash[0] = std::rotl((hash[0] ^ value) * 0x9e3779b97f4a7c15, 29);
    hash[1] = std::rotl((hash[1] ^ value) * 0xc2b2ae3d27d4eb4f, 31);
  };
  const auto add_length = [&](double v) { add(static_cast<uint64_t>(std::llround(v * 1e5))); };
  const bool mirrored = is_mirrored(placed);
  for (uint32_t i = placed.begin; i < placed.end; ++i) {
    const std::span<const Vec3> loop = surface.loop(i);
    add(loop.size());
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec3 d = loop[mirrored ? loop.size() - 1 - k : k] - placed.origin;
      add_length(dot(d, placed.x) / placed.scale.x);
      add_length(dot(d, placed.y) / placed.scale.y);
      add_length(dot(d, placed.z) / placed.scale.z);
    }
  }
  return hash;
}

}  // namespace

void GltfShared::find_sharable(const Surface& surface, std::vector<GltfSharable>& sharable) const {
  sharable.clear();
  for (uint32_t i = 0; i < surface.placed.size(); ++i) {
    const Surface::Placed& placed = surface.placed[i];
    if (!is_worth_it(placed)) continue;
    sharable.push_back({i, placed.mesh ? GltfSharable::Hash{} : hash_of_polygons(surface, placed)});
  }
}

void GltfShared::find(const Surface& surface, std::span<const GltfSharable> sharable,
                      std::vector<GltfMesh*>& meshes) {
  meshes.assign(surface.placed.size(), nullptr);
  once_.clear();
  for (const GltfSharable& one : sharable) {
    set_key(surface, one);
    if (const auto known = all_.find(key_); known != all_.end()) {
      meshes[one.placed] = &known->second;
    } else if (surface.placed[one.placed].mesh) {
      meshes[one.placed] = &all_[key_];
    } else if (const auto [first, fresh] = once_.try_emplace(key_, one.placed); !fresh) {
      meshes[one.placed] = meshes[first->second] = &all_[key_];
    }
  }
}

void GltfShared::set_key(const Surface& surface, const GltfSharable& sharable) {
  const Surface::Placed& placed = surface.placed[sharable.placed];
  auto& [mesh, hash, looks] = key_;
  mesh = placed.mesh;
  hash = sharable.hash;
  looks.clear();
  auto run = std::ranges::upper_bound(surface.runs, placed.begin, {}, &Surface::Run::end);
  for (;; ++run) {
    const uint32_t end = std::min(run->end, placed.end);
    looks.insert(looks.end(), {run->material, end - placed.begin});
    if (end == placed.end) break;
  }
}

}  // namespace mansard
