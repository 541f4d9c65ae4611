#include "formats/gis_osm.hpp"

#include <cpl_vsi.h>

namespace mansard {
namespace {

/// Format: GDAL's osmconf.ini. Tags without a field of their own arrive as `other_tags`.
char configuration[] = R"(
closed_ways_are_polygons=aeroway,amenity,boundary,building,building:part,craft,geological,historic,landuse,leisure,man_made,military,natural,office,place,shop,sport,tourism,highway=platform,public_transport=platform
attribute_name_laundering=no
[points]
osm_id=yes
attributes=name
other_tags=yes
[lines]
osm_id=yes
attributes=name,highway,tunnel
other_tags=yes
[multipolygons]
osm_id=yes
attributes=name,type,building,building:part,building:use,building:levels,building:min_level,building:material,building:colour,building:age,height,min_height,start_date,roof:shape,roof:height,roof:levels,roof:angle,roof:orientation,roof:direction,roof:material,roof:colour,addr:street,addr:housenumber,addr:housename,addr:postcode,addr:city,amenity,shop,office,tourism,historic,leisure,landuse,man_made,natural
other_tags=yes
[multilinestrings]
osm_id=yes
attributes=name,type
other_tags=yes
[other_relations]
osm_id=yes
attributes=name,type
other_tags=yes
)";

/// From an opening quote on; leaves `text` behind the closing one.
std::string quoted(std::string_view& text) {
  std::string value;
  std::size_t at = 1;
  for (; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\' && at + 1 < text.size()) ++at;
    value += text[at];
  }
  text.remove_prefix(std::min(at + 1, text.size()));
  return value;
}

}  // namespace

const char* osm_configuration() {
  constexpr const char* path = "/vsimem/mansard_osmconf.ini";
  VSILFILE* file = VSIFileFromMemBuffer(path, reinterpret_cast<GByte*>(configuration),
                                        sizeof(configuration) - 1, FALSE);
  VSIFCloseL(file);
  return path;
}

void add_hstore(std::string_view text, std::vector<Property>& properties) {
  while (true) {
    const std::size_t key = text.find('"');
    if (key == text.npos) return;
    text.remove_prefix(key);
    Property property{quoted(text), {}};
    const std::size_t value = text.find('"');
    if (value == text.npos) return;
    text.remove_prefix(value);
    property.value = quoted(text);
    properties.push_back(std::move(property));
  }
}

}  // namespace mansard
