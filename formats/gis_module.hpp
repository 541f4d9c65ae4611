// The door of the module mansard_gis, the only part that knows GDAL and PROJ. No exception passes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formats/footprint_sources.hpp"

namespace mansard {

struct GisRequest {
  std::string path, layer, where, id;  ///< as in FootprintOptions
  /// Lines beside footprints: where those are. Without, areas are read.
  struct Beside {
    Georeference reference;
    Vec2 shift;
  };
  std::optional<Beside> beside{};
};

/// Why nothing could be read.
struct GisProblem {
  std::string text, help;
  std::string detail;                   ///< GDAL's own words, if any
  std::string word;                     ///< what the user may have mistyped
  std::vector<std::string> candidates;  ///< what could have been meant
};

}  // namespace mansard

/// Reads features in local metres into `set`. False on failure, with the reason in `problem`.
extern "C" bool mansard_read_gis(const mansard::GisRequest& request, mansard::RawSet& set,
                                 mansard::GisProblem& problem);
