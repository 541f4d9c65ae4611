// What shapes that ask see of a building: the solids that were derived before the round.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/box_index.hpp"
#include "geometry/occlusion.hpp"
#include "geometry/solid_mesh.hpp"
#include "interpreter/shape.hpp"

namespace mansard {

class Machine;
class Surroundings;

/// A solid that hides what lies in it. `shape.solid` is the solid that it came from.
struct Occluder {
  Shape shape;
  Box3 box;
  bool active = false;  ///< drawn as it is: nothing took its place
};

/// The latest answer: guards of one symbol often ask the same.
struct LastCover {
  Shape shape;
  std::string set;
  double distance = 0;
  Cover cover = Cover::nothing;
  std::string why;
  bool known = false;

  bool holds(const Shape& asked, std::string_view of, double within) const {
    const Scope &a = shape.scope, &b = asked.scope;
    return known && shape.node == asked.node && shape.form == asked.form &&
           shape.geometry == asked.geometry && shape.solid == asked.solid && a.origin == b.origin &&
           a.size == b.size && a.x == b.x && a.y == b.y && set == of && distance == within;
  }
};

class World {
 public:
  /// Keeps its memory from building to building.
  void clear();
  uint32_t add(const Shape& shape, bool active);
  Occluder& operator[](uint32_t i) { return all_[i]; }
  const Occluder& operator[](uint32_t i) const { return all_[i]; }
  uint32_t size() const { return static_cast<uint32_t>(all_.size()); }

  /// What is there now is what near() finds until the next freeze.
  void freeze();
  void near(const Box3& box, std::vector<uint32_t>& found) const { index_.near(box, found); }
  uint32_t frozen() const { return static_cast<uint32_t>(boxes_.size()); }
  /// As it was when it had `size` solids, of which the first `frozen` were frozen.
  void go_back(uint32_t size, uint32_t frozen);
  void along(Vec3 from, Vec3 to, std::vector<uint32_t>& found) const {
    index_.along(from, to, found);
  }

  /// The solid's cross-section just before the face's plane (geometry/occlusion.hpp), and what it
  /// fills before it.
  std::vector<Polygon> section_of(const Machine& machine, uint32_t solid, const Scope& frame,
                                  double above);
  std::vector<Polygon> shadow_of(const Machine& machine, uint32_t solid, const Scope& frame,
                                 double low, double high, double beside);
  /// The same solid, closed, in the world; kept until the next building.
  SolidMesh& solid_of(const Machine& machine, uint32_t solid);
  /// The block of a neighbour, by its place in the surroundings.
  SolidMesh& block_of(const Surroundings& around, uint32_t place);
  const BoxIndex& index() const { return index_; }
  /// Whether `solid` is `of` or one of the solids it came from.
  bool is_above(uint32_t solid, uint32_t of) const;

 private:
  struct LastSection {
    uint32_t solid = Shape::none;
    double at = 0;  ///< metres of the plane along the frame's z
    Scope frame;
    std::vector<Polygon> pieces;
  };
  std::vector<Polygon> large_section(const SolidMesh& mesh, uint32_t solid, const Scope& frame,
                                     double above);

  LastSection last_section_;
  std::vector<Occluder> all_;
  std::vector<Box3> boxes_;
  BoxIndex index_;
  /// In the world, of those that were needed.
  std::unordered_map<uint32_t, SolidMesh> solids_, blocks_;
};

/// The box around a shape's scope.
Box3 bounds_of(const Scope& scope);

}  // namespace mansard
