// OGR's features as raw footprints.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "formats/footprint_sources.hpp"

class OGRFeature;
class OGRFeatureDefn;

namespace mansard {

enum class GisGeometry { areas, lines };

/// Converts the features of one layer.
class GisFeatures {
 public:
  /// `id_name`: the property that identifies a feature; empty: osm_id, the feature id (when
  /// `has_ids`), id, else the place in the file. `prefix` goes before every id.
  GisFeatures(GisGeometry geometry, const OGRFeatureDefn& fields, bool has_ids, std::string id_name,
              std::string prefix);

  /// Replaces `raw` by the feature, in the file's coordinates; false when its geometry is another.
  /// A line is a part with one open ring.
  bool convert(const OGRFeature& feature, RawFeature& raw);

  /// Features of another geometry.
  std::size_t others() const { return others_; }
  bool has_heights() const { return has_heights_; }
  /// Features without the property `id_name`.
  std::size_t without_id() const { return without_id_; }

 private:
  std::string id_of(const OGRFeature& feature, const std::vector<Property>& properties);
  void add_properties(const OGRFeature& feature, std::vector<Property>& to) const;

  enum class Kind { number, boolean, text, tags };
  struct Field {
    std::string name;
    Kind kind;
  };
  GisGeometry geometry_;
  std::vector<Field> fields_;
  bool has_ids_;
  std::string id_name_, prefix_;
  std::size_t place_ = 0, others_ = 0, without_id_ = 0;
  bool has_heights_ = false;
};

}  // namespace mansard
