#include "formats/gltf_primitive.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "geometry/clip.hpp"

namespace mansard {

namespace {
constexpr std::size_t slot_count = 1 << 14;  ///< a vertex that was pushed out is written again
}

void GltfPrimitive::clear(bool with_uvs, bool with_tangents) {
  with_uvs_ = with_uvs;
  with_tangents_ = with_uvs && with_tangents;
  positions_.clear();
  normals_.clear();
  uvs_.clear();
  tangents_.clear();
  indices_.clear();
  slots_.resize(slot_count);
  slot_ages_.resize(slot_count, 0);
  ++age_;
  low_.fill(std::numeric_limits<float>::max());
  high_.fill(std::numeric_limits<float>::lowest());
}

namespace {

/// Convex, or nearly: no corner turns back by more than rounding.
bool is_convex(std::span<const Vec3> loop, Vec3 normal) {
  for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
    const Vec3 a = loop[(i + 1) % n] - loop[i], b = loop[(i + 2) % n] - loop[(i + 1) % n];
    if (dot(cross(a, b), normal) < -1e-9) return false;
  }
  return true;
}

/// A polygon's texture runs straight on: its direction is that of any three corners that span it.
std::array<float, 4> tangent_of(std::span<const Vec3> loop, std::span<const Vec2> uvs,
                                Vec3 normal) {
  Vec3 right = loop[1] - loop[0];
  double most = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const Vec2 a = uvs[i] - uvs[0], b = uvs[i + 1] - uvs[0];
    const double turn = cross(a, b);
    if (std::abs(turn) <= std::abs(most)) continue;
    most = turn;
    right = ((loop[i] - loop[0]) * b.y - (loop[i + 1] - loop[0]) * a.y) * (1 / turn);
  }
  const Vec3 along = normalized(right - normal * dot(right, normal));
  return {float(along.x), float(along.y), float(along.z), most < 0 ? -1.0F : 1.0F};
}

}  // namespace

void GltfPrimitive::add(const Surface& surface, std::size_t polygon, Vec3 origin) {
  const std::span<const Vec3> loop = surface.loop(polygon);
  const Vec3 n = surface.normals[polygon];
  if (!(dot(n, n) > 0.5) || loop.size() < 3) return;
  const uint32_t first = surface.begin(polygon);
  loop_.clear();
  if (with_tangents_)
    tangent_ = tangent_of(loop, std::span(surface.uvs).subspan(first, loop.size()), n);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 p = loop[i] - origin;
    const Vec2 uv = with_uvs_ ? surface.uvs[first + i] : Vec2{};
    // glTF's textures begin at the top.
    loop_.push_back(vertex({float(p.x), float(p.y), float(p.z), float(n.x), float(n.y), float(n.z),
                            float(uv.x), float(with_uvs_ ? 1 - uv.y : 0)}));
  }
  const auto triangle = [&](uint32_t a, uint32_t b, uint32_t c) {
    if (a == b || b == c || c == a) return;  // corners that are one as floats
    indices_.insert(indices_.end(), {a, b, c});
  };
  if (is_convex(loop, n)) {
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) triangle(loop_[0], loop_[i], loop_[i + 1]);
    return;
  }
  const std::vector<uint32_t> corners = triangulate(loop);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    triangle(loop_[corners[i]], loop_[corners[i + 1]], loop_[corners[i + 2]]);
}

bool GltfPrimitive::same(uint32_t number, const Vertex& v) const {
  const std::size_t at = 3 * std::size_t(number);
  return std::equal(v.begin(), v.begin() + 3, positions_.begin() + std::ptrdiff_t(at)) &&
         std::equal(v.begin() + 3, v.begin() + 6, normals_.begin() + std::ptrdiff_t(at)) &&
         (!with_uvs_ ||
          (uvs_[2 * std::size_t(number)] == v[6] && uvs_[2 * std::size_t(number) + 1] == v[7])) &&
         (!with_tangents_ || std::equal(tangent_.begin(), tangent_.end(),
                                        tangents_.begin() + 4 * std::ptrdiff_t(number)));
}

uint32_t GltfPrimitive::vertex(const Vertex& v) {
  uint64_t hash = 0;
  for (const float f : v) hash = (hash ^ std::bit_cast<uint32_t>(f + 0.0f)) * 0x9e3779b97f4a7c15;
  const std::size_t slot = hash >> 50;
  static_assert(slot_count == std::size_t(1) << 14);
  if (slot_ages_[slot] == age_ && same(slots_[slot], v)) return slots_[slot];
  const uint32_t number = vertices();
  slots_[slot] = number;
  slot_ages_[slot] = age_;
  positions_.insert(positions_.end(), v.begin(), v.begin() + 3);
  normals_.insert(normals_.end(), v.begin() + 3, v.begin() + 6);
  if (with_uvs_) uvs_.insert(uvs_.end(), v.begin() + 6, v.end());
  if (with_tangents_) tangents_.insert(tangents_.end(), tangent_.begin(), tangent_.end());
  for (std::size_t i = 0; i < 3; ++i) {
    low_[i] = std::min(low_[i], v[i]);
    high_[i] = std::max(high_[i], v[i]);
  }
  return number;
}

}  // namespace mansard
