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
  double near = 1e-5;  ///< points closer than this to the one before are dropped
  double flat = 1e-5;  ///< so are points closer than this to the edge that replaces them
  double hole = 1e-6;  ///< smaller holes are dropped
  double gap = 2e-6;   ///< rings that come closer than this are moved apart, by `part`
  double part = 0.02;
  std::size_t most_points = 10000;  ///< what has more of them after all this is given up
};

/// The polygon and what became of every point and edge of the original.
struct Cleaned {
  static constexpr uint32_t no_edge = ~0u;

  Polygon polygon;                ///< simple, oriented; an edge has the tag of its longest part
  std::vector<uint32_t> points;   ///< for each corner: the original point it is
  std::vector<uint32_t> edges;    ///< for each edge: the number of its longest part in the original
  std::vector<uint32_t> edge_of;  ///< for each original edge: the edge it is a part of; no_edge for
                                  ///< the sides of spikes and for holes that were dropped
  bool moved = false;  ///< points were moved since the polygon touched itself; else each corner has
                       ///< the coordinates of its original point, and dropped points between two
                       ///< parts of an edge lie within max(near, flat) of it
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
