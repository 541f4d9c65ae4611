// Roofs over any polygon. Most kinds stand on the straight skeleton (Aichholzer et al. 1995;
// Laycock & Day 2003 for the ends of ridges), the others are profiles swept along a direction. CGAL
// stays behind this interface.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/polygon.hpp"
#include "geometry/vector.hpp"

namespace mansard {

enum class RoofKind : uint8_t {
  flat,
  hip,
  gable,        ///< ridges end in upright walls
  half_hip,     ///< the top of each gable leans back (jerkinhead)
  dutch_hip,    ///< a small gable above each hip end (gablet)
  pyramid,      ///< all faces meet in one point, where it sees every wall
  shed,         ///< one plane, low at the edge `ridge`
  mansard,      ///< hips, steep below and shallow above
  gambrel,      ///< gables, steep below and shallow above
  saltbox,      ///< one ridge out of the middle, its short slope at the edge `ridge`
  cross_gable,  ///< gables, and one more on every long wall between two corners
  sawtooth,     ///< teeth along the edge `ridge`, upright on its side
  barrel        ///< an arc across the edge `ridge`
};
enum class RoofPart : uint8_t { slope, gable, top, soffit, fascia, parapet, lower, upper };

struct RoofOptions {
  RoofKind kind = RoofKind::hip;
  /// Degrees, 0 < pitch < 90: of every slope; of the lower ones where there are two; of the short
  /// one of a saltbox, whose other is `upper_pitch`; of a barrel at its eaves. 0: as the
  /// kind usually has it (35, mansard 70, gambrel and barrel 60, saltbox 45, sawtooth 30, shed 15).
  double pitch = 0;
  double height = 0;  ///< metres from the walls' top to the highest point; used instead of pitch
  /// Metres, horizontal, beyond the walls: at eaves, and at gables (`verge`; as at the eaves when
  /// negative). None over party walls, where the neighbour stands; pyramids
  /// and swept kinds beside one have none at all. Corners go only a share of the
  /// way where they would meet other eaves.
  double overhang = 0, verge = -1;
  double thickness = 0.15;  ///< metres, upright, of the roof's edge; only with overhang
  double upper_pitch = 0;   ///< degrees, of the upper slopes; 0: 25 for mansard, 30 otherwise
  double break_height = 0;  ///< metres above the walls where the upper slopes begin, or
  double break_inset = 0;   ///< metres inside the walls; neither: at 0.4 of the way to the ridge
  double clipped = 0.4;     ///< share of a gable's height: hip of a half_hip, gablet of a dutch_hip
  double tooth = 6;         ///< metres: width of a sawtooth roof's teeth, about
  double parapet = 0;       ///< metres, flat roofs only
  double parapet_width = 0.25;
  /// Edge that the ridge runs along; without: the longest (teeth: across the longest). Over more
  /// than four walls a roof with a skeleton keeps its own ridges.
  std::optional<uint32_t> ridge;
  /// A flag for each edge: ends that are gables, and that stay hips, whatever the kind says. Where
  /// `gables` are given the other ends of gable, gambrel and cross_gable roofs are hips. Only ends
  /// whose face is a triangle can be gables; of a quadrilateral either pair of opposite edges.
  std::optional<std::vector<char>> gables, hips;
};

/// A planar face: `loop` is counter-clockwise seen from outside in (u, v, up); its first edge is
/// the eave (or the lowest edge).
struct RoofFace {
  RoofPart part = RoofPart::slope;
  EdgeTag tag;  ///< of the wall below it
  std::vector<Vec3> loop;
  std::vector<std::vector<Vec3>> holes;  ///< of flat tops and soffits only
  /// Of a flat roof's top what is known of the walls below its edges, those of the loop and then of
  /// the holes; empty where `tag` is all.
  std::vector<EdgeTag> edges;
};

struct Roof {
  std::vector<RoofFace> faces;  ///< those of skeleton roofs in the order of the polygon's edges
  /// Rung of the ladder that made it: 1 as asked; on a footprint 2 changed by millimetres or where
  /// it touches itself, 3 coarser by centimetres, 4 in pieces since it crosses itself; 5 one ridge
  /// over the whole; 6 flat.
  int fallback = 1;
  /// What was asked and this footprint can not have.
  bool no_apex = false;   ///< a pyramid's point would not see every wall: a hip roof instead
  bool no_break = false;  ///< the slopes end below the break: one pitch throughout
  bool low = false;       ///< `height` is less than twice the thickness: a thinner edge instead
};

/// A roof that stands on `polygon` at up = 0. With the walls below it is closed; roofs over a
/// skeleton share the walls' tops point by point, the others and wall gables add points along them.
/// With overhang it is a slab `thickness` thick whose underside runs through the walls' tops; eaves
/// steeper than 55 degrees stand out level, as a cornice. Never fails: a footprint without a
/// skeleton gets fallback 5 or 6.
Roof roof(const Polygon& polygon, const RoofOptions& options);

}  // namespace mansard
