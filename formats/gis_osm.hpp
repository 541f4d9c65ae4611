// OpenStreetMap's tags as GDAL hands them out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "interpreter/footprint.hpp"

namespace mansard {

/// Path (in GDAL's memory) of a configuration that keeps OSM's own names and gives a field to what
/// is asked about buildings, so that conditions can name it.
const char* osm_configuration();

/// Adds what PostgreSQL's hstore text holds: "key"=>"value","key"=>"value".
void add_hstore(std::string_view text, std::vector<Property>& properties);

}  // namespace mansard
