// A closed mesh that is asked many things: where it is near, what of a line it fills.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "geometry/box_index.hpp"
#include "geometry/distance.hpp"
#include "geometry/mesh.hpp"

namespace mansard {

class SolidMesh {
 public:
  SolidMesh() = default;
  /// In world coordinates.
  explicit SolidMesh(Mesh mesh);

  const Mesh& mesh() const { return mesh_; }
  /// Whether looking among the faces saves time.
  bool is_large() const { return mesh_.faces.size() > 100; }
  /// Of a large mesh, the faces that come to the plane dot(normal, p) = at, and those that meet the
  /// box if there is one; together they are cut at the plane as the whole would be. O(log n +
  /// found).
  Mesh across(Vec3 normal, double at, const Box3* box) const;

  /// The place on the surface that is nearest to the triangle, on the triangle and on the surface;
  /// a distance above `within` is none.
  std::optional<Nearest3> nearest(const Triangle& triangle, double within);
  /// The parts of the segment inside, as shares of its length from 0 to 1, in order.
  std::vector<std::pair<double, double>> inside(Vec3 from, Vec3 to);
  bool contains(Vec3 p);

 private:
  void find_triangles();
  std::vector<double> crossings(Vec3 from, Vec3 to);

  Mesh mesh_;
  std::vector<Triangle> triangles_;
  BoxIndex faces_, index_;      ///< of the mesh's faces (when it is large), and of the triangles
  bool has_triangles_ = false;  ///< once they were needed
};

/// Of two that are as near, the first by its coordinates, so that no order matters.
bool is_before(const Nearest3& a, const Nearest3& b);

}  // namespace mansard
