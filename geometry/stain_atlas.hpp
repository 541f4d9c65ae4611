// How the picture of stains is laid out: who makes it and who lays it on walls agree here.
#pragma once

#include <cstdint>

#include "geometry/vector.hpp"

namespace mansard {

/// Sixteen stains. Those of a row are equally strong, the strongest stand below. A stain begins at
/// the upper side of its cell and is clean at the three others.
struct StainAtlas {
  static constexpr int columns = 4, strengths = 4;
  static constexpr int cell_width = 128, cell_height = 256;  ///< texels
  static constexpr int width = columns * cell_width, height = strengths * cell_height;
  /// Share of a cell on each side that no water comes from.
  static constexpr double margin = 0.12;

  /// Where a place of a cell lies in repeats of the picture, v upwards: `across` runs from 0 on the
  /// left to 1, `down` from 0 at the top. Half a texel inside, so that no neighbour shines through.
  static constexpr Vec2 uv(int column, int strength, double across, double down) {
    const double x = 0.5 + across * (cell_width - 1), y = 0.5 + down * (cell_height - 1);
    return {(column * cell_width + x) / width, 1 - (strength * cell_height + y) / height};
  }
};

}  // namespace mansard
