// Rings as they were found, made into polygons that the engine can rely on.
#pragma once

#include <string>
#include <vector>

#include "formats/footprint_sources.hpp"
#include "geometry/polygon.hpp"

namespace mansard {

struct CleanedRings {
  std::vector<Polygon> polygons;   ///< valid (OGC 06-103r4 §6.1.11), oriented; empty: unusable
  std::vector<std::string> notes;  ///< what was repaired, or why nothing is left
};

/// Closes, drops repeated points (closer than a micrometre) and repairs crossings by GEOS. `closed`
/// says that the source repeats a ring's first point at its end, so that it is missed elsewhere.
CleanedRings clean_rings(const RawPolygon& raw, bool closed);

}  // namespace mansard
