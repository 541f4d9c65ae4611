// A footprint to build on: a polygon in local metres with what is known about it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geometry/polygon.hpp"
#include "interpreter/streets.hpp"

namespace mansard {

using PropertyValue = std::variant<double, bool, std::string>;

struct Property {
  std::string name;
  PropertyValue value;
};

class Surroundings;

struct Footprint {
  std::string id;  ///< stable: --id NAME, else osm_id, feature id, `id`, else position in the file
  /// u east and v north in metres about the set's origin, first edge as in the file; tags hold
  /// party, court and street flags and `wall` = the edge's number.
  Polygon polygon;
  std::vector<Property> properties;
  /// The buildings around, with this one, and its place among them; null: it stands alone.
  std::shared_ptr<const Surroundings> around{};
  uint32_t place = 0;
  const Property* find(std::string_view name) const {
    for (const Property& p : properties) {
      if (p.name == name) return &p;
    }
    return nullptr;
  }
};

/// Sets the party, court, street, main and corner flags of every edge. An edge is a party wall
/// where a neighbour's edge runs along it within `tolerance` metres; an edge that is covered in
/// part is divided where the cover ends (pieces of at least 0.5 m), so that a wall is party as a
/// whole or not at all. `wall` numbers are renewed. Court edges belong to holes; of street edges
/// see interpreter/street_edges.hpp. Then each footprint knows the others, and the streets, as its
/// surroundings.
void mark_neighbours(std::vector<Footprint>& footprints,
                     const std::vector<StreetLine>& streets = {}, double tolerance = 0.05);

}  // namespace mansard
