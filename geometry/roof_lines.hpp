// What a builder calls the edges of a roof: where two of its faces meet, and where they end.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/vector.hpp"

namespace mansard {

enum class RoofLineKind : uint8_t {
  ridge,   ///< two slopes fall away from it to opposite sides, within 30 degrees
  hip,     ///< two slopes meet in an outer corner that runs down
  valley,  ///< two slopes, or a slope and a wall above its foot, meet in an inner corner
  eave,    ///< level lower border of a slope, or of the cornice that it stands on
  rake     ///< inclined border of a slope, over a wall or over nothing
};
inline constexpr std::array<std::string_view, 5> roof_line_words{"ridge", "hip", "valley", "eave",
                                                                 "rake"};

/// An edge of a planar face, in the order of its loop: counter-clockwise seen from outside, holes
/// clockwise.
struct BorderEdge {
  Vec3 from, to;
  uint32_t face = 0;
};

/// A line of the roof. Inclined ones run upwards, level ones as in the loop of the first slope that
/// has them (so the slope lies at the left of its eave).
struct RoofLine {
  RoofLineKind kind = RoofLineKind::ridge;
  Vec3 from, to;
  Vec3 away;          ///< unit length, square to the line: the middle of both faces' normals
  uint32_t edge = 0;  ///< the first border edge that it is
};

/// The lines among the edges of faces, in the order of the edges. Faces are slopes when they look
/// up and neither stand (within half a degree) nor lie level. Edges whose ends are within a
/// micrometre are one; an edge with a single face is taken to end over a wall. Edges between faces
/// that are nearly one plane (1 degree), the breaks between lower and upper slopes, and all edges
/// without a slope are none of the kinds. `normals`: one a face, unit length; `up`: unit length.
std::vector<RoofLine> roof_lines(std::span<const BorderEdge> edges, std::span<const Vec3> normals,
                                 Vec3 up);

}  // namespace mansard
