// What every reader of footprints hands on before rings are cleaned and repaired.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/footprints.hpp"
#include "formats/streets.hpp"
#include "geometry/vector.hpp"

namespace mansard {

/// A ring as it was found: it may be open, repeat points, cross itself or hold NaN.
using RawRing = std::vector<Vec2>;
/// The outline first, then the holes.
using RawPolygon = std::vector<RawRing>;

struct RawFeature {
  std::string id;
  std::vector<RawPolygon> parts;
  std::vector<Property> properties;
};

/// The features of a set as they were found, on disk when they are many. (An interface, so that the
/// module that reads GIS files needs nothing of the program.)
class RawFeatures {
 public:
  virtual ~RawFeatures() = default;
  virtual void add(const RawFeature& feature) = 0;
  virtual std::size_t size() const = 0;
  using Use = std::function<void(std::size_t number, RawFeature& feature)>;
  /// In order; what `use` changes is not kept.
  virtual void for_each(const Use& use) const = 0;
};
std::unique_ptr<RawFeatures> no_features();

struct RawSet {
  std::unique_ptr<RawFeatures> features = no_features();
  /// From the file's coordinates to local metres: replaces those of a feature. None: they are.
  RawFeatures::Use to_local{};
  std::vector<FootprintNote> notes{};  ///< about the set; their id is empty
  std::string origin = "local metres";
  Vec2 shift{};
  Georeference reference{};
  bool rings_close = false;  ///< rings end with their first point, by the format's rules

  /// In local metres.
  void for_each(const std::function<void(RawFeature&)>& use) const {
    features->for_each([&](std::size_t number, RawFeature& feature) {
      if (to_local) to_local(number, feature);
      use(feature);
    });
  }
};

/// Literals: `rect:10x8`, `L:12x9x5x4`, ... Nothing when `what` does not begin like one; throws
/// Failure with the right form when it does and goes wrong.
std::optional<RawSet> read_literal(std::string_view what);
/// The forms of literals, for help: "rect:10x8, L:12x9x5x4, ...".
std::string literal_forms();

/// Well-known text (OGC 06-103r4 §7): POLYGON and MULTIPOLYGON, Z and M are passed over. Throws
/// Failure that quotes where it went wrong.
std::vector<RawPolygon> read_wkt(std::string_view text);

/// Well-known text: LINESTRING and MULTILINESTRING; as above.
std::vector<RawRing> read_wkt_lines(std::string_view text);

/// Every face of an OBJ (u = x, v = -z). Throws Failure.
RawSet read_obj_footprints(const std::string& path);

/// Everything GDAL knows. Throws Failure.
RawSet read_gis(const std::string& path, const FootprintOptions& options);

/// The lines of a file that GDAL knows, in the local metres of `beside`; each is a feature of one
/// part with one ring, which is open. Throws Failure.
RawSet read_gis_lines(const std::string& path, const StreetOptions& options,
                      const FootprintFacts& beside);

/// Throws Failure unless `what` is a file; `content` says what it should hold, "footprints".
void check_is_file(const std::string& what, std::string_view content, const std::string& forms);

}  // namespace mansard
