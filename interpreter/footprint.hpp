// A footprint to build on: a polygon in local metres with what is known about it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
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

/// Many footprints, numbered in the order of their file.
class FootprintSource {
 public:
  virtual ~FootprintSource() = default;
  virtual std::size_t size() const = 0;
  /// Either one that stays or `room`, which is replaced and keeps its memory. Any number of threads
  /// at a time.
  virtual const Footprint& get(std::size_t number, Footprint& room) const = 0;
};

/// Sets the party, court, street, main and corner flags of every edge of the footprints that are
/// `wanted` (as many as footprints; none: all). An edge is a party wall
/// where a neighbour's edge runs along it within `tolerance` metres; an edge that is covered in
/// part is divided where the cover ends (pieces of at least 0.5 m), so that a wall is party as a
/// whole or not at all. `wall` numbers are renewed. Court edges belong to holes; of street edges
/// see interpreter/street_edges.hpp.
void mark_walls(std::span<Footprint> footprints, const std::vector<bool>& wanted,
                const Streets& streets, double tolerance = 0.05);
/// Metres about a footprint within which others bear upon its flags.
double neighbour_reach(const Streets& streets, double tolerance = 0.05);

/// Marks all walls; then each footprint knows the others, and the streets, as its surroundings.
void mark_neighbours(std::vector<Footprint>& footprints,
                     const std::vector<StreetLine>& streets = {}, double tolerance = 0.05);

}  // namespace mansard
