// A roof over a skeleton while it is made: nodes in the plan with their inset distances, which
// become heights at the end, so that every piece stays planar and shares its nodes with the others.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/roof.hpp"
#include "geometry/skeleton.hpp"

namespace mansard {

/// What stands over a wall: an eave, or the end of a ridge.
enum class RoofEnd : uint8_t { hip, gable, half_hip, dutch_hip };

struct RoofPlan {
  /// (u, v, t): where the node is over the walls, and where the overhang takes it. t is the
  /// distance inwards from the walls of the slopes that meet there, negative outside.
  struct Node {
    Vec3 wall, outer;
  };
  struct Face {
    RoofPart part = RoofPart::slope;
    uint32_t edge = 0;       ///< of the footprint
    bool over_wall = false;  ///< a gable in the plane of its wall: takes the nodes over the walls
    std::vector<uint32_t> loop;  ///< the eave, or the lowest edge, first
  };

  const Polygon* footprint = nullptr;  ///< cleaned
  std::vector<WallLine> lines;         ///< of its edges
  std::vector<uint32_t> next, before;  ///< corner after and before each corner of the footprint
  std::vector<Node> nodes;             ///< the footprint's corners come first
  std::vector<Face> faces;             ///< face e is on edge e; more come after
  std::vector<RoofEnd> ends;           ///< of each edge
  /// Where the roof leaves each wall: nodes from corner to corner, over the tip of a gable.
  std::vector<std::vector<uint32_t>> borders;

  std::size_t edges() const { return lines.size(); }
  uint32_t add_node(Vec3 both) {
    nodes.push_back({both, both});
    return static_cast<uint32_t>(nodes.size() - 1);
  }
  double highest() const;  ///< the largest t
};

/// The plan of a hip roof.
RoofPlan plan_roof(const SkeletonOn& on);

/// Takes corners away where a face turns back on itself, which skeletons have at nodes that fall
/// together but for the last digits: a piece cut from there would have no area.
void close_slits(RoofPlan& plan);

/// The end of a ridge towards a wall: a triangular hip end, or a side of a quadrilateral.
struct RidgeEnd {
  uint32_t edge, tip;  ///< the wall, and the node at the end of the ridge
};

/// Turns the ends that are no hips into what they shall be, by moving the ridge's tip along the
/// ridge (Laycock & Day 2003 made exact: the slopes stay in their planes). `clipped` as in
/// RoofOptions. Ends that can not be changed are marked as hips in plan.ends.
void shape_ends(RoofPlan& plan, const std::vector<RidgeEnd>& ends, double clipped);

/// The ends of ridges that may be changed, where `wanted` (a flag for each edge). Of a
/// quadrilateral either pair of opposite edges; its ridge is turned along `ridge` or to where it
/// has the ends that are wanted.
/// The ridge must not have come down to the eaves `verge` metres beyond the wall.
std::vector<RidgeEnd> ridge_ends(SkeletonOn& on, const std::vector<char>& wanted,
                                 std::optional<uint32_t> ridge, double verge);

/// Takes the outer nodes to the overhang's edge, along the planes of the slopes.
void move_eaves(RoofPlan& plan, const RoofOptions& options);

/// Adds a gable in the middle of each wall whose slope is long and deep enough.
void add_wall_gables(RoofPlan& plan, const RoofOptions& options);

/// Divides every face along the line where t is `level`: what lies above becomes new faces of
/// `above`, what lies below `below`. Returns the level that was taken, clear of the nodes.
double cut_at_level(RoofPlan& plan, double level, RoofPart below, RoofPart above);

/// Heights over inset distances: one or two slopes.
struct RoofProfile {
  double rise = 1, upper_rise = 1;  ///< metres up per metre inwards
  double bend = 1e300;              ///< t where the upper slope begins
  bool level_eaves = false;         ///< outside the walls it stays level

  double operator()(double t) const {
    if (t < 0 && level_eaves) return 0;
    return t <= bend ? t * rise : bend * rise + (t - bend) * upper_rise;
  }
};

/// The faces of a finished plan, as RoofFace has them. `thickness` is 0 without an overhang.
/// `original` is the polygon that on.polygon was cleaned from: the walls stand on that.
void emit_faces(Roof& roof, const RoofPlan& plan, const SkeletonOn& on, const Polygon& original,
                const RoofProfile& profile, double thickness);

}  // namespace mansard
