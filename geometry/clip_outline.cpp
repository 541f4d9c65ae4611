#include "geometry/clip_outline.hpp"

#include <array>

#include "geometry/clip.hpp"

namespace mansard {
namespace {

/// An edge of a part of the outline, counter-clockwise.
struct Border {
  Vec2 from, to;
  bool inner = false;  ///< to another part
};

/// Inner borders last: a cut is closed as long as the solid is whole.
Mesh clip_by_part(const Mesh& mesh, std::span<const Border> borders) {
  Mesh part = mesh;
  for (const bool inner : {false, true}) {
    for (const Border& border : borders) {
      if (border.inner != inner || border.from == border.to || part.faces.empty()) continue;
      const Vec2 outwards = left_of(normalized(border.to - border.from)) * -1;
      const Vec3 normal{outwards.x, outwards.y, 0};
      const double offset = dot(outwards, border.from);
      part = inner ? clip_open(part, normal, offset) : clip(part, normal, offset);
    }
  }
  return part;
}

void append(Mesh& to, const Mesh& part) {
  const auto points = static_cast<uint32_t>(to.points.size());
  const auto corners = static_cast<uint32_t>(to.corners.size());
  to.points.insert(to.points.end(), part.points.begin(), part.points.end());
  for (const uint32_t corner : part.corners) to.corners.push_back(points + corner);
  to.uvs.insert(to.uvs.end(), part.uvs.begin(), part.uvs.end());
  for (Mesh::Face face : part.faces) {
    face.begin += corners;
    face.end += corners;
    to.faces.push_back(face);
  }
}

}  // namespace

Mesh clip_by_outline(const Mesh& mesh, const Polygon& outline) {
  if (!outline.has_holes() && is_convex(outline)) {
    std::vector<Border> borders;
    for_each_edge(outline, [&](uint32_t, Vec2 a, Vec2 b) { borders.push_back({a, b}); });
    return clip_by_part(mesh, borders);
  }
  const std::vector<uint32_t> next = next_points(outline);
  const std::vector<uint32_t> triangles = triangulate(outline);
  Mesh whole;
  whole.materials = mesh.materials;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    std::array<Border, 3> borders;
    for (std::size_t k = 0; k < 3; ++k) {
      const uint32_t a = triangles[i + k], b = triangles[i + (k + 1) % 3];
      borders[k] = {outline.points[a], outline.points[b], next[a] != b};
    }
    append(whole, clip_by_part(mesh, borders));
  }
  return whole.faces.empty() ? Mesh{} : whole;
}

}  // namespace mansard
