// What the kinds of roofs share.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/roof.hpp"
#include "geometry/skeleton.hpp"

namespace mansard {

/// Adds a face without repeated points, and nothing when less than a triangle is left.
void add_face(Roof& roof, RoofPart part, EdgeTag tag, std::span<const Vec3> loop);

/// Every wall's line moved outwards by its distance in metres, with mitred corners. A corner that
/// would make the outline touch itself, or whose mitre is long, moves only a share of its way.
struct MovedOutline {
  std::vector<Vec2> points;
  std::vector<double> shares;  ///< of each point, 0 to 1
};
MovedOutline move_outline(const Polygon& polygon, const std::vector<double>& outwards);

/// The flat roof of any polygon; of one that can not be cleaned, without overhang and parapet.
Roof flat_roof(const Polygon& polygon, const RoofOptions& options);

/// The kinds that stand on the straight skeleton. nullopt when there is none.
std::optional<Roof> skeleton_roof(const Polygon& polygon, const RoofOptions& options);

/// The kinds that are swept along a direction, and the single ridge that any footprint can have
/// (for other kinds; Roof::fallback 5). nullopt when the polygon crosses itself or is a sliver.
std::optional<Roof> swept_roof(const Polygon& polygon, const RoofOptions& options);

/// A profile along a direction, without a skeleton.
bool is_swept(RoofKind kind);
bool has_party_wall(const Polygon& polygon);

/// Degrees to metres up per metre inwards.
double rise_of(double pitch);
/// options.pitch, or what the kind has when that is 0.
double pitch_of(const RoofOptions& options);
/// Metres: the thickness of the roof's edge; 0 without an overhang, at most half of `height`.
double thickness_of(const RoofOptions& options);
/// Metres that gables stand out.
inline double verge_of(const RoofOptions& options) {
  return options.verge < 0 || options.overhang <= 0 ? options.overhang : options.verge;
}
/// The pitch from which eaves stand out level.
inline constexpr double steep_eaves = 55;  // degrees

/// The point at the distances s and t inwards from two walls; nullopt when they are parallel.
std::optional<Vec2> at_distances(const WallLine& one, double s, const WallLine& two, double t);

/// Where the ridge between the slopes of two walls runs through the vertical plane of a third.
std::optional<Vec3> ridge_above(const WallLine& left, const WallLine& right, const WallLine& wall);

}  // namespace mansard
