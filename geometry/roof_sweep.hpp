// Profiles that are swept along a roof.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/roof.hpp"

namespace mansard {

/// Heights over the distance s from the front of the footprint. Strip k lies between levels k and
/// k + 1; neighbouring strips may differ in height at their common level.
struct Sweep {
  struct Strip {
    double begin, end, low, high;  ///< s, and the heights at both
  };
  std::vector<Strip> strips;
  bool level_eaves = false;  ///< beyond the footprint it stays level

  /// On strip k; outside of the footprint too.
  double height(std::size_t k, double s) const;
  double highest() const;
};

/// The profile of a swept kind over a footprint `span` metres deep; of any other kind a ridge in
/// the middle. `height` is that of the highest point, or 0 to go by the pitch.
Sweep sweep_of(const RoofOptions& options, double span, double height);

}  // namespace mansard
