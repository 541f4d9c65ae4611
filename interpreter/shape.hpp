// A shape: a symbol with a scope, a geometry and attributes (Müller et al. 2006 §3.1). A small
// record that is copied by value; what does not fit lies in the derivation's pools.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "geometry/polygon.hpp"
#include "geometry/scope.hpp"

namespace mansard {

struct Value;

/// What fills the scope. Rectangles and boxes have no mesh: the scope says it all.
enum class Form : uint8_t {
  nothing,    ///< a frame only
  line,       ///< along x
  rectangle,  ///< W x H at z = 0
  polygon,    ///< in the xy plane, or on the ground (xz plane)
  box,        ///< W x H x D
  prism,      ///< a polygon drawn along z, or upwards from the ground
  mesh
};

/// Faces of a box, as bits.
enum Side : uint8_t {
  side_front = 1,
  side_right = 2,
  side_back = 4,
  side_left = 8,
  side_top = 16,
  side_bottom = 32
};

struct Shape {
  static constexpr uint32_t none = 0xffffffff;

  Scope scope;
  Vec3 pivot;  ///< of r(), in the scope's frame

  // ---- geometry
  Form form = Form::nothing;
  bool ground =
      false;  ///< polygons and prisms: u is x and v runs from z = D to z = 0; else u, v are x, y
  uint8_t cuts = 0;          ///< sides (of a rectangle: left, right, top, bottom) that a split made
  uint8_t open = 0;          ///< sides that are no surface: the face a relief or a tier rose from
  bool mass = false;         ///< has been extruded as a mass (levels of detail)
  bool plain = false;        ///< is a terminal whatever the rules say (the end of super)
  EdgeTag tag;               ///< of the wall that it is or came from
  bool hides = true;         ///< occluder(): its solids cover others
  bool massive = false;      ///< solid that stands on the ground or on a flat face, not on a wall
  uint32_t geometry = none;  ///< in the pool of polygons or meshes

  // ---- look
  uint32_t material = 0;
  uint32_t look_by = none;   ///< node whose rule chose the look: a direct choice beats Materials
  uint32_t uv_frame = none;  ///< in the pool of texture frames

  // ---- where it stands in the derivation
  uint32_t symbol = 0;
  uint32_t node = none;  ///< its own number once it is being derived, its parent's before
  uint16_t style = 0;
  uint16_t depth = 0;
  uint64_t seed = 0;
  double index = std::numeric_limits<double>::quiet_NaN();  ///< unset until SYMBOL[expr]
  const Value* arguments = nullptr;  ///< as many as its rules have parameters
  uint32_t settings = none;          ///< newest set(): list in the derivation
  uint32_t solid = none;             ///< of the derivation's world, that it is or came from

  // ---- attributes left by splits and comp
  uint32_t split_index = 0, split_count = 1, split_round = 0;
  uint32_t comp_index = 0, comp_count = 1, comp_name = none;
  uint32_t level = 0;  ///< storey: part of the nearest split along Y
  uint32_t label = none;
  float corner_left = 180, corner_right = 180;  ///< degrees to the walls beside, see corners.hpp

  double width() const { return scope.size.x; }
  double height() const { return scope.size.y; }
  double depth_size() const { return scope.size.z; }
};
static_assert(std::is_trivially_copyable_v<Shape> && sizeof(Shape) == 256);

inline bool is_flat(const Shape& shape) {
  return shape.form == Form::rectangle || shape.form == Form::polygon;
}
/// Flat shapes within 45 degrees of horizontal rise as masses; all else is relief.
inline bool rises(const Shape& shape) {
  return shape.ground || std::abs(shape.scope.z.y) >= 0.7071;
}
inline bool is_solid(const Shape& shape) {
  return shape.form == Form::box || shape.form == Form::prism || shape.form == Form::mesh;
}

}  // namespace mansard
