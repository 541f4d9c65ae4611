// Solids and finished surfaces.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/polygon.hpp"
#include "geometry/vector.hpp"

namespace mansard {

/// A polyhedral surface in the frame of its shape, for shapes that are neither flat nor prisms:
/// tapered masses, cylinders, inserted meshes, clipped solids. Faces are loops of point numbers,
/// counter-clockwise seen from outside; a face with holes is given as several triangles.
struct Mesh {
  struct Face {
    uint32_t begin = 0, end = 0;  ///< into corners
    EdgeTag tag;                  ///< of the wall it came from; `cut` where a split made it
    uint32_t material = 0;        ///< into materials, when there are any
  };
  /// A look that the mesh's own file gave. Colours are linear 0..1.
  struct Material {
    std::string name;
    Vec3 color{0.8, 0.8, 0.8};
    double opacity = 1;
    std::string texture;       ///< path of the colour texture, empty for none
    std::string picture = {};  ///< or the bytes of its file, where it lay in the mesh's own
    bool overlay = false;      ///< before another surface, as opaque as the texture is white
  };

  std::vector<Vec3> points;
  std::vector<uint32_t> corners;  ///< point numbers, face after face
  std::vector<Vec2> uvs;          ///< one a corner, or empty
  std::vector<Face> faces;
  std::vector<Material> materials;

  std::span<const uint32_t> loop(const Face& face) const {
    return {corners.data() + face.begin, corners.data() + face.end};
  }
  void add_face(std::span<const uint32_t> loop, EdgeTag tag = {}, uint32_t material = 0) {
    const auto begin = static_cast<uint32_t>(corners.size());
    corners.insert(corners.end(), loop.begin(), loop.end());
    faces.push_back({begin, static_cast<uint32_t>(corners.size()), tag, material});
  }
  void clear() {
    points.clear();
    corners.clear();
    uvs.clear();
    faces.clear();
    materials.clear();
  }
};

struct Box3 {
  Vec3 low, high;
  constexpr Vec3 size() const { return high - low; }
};

Box3 bounds(std::span<const Vec3> points);
/// Newell's vector: along the normal, twice the area long.
Vec3 newell(std::span<const Vec3> loop);

/// What a derivation draws, in world metres: polygons that stand alone (no shared corners), each
/// with its normal. A polygon may be concave but has no holes. Kept as flat arrays so that writing
/// them is one pass; cleared and reused from building to building.
struct Surface {
  struct Run {              ///< consecutive polygons that look the same
    uint32_t symbol = 0;    ///< the caller's number of the terminal's symbol
    uint32_t material = 0;  ///< the caller's number of the material
    uint32_t end = 0;       ///< one past its last polygon
  };
  /// A terminal that formats can share with its like; one that rules made has no mesh, but polygons
  /// in a frame. Point p is drawn at origin + x (scale.x p.x) + y (scale.y p.y) + z (scale.z p.z).
  struct Placed {
    const Mesh* mesh = nullptr;  ///< the same for all that are alike; owned by who read it
    Vec3 origin, x, y, z;        ///< orthonormal axes, left-handed when it is mirrored
    Vec3 scale;
    uint32_t begin = 0, end = 0;  ///< its polygons
  };

  std::vector<Vec3> points;
  std::vector<Vec2> uvs;       ///< one a point, in repeats of the texture (metres without one)
  std::vector<uint32_t> ends;  ///< one past the last point of each polygon
  std::vector<Vec3> normals;   ///< one a polygon, unit length
  std::vector<Run> runs;
  std::vector<Placed> placed;  ///< in the order of their polygons

  std::size_t polygons() const { return ends.size(); }
  bool has_uvs() const { return uvs.size() == points.size(); }
  uint32_t begin(std::size_t polygon) const { return polygon == 0 ? 0 : ends[polygon - 1]; }
  std::span<const Vec3> loop(std::size_t polygon) const {
    return {points.data() + begin(polygon), points.data() + ends[polygon]};
  }
  void clear() {
    points.clear();
    uvs.clear();
    ends.clear();
    normals.clear();
    runs.clear();
    placed.clear();
  }
};

}  // namespace mansard
