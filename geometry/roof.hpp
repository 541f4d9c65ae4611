// Roofs over any polygon, by the straight skeleton (Aichholzer et al. 1995; Laycock & Day 2003 for
// gables). CGAL stays behind this interface.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/polygon.hpp"
#include "geometry/vector.hpp"

namespace mansard {

enum class RoofKind : uint8_t { flat, hip, gable };
enum class RoofPart : uint8_t { slope, gable, top, soffit, fascia, parapet };

struct RoofOptions {
  RoofKind kind = RoofKind::hip;
  double pitch = 35;  ///< degrees, 0 < pitch < 89
  double height = 0;  ///< metres to the highest point; used instead of pitch when positive
  /// Metres, horizontal, at eaves and gables; not at gables over party walls, where the neighbour
  /// stands. Corners go only a share of the way where they would meet other eaves.
  double overhang = 0;
  double thickness = 0.15;  ///< metres: height of the fascia; only with overhang
  double parapet = 0;       ///< metres, flat roofs only
  double parapet_width = 0.25;
  /// Which edges become gables where their roof face is a triangular hip end; null: all. Over a
  /// quadrilateral either pair of opposite edges can, the short one if both may.
  std::function<bool(uint32_t edge)> gables;
};

/// A planar face: `loop` is counter-clockwise seen from outside in (u, v, up); its first edge is
/// the eave (or the lowest edge).
struct RoofFace {
  RoofPart part = RoofPart::slope;
  EdgeTag tag;  ///< of the wall below it
  std::vector<Vec3> loop;
  std::vector<std::vector<Vec3>> holes;  ///< of flat tops and soffits only
};

struct Roof {
  std::vector<RoofFace> faces;  ///< in the order of the polygon's edges
  int fallback = 1;             ///< rung of the ladder that made it: 1 as asked ... 6 flat
};

/// A roof that stands on `polygon` at up = 0, closed together with walls below. With overhang the
/// eaves lie outside and below, with soffits and fasciae, and the slopes keep their planes. Never
/// fails: a footprint without a skeleton gets a flat roof (fallback 6).
Roof roof(const Polygon& polygon, const RoofOptions& options);

/// Straight skeleton: every edge's face as a loop of (u, v, inset distance), first edge the
/// polygon's edge, in edge order (edges that cleaning merged have an empty face but the longest).
/// nullopt when no rung of the ladder of fallbacks gave a checked skeleton.
struct Skeleton {
  std::vector<std::vector<Vec3>> faces;
  int fallback = 1;
};
std::optional<Skeleton> straight_skeleton(const Polygon& polygon);

}  // namespace mansard
