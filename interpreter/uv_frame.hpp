// Where textures start and how they run over faces. Private to the interpreter.
#pragma once

#include <cstdint>

#include "geometry/vector.hpp"
#include "interpreter/shape.hpp"

namespace mansard {

/// Where a texture starts and runs on a wall: from `origin` along u and v, by their length.
struct UvFrame {
  Vec3 origin, u, v, normal;
  Vec3 shift_u = u, shift_v = v;  ///< what u and v of a face grow by as it moves and the wall stays
  bool in_repeats = false;        ///< u and v count repeats, not metres
  bool level = false;             ///< heights count from the foot of the building
  uint32_t number = Shape::none;  ///< in the pool; none for a frame that belongs to one shape
};

}  // namespace mansard
