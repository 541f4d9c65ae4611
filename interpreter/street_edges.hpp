// Which edges of a footprint look at a street.
#pragma once

#include <vector>

#include "geometry/polygon.hpp"
#include "interpreter/edge_grid.hpp"
#include "interpreter/streets.hpp"

namespace mansard {

/// Metres: how far a house looks for its street; how much farther another one may be; without
/// lines of streets, how much room a street takes.
inline constexpr double street_reach = 100, street_spread = 10, street_clearance = 6;

class StreetEdges {
 public:
  /// `grid` holds the edges of all footprints. Party walls lie within `tolerance`.
  StreetEdges(const EdgeGrid& grid, const Streets& streets, double tolerance)
      : grid_(grid), streets_(streets), tolerance_(tolerance) {}

  /// Sets street, main and corner of edges that are neither party nor court.
  ///
  /// An edge looks at a street where, from its middle or from a sixth of its length at either end,
  /// a place of the street that is nearest (both ways along the street lead away) lies within 45
  /// degrees of straight ahead, within `street_reach`, and no edge of a footprint comes between.
  /// Street edges are those whose street is at most `street_spread` farther than the nearest one.
  /// Where no edge looks at a street they are the edges without a neighbour within
  /// `street_clearance` before their middle, or all when that leaves none. The longest is main;
  /// those that meet another one of them at less than 150 degrees are corner.
  void mark(Polygon& polygon, uint32_t footprint) const;

 private:
  std::vector<uint32_t> that_see(const Polygon& polygon, const std::vector<uint32_t>& free) const;
  std::vector<uint32_t> with_room(const Polygon& polygon, const std::vector<uint32_t>& free,
                                  uint32_t footprint) const;
  double sight(Vec2 from, Vec2 outwards, double reach) const;
  bool is_blocked(Vec2 from, Vec2 to, uint32_t but) const;

  const EdgeGrid& grid_;
  const Streets& streets_;
  double tolerance_;
};

}  // namespace mansard
