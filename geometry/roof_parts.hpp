// What the kinds of roofs share.
#pragma once

#include <array>
#include <functional>
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

/// Where the ridge between the slopes of two walls runs through the vertical plane of a third.
std::optional<Vec3> ridge_above(const WallLine& left, const WallLine& right, const WallLine& wall);

/// Moves the tips of triangular hip ends along their ridges into the plane of the wall, where
/// `allowed(edge of on.polygon)`; of a quadrilateral either pair of opposite edges will do. Returns
/// a flag for each edge: is a gable.
std::vector<char> make_gables(SkeletonOn& on, const std::function<bool(uint32_t)>& allowed);

}  // namespace mansard
