// Geometry of the pools stretched to the scopes of the shapes that have it.
#pragma once

#include "interpreter/machine.hpp"

namespace mansard {

/// Maps a pooled polygon's plane into its shape's scope, stretched to the scope's size.
class PlaneMap {
 public:
  PlaneMap(const Shape& shape, Vec2 natural)
      : ground_(shape.ground),
        depth_(shape.scope.size.z),
        scale_{natural.x > 0 ? shape.scope.size.x / natural.x : 1,
               natural.y > 0 ? (shape.ground ? shape.scope.size.z : shape.scope.size.y) / natural.y
                             : 1} {}
  Vec2 scaled(Vec2 p) const { return {p.x * scale_.x, p.y * scale_.y}; }
  Vec3 operator()(Vec2 p, double along) const {
    const Vec2 q = scaled(p);
    return ground_ ? Vec3{q.x, along, depth_ - q.y} : Vec3{q.x, q.y, along};
  }
  Vec3 direction(Vec2 d) const { return ground_ ? Vec3{d.x, 0, -d.y} : Vec3{d.x, d.y, 0}; }

 private:
  bool ground_;
  double depth_;
  Vec2 scale_;
};

/// Maps a pooled mesh's points into its shape's scope, stretched to `size`. A mesh without an
/// extent keeps it.
class MeshMap {
 public:
  MeshMap(const PooledMesh& pooled, Vec3 size)
      : low_(pooled.low),
        scale_{stretch(size.x, pooled.natural.x), stretch(size.y, pooled.natural.y),
               stretch(size.z, pooled.natural.z)} {}
  Vec3 operator()(Vec3 p) const {
    const Vec3 q = p - low_;
    return {q.x * scale_.x, q.y * scale_.y, q.z * scale_.z};
  }
  Vec3 scale() const { return scale_; }

 private:
  static double stretch(double size, double natural) { return natural > 1e-9 ? size / natural : 1; }
  Vec3 low_, scale_;
};

/// The outline of a flat shape, or of a prism's or box's base, in metres in its plane. Sides of a
/// rectangle that a split made are marked. Empty for meshes and for shapes without a surface.
Polygon plan_of(const Machine& machine, const Shape& shape);

/// Adds a flat face to a mesh: `at` places a point of the polygon; one with holes is added as
/// triangles.
template <class Place>
void add_flat(Mesh& mesh, const Polygon& polygon, EdgeTag tag, bool reversed, Place at);

/// The same with the loops as point numbers of the mesh.
void add_flat(Mesh& mesh, const Polygon& polygon, std::vector<uint32_t> numbers, EdgeTag tag,
              bool reversed);

template <class Place>
void add_flat(Mesh& mesh, const Polygon& polygon, EdgeTag tag, bool reversed, Place at) {
  std::vector<uint32_t> numbers;
  for (const Vec2 p : polygon.points) {
    numbers.push_back(static_cast<uint32_t>(mesh.points.size()));
    mesh.points.push_back(at(p));
  }
  add_flat(mesh, polygon, std::move(numbers), tag, reversed);
}

}  // namespace mansard
