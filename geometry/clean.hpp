// Cleaning of polygons in front of the straight skeleton, which crashes or hangs on touching rings
// and on points that are collinear but for the last bits. Grammars make both all the time.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/polygon.hpp"

namespace mansard {

/// In metres and square metres.
struct CleanTolerance {
  double near = 1e-4;  ///< points closer than this to the one before are dropped
  double flat = 1e-4;  ///< so are points closer than this to the edge that replaces them
  double hole = 1e-3;  ///< smaller holes are dropped
  double gap = 2e-6;   ///< rings that come closer than this are moved apart, by `part`
  double part = 0.02;
  std::size_t most_points = 10000;  ///< what has more of them after all this is given up
};

struct Cleaned {
  Polygon polygon;              ///< simple, oriented; an edge has the tag of its longest part
  std::vector<uint32_t> edges;  ///< for each edge: the number of its longest part in the original
  bool moved = false;           ///< points were moved since the polygon touched itself
};

/// nullopt when nothing with an area is left, when the rings still cross, or when
/// there are too many points.
std::optional<Cleaned> clean(const Polygon& polygon, const CleanTolerance& tolerance);

/// Point and edge of a polygon that come closer than a gap (or the starts of two crossing edges).
struct Contact {
  uint32_t point, edge;
};
/// All contacts but those of neighbours along a ring. Near linear for footprints (a sweep).
std::vector<Contact> contacts(const Polygon& polygon, double gap);

}  // namespace mansard
