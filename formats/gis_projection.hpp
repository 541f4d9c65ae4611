// From a file's coordinates to local metres, by PROJ.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "formats/footprint_sources.hpp"
#include "formats/gis_module.hpp"

class OGRSpatialReference;

namespace mansard {

/// The features [begin, end) of a set and what their coordinates mean; null: nobody said.
struct GisRange {
  std::size_t begin = 0, end = 0;
  const OGRSpatialReference* crs = nullptr;
  std::vector<Vec2> samples;  ///< the first point of every feature that has one

  void add_sample(const RawFeature& feature);
};

/// Says how all coordinates become local metres (RawSet::to_local), and in the set where these are.
/// Coordinates that can not be converted become NaN. Returns what went wrong, empty when nothing
/// did.
///
/// Metres of a projection that is true within 1 % stay what they are, less whole metres. All else
/// goes through longitude and latitude to an azimuthal equidistant projection about the median of
/// the set: of the usual ones it is the most faithful in every direction (area is wrong by a factor
/// of 1 + d^2/6R^2, 4e-7 at 10 km; transverse Mercator by 1 + d^2/R^2 across, Snyder 1987).
/// `guessed` says that the file's format, not the file, gave the coordinate system (GeoJSON).
std::string to_local_metres(RawSet& set, std::vector<GisRange> ranges, bool guessed);

/// The same for lines beside footprints, whose local metres are given. Coordinates that nobody
/// explains are those of the footprints' file.
std::string to_metres_of(const GisRequest::Beside& beside, RawSet& set,
                         const std::vector<GisRange>& ranges, bool guessed);

}  // namespace mansard
