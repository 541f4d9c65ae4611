// Reading streets: the lines of GIS files through GDAL/OGR, and literals.
#pragma once

#include <string>
#include <vector>

#include "formats/footprints.hpp"
#include "interpreter/streets.hpp"

namespace mansard {

struct StreetOptions {
  std::string layer{};  ///< empty: for OSM the roads that houses stand at, else every line layer
  std::string where{};  ///< OGR SQL condition; empty: all
};

struct StreetSet {
  std::vector<StreetLine> lines;  ///< in the metres of the footprints
  std::vector<std::string> notes;
};

/// `what` is a path or `WKT:LINESTRING(…)`, `WKT:MULTILINESTRING(…)`. Coordinates become the local
/// metres of `beside`, the footprints along the streets; where one of the two files has no
/// coordinate system they are taken to have the same. Of OpenStreetMap's ways only those tagged as
/// roads for all traffic or for pedestrians count, unless a layer or condition is given; none in
/// tunnels. Throws Failure when there is no such file or it holds no lines.
StreetSet read_streets(const std::string& what, const StreetOptions& options,
                       const FootprintFacts& beside);

}  // namespace mansard
