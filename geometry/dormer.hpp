// Dormers: the wedge that an upright front makes on a slope, with a roof of its own that runs back
// until it meets the slope.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/vector.hpp"

namespace mansard {

enum class DormerKind : uint8_t {
  flat,    ///< a level lid that meets the slope at the piece's upper edge
  shed,    ///< the same, falling forwards at `pitch`, which lowers the front
  gable,   ///< a ridge at right angles to the front
  hip,     ///< the same with a hip over the front
  eyebrow  ///< an arc from one lower corner to the other
};
enum class DormerPart : uint8_t { front, cheek, top, gable, slope, soffit, fascia, rest };

/// All in metres and degrees. The dormer stands on a rectangle `width` x `height` of a slope.
struct DormerOptions {
  DormerKind kind = DormerKind::flat;
  double width = 1, height = 1;  ///< along the lower edge, and up the slope
  double slope = 45;             ///< of the slope it stands on, 0 < slope < 90
  double pitch = 45;             ///< of its own roof, 0 < pitch < 90; of shed ones < slope
  double overhang = 0;           ///< horizontal, beyond the front and the cheeks
  double thickness = 0.1;        ///< upright, of the roof's edge; only with overhang
};

/// A planar face: `loop` is counter-clockwise seen from outside, its first edge the lowest.
struct DormerFace {
  DormerPart part = DormerPart::front;
  std::vector<Vec3> loop;
};

/// How high the front is: the slope's rise over the piece, of shed ones less their own rise; of an
/// eyebrow at its middle, at most half the width and less the roof's edge.
double front_height(const DormerOptions& options);

/// The faces of a dormer in a frame with its origin at the piece's lower left corner: x along the
/// lower edge, y level into the slope, z up. With the slope below, which they meet point by point,
/// they are closed; what an eyebrow leaves of its rectangle is `rest`. Roofs of gable and hip
/// dormers reach beyond the piece's upper edge. An overhang that would run into the slope is made
/// smaller. Empty when a size or an angle is out of range.
std::vector<DormerFace> dormer(const DormerOptions& options);

}  // namespace mansard
