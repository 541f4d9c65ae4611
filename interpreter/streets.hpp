// Streets: lines in the plan, and where they come nearest to a place.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/box_index.hpp"
#include "geometry/vector.hpp"

namespace mansard {

/// The points of a street, u east and v north in metres as of footprints; at least two.
using StreetLine = std::vector<Vec2>;

class Streets {
 public:
  struct Segment {
    uint32_t from, to;  ///< points
  };

  /// Ends that are the same to a millimetre are joined: a street may come in pieces.
  explicit Streets(const std::vector<StreetLine>& lines);

  bool empty() const { return segments_.empty(); }
  /// Points, at most `reach` metres from `place`, from which both ways along the street lead
  /// farther away, into `found` (cleared first), the nearest first.
  void nearest_points(Vec2 place, double reach, std::vector<Vec2>& found) const;
  /// The point of all streets that is nearest to the segment from-to (which may be a point), and
  /// its distance; a distance of `within` metres or more is none. In a town, O(log n).
  struct Near {
    Vec2 point;
    double distance = 0;
  };
  std::optional<Near> nearest(Vec2 from, Vec2 to, double within) const;

 private:
  bool is_nearest(uint32_t point, Vec2 place) const;

  std::vector<Vec2> points_;
  std::vector<Segment> segments_;
  std::vector<std::vector<uint32_t>> beside_;  ///< of each point, those that it is joined to
  BoxIndex index_;                             ///< of segments: x east, z north
};

}  // namespace mansard
