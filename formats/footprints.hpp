// Reading footprints: GIS files through GDAL/OGR (in a module that is loaded when one is opened),
// OBJ faces, and literals.
#pragma once

#include <string>
#include <vector>

#include "formats/footprint_store.hpp"
#include "grammar/diagnostic.hpp"
#include "interpreter/footprint.hpp"

namespace mansard {

struct FootprintOptions {
  std::string id{};     ///< name of the property that identifies a footprint; empty: the usual ones
  std::string layer{};  ///< empty: for OSM the areas tagged `building`, else every polygon layer
  std::string where{};  ///< OGR SQL condition; empty: all
  std::vector<Property>
      attributes{};  ///< --attr: given to every footprint, stronger than the file's
  std::vector<std::string> select{};  ///< ids; empty: all
  std::size_t limit = 0;              ///< 0: all
};

/// What could not be used, or was repaired. `broken` ones are left out of the set.
struct FootprintNote {
  std::string id;
  std::string text;  ///< "self-crossing ring repaired", "has no area"
  bool broken = false;
};

/// What local metres mean: WKT (ISO 19162) of the file's coordinate system and of the one in which
/// `unit` metres, less the shift, are local metres; empty: nobody said.
struct Georeference {
  std::string given, local;
  double unit = 1;
};

/// What is known of a set beside the footprints.
struct FootprintFacts {
  std::vector<FootprintNote> notes{};
  std::string origin{};  ///< how to get back: "local metres about lon 24.94, lat 60.17 (EPSG:4326)"
  Vec2 shift{};          ///< projected input: what was subtracted
  Georeference reference{};
  std::vector<std::string> properties{};  ///< names that some footprint has, each once
  std::vector<std::string> small{};       ///< ids that drop_small left out
  double least_area = 0;                  ///< square metres: they had less
};

struct FootprintSet : FootprintFacts {
  std::vector<Footprint> footprints{};
};

/// The same for any number: footprints beyond the first few thousand are on disk.
struct StoredSet : FootprintFacts {
  FootprintStore footprints{};
};

/// `what` is a path, or a literal: `rect:10x8`, `L:12x9x5x4`, `T:…`, `U:…`, `ring:…`, `WKT:…`.
/// Longitude/latitude become metres by an equal-distance projection (PROJ) about the set's middle;
/// projected metres are shifted to it; other units are converted. Throws Failure when nothing can
/// be read at all: no such file, a format GDAL does not know, a literal that is not one (the
/// message says what is).
StoredSet store_footprints(const std::string& what, const FootprintOptions& options);
FootprintSet read_footprints(const std::string& what, const FootprintOptions& options);
/// All of them in memory.
FootprintSet read_all(StoredSet set);

/// Leaves out footprints of less than `share` of the mean area of all, and their notes: sheds,
/// garages and splinters of a map. Before party walls are marked: nobody shares a wall with what is
/// not built.
void drop_small(StoredSet& set, double share = 0.1);

/// mark_neighbours (interpreter/footprint.hpp) of what is stored.
void mark_neighbours(StoredSet& set, const std::vector<StreetLine>& streets);

/// Keeps the footprints with the ids of `select` (`a` also means its further parts a:2, a:3; empty:
/// all), of these the first `limit` (0: all), and their notes. store_footprints does it too, but
/// party walls must be marked before neighbours are taken away. Throws Failure for an unknown id.
void choose_footprints(StoredSet& set, const std::vector<std::string>& select, std::size_t limit);

}  // namespace mansard
