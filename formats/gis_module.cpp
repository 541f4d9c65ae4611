#include "formats/gis_module.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <memory>

#include "formats/gis_features.hpp"
#include "formats/gis_osm.hpp"
#include "formats/gis_projection.hpp"

namespace mansard {
namespace {

/// Takes GDAL's messages instead of the terminal and keeps the first error.
class Messages {
 public:
  Messages() { CPLPushErrorHandlerEx(&Messages::take, this); }
  ~Messages() { CPLPopErrorHandler(); }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  const std::string& error() const { return error_; }
  void clear() { error_.clear(); }

 private:
  static void take(CPLErr kind, CPLErrorNum, const char* text) {
    auto& self = *static_cast<Messages*>(CPLGetErrorHandlerUserData());
    if (kind >= CE_Failure && self.error_.empty()) self.error_ = text;
  }
  std::string error_;
};

struct Failed {
  GisProblem problem;
};

[[noreturn]] void fail(std::string text, std::string help, const Messages& messages) {
  throw Failed{{std::move(text), std::move(help), messages.error(), {}, {}}};
}

void configure() {
  CPLSetThreadLocalConfigOption("OSM_CONFIG_FILE", osm_configuration());
  CPLSetThreadLocalConfigOption("SHAPE_RESTORE_SHX", "YES");  // a .shp without its index
}

/// What is read, in the user's words, and where OpenStreetMap has it.
struct Words {
  std::string wanted, one, shapes, others, osm_layer, osm_condition, osm_tag;
};

const Words footprint_words{"footprints",
                            "footprint",
                            "areas",
                            "points and lines",
                            "multipolygons",
                            "building IS NOT NULL AND building <> 'no'",
                            "no closed way or relation is tagged 'building'"};
const Words street_words{
    "streets",
    "street",
    "lines",
    "points and areas",
    "lines",
    "highway IN ('trunk', 'primary', 'secondary', 'tertiary', 'unclassified', 'residential', "
    "'living_street', 'pedestrian', 'road', 'trunk_link', 'primary_link', 'secondary_link', "
    "'tertiary_link') AND (tunnel IS NULL OR tunnel IN ('no', 'building_passage'))",
    "no way is tagged 'highway' as a road for all or for pedestrians"};

class Reader {
 public:
  Reader(const GisRequest& request, RawSet& set)
      : request_(request), set_(set), words_(request.beside ? street_words : footprint_words) {
    data_.reset(GDALDataset::Open(request.path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
    if (!data_) {
      fail("can not read " + words_.wanted + " from '" + request.path + "'",
           "GeoJSON, Shapefile, GeoPackage, FlatGeobuf, OpenStreetMap (.osm, .pbf), " +
               std::string(request.beside ? "" : "OBJ ") + "and whatever else GDAL knows will do",
           messages_);
    }
    driver_ = data_->GetDriverName();
    set_.rings_close = true;
  }

  void read() {
    for (OGRLayer* layer : chosen_layers()) read(*layer);
    if (set_.features->size() == 0) fail_empty();
    if (heights_) set_.notes.push_back({"", "heights (Z) of the points are ignored", false});
    if (others_ > 0) {
      set_.notes.push_back(
          {"", std::to_string(others_) + " " + words_.others + " are left out", false});
    }
    check_ids();
    messages_.clear();
    const bool guessed = driver_ == "GeoJSON";
    const std::string problem = request_.beside
                                    ? to_metres_of(*request_.beside, set_, ranges_, guessed)
                                    : to_local_metres(set_, ranges_, guessed);
    if (!problem.empty()) fail(problem, "", messages_);
  }

 private:
  bool is_osm() const { return driver_ == "OSM"; }
  bool can_hold_wanted(OGRLayer& layer) const;
  std::vector<OGRLayer*> chosen_layers();
  void read(OGRLayer& layer);
  void read_filtered(OGRLayer& layer, bool has_ids);
  std::string osm_query(OGRLayer& layer) const;
  bool gives_numbers(OGRLayer& layer) const;
  void check_ids();
  [[noreturn]] void fail_empty();
  [[noreturn]] void fail_others();

  const GisRequest& request_;
  RawSet& set_;
  const Words& words_;
  Messages messages_;
  GDALDatasetUniquePtr data_;
  std::string driver_;
  std::vector<GisRange> ranges_;
  std::vector<std::unique_ptr<OGRSpatialReference>> systems_;
  bool several_layers_ = false, heights_ = false;
  std::size_t others_ = 0, without_id_ = 0;
};

bool Reader::can_hold_wanted(OGRLayer& layer) const {
  const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
  if (type == wkbUnknown || type == wkbGeometryCollection) return true;
  const auto one = request_.beside ? wkbCurve : wkbSurface;
  const auto several = request_.beside ? wkbMultiCurve : wkbMultiSurface;
  return OGR_GT_IsSubClassOf(type, one) || OGR_GT_IsSubClassOf(type, several);
}

std::vector<OGRLayer*> Reader::chosen_layers() {
  std::string wanted = request_.layer;
  if (wanted.empty() && is_osm()) wanted = words_.osm_layer;
  std::vector<OGRLayer*> layers;
  std::vector<std::string> names;
  for (OGRLayer* layer : data_->GetLayers()) {
    names.emplace_back(layer->GetName());
    if (wanted.empty() ? can_hold_wanted(*layer) : names.back() == wanted) layers.push_back(layer);
  }
  if (layers.empty() && !wanted.empty()) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    throw Failed{{"'" + request_.path + "' has no layer '" + wanted + "'", "its layers are " + list,
                  "", wanted, names}};
  }
  if (layers.empty() && !names.empty()) fail_others();
  several_layers_ = layers.size() > 1;
  return layers;
}

void Reader::read(OGRLayer& layer) {
  if (is_osm()) {
    // Through a query the driver builds no other layer.
    const std::string query = osm_query(layer);
    const auto release = [&](OGRLayer* result) { data_->ReleaseResultSet(result); };
    const std::unique_ptr<OGRLayer, decltype(release)> result(
        data_->ExecuteSQL(query.c_str(), nullptr, nullptr), release);
    if (!result) fail("'" + request_.where + "' is not a condition of OGR SQL", "", messages_);
    read_filtered(*result, false);
    return;
  }
  const bool has_ids = *layer.GetFIDColumn() != '\0' || gives_numbers(layer);
  if (!request_.where.empty() && layer.SetAttributeFilter(request_.where.c_str()) != OGRERR_NONE) {
    fail("'" + request_.where + "' is not a condition of OGR SQL", "", messages_);
  }
  read_filtered(layer, has_ids);
}

std::string Reader::osm_query(OGRLayer& layer) const {
  std::string conditions;
  const bool usual = request_.layer.empty() && (!request_.beside || request_.where.empty());
  if (usual) conditions = words_.osm_condition;
  if (!request_.where.empty()) {
    conditions += (conditions.empty() ? "(" : " AND (") + request_.where + ")";
  }
  return "SELECT * FROM " + std::string(layer.GetName()) +
         (conditions.empty() ? "" : " WHERE " + conditions);
}

/// Whether a GeoJSON file has ids of its own: GDAL numbers features from 0 where it has none. (Ids
/// that are the same as these numbers need no answer.) To be asked before a condition is set.
bool Reader::gives_numbers(OGRLayer& layer) const {
  if (driver_.find("GeoJSON") != 0) return false;
  GIntBig place = 0;
  layer.ResetReading();
  while (const std::unique_ptr<OGRFeature> feature{layer.GetNextFeature()}) {
    if (feature->GetFID() != place++) return true;
  }
  return false;
}

void Reader::read_filtered(OGRLayer& layer, bool has_ids) {
  GisRange range{set_.features->size(), 0, nullptr, {}};
  if (const OGRSpatialReference* crs = layer.GetSpatialRef()) {
    systems_.emplace_back(crs->Clone());
    range.crs = systems_.back().get();
  }
  const auto geometry = request_.beside ? GisGeometry::lines : GisGeometry::areas;
  GisFeatures features(geometry, *layer.GetLayerDefn(), has_ids, request_.id,
                       several_layers_ ? layer.GetName() + std::string("/") : "");
  messages_.clear();
  layer.ResetReading();
  RawFeature raw;
  while (const std::unique_ptr<OGRFeature> feature{layer.GetNextFeature()}) {
    if (!features.convert(*feature, raw)) continue;
    range.add_sample(raw);
    set_.features->add(raw);
  }
  if (!messages_.error().empty()) {
    fail("'" + request_.path + "' is damaged: reading stopped after " +
             std::to_string(set_.features->size() - range.begin) + " " + words_.wanted,
         "", messages_);
  }
  range.end = set_.features->size();
  if (range.end > range.begin) ranges_.push_back(std::move(range));
  others_ += features.others();
  without_id_ += features.without_id();
  heights_ = heights_ || features.has_heights();
}

void Reader::check_ids() {
  if (without_id_ == 0) return;
  if (without_id_ < set_.features->size()) {
    set_.notes.push_back({"",
                          std::to_string(without_id_) + " footprints without '" + request_.id +
                              "' are named as usual",
                          false});
    return;
  }
  std::vector<std::string> names;
  set_.features->for_each([&](std::size_t, const RawFeature& feature) {
    for (const Property& p : feature.properties) {
      if (std::find(names.begin(), names.end(), p.name) == names.end()) names.push_back(p.name);
    }
  });
  throw Failed{{"no footprint has a property '" + request_.id + "'", "", "", request_.id, names}};
}

void Reader::fail_others() {
  messages_.clear();
  fail("'" + request_.path + "' has no " + words_.shapes + ", only " + words_.others,
       request_.beside ? "streets are lines" : "footprints are polygons", messages_);
}

void Reader::fail_empty() {
  messages_.clear();
  if (!request_.where.empty()) {
    fail("no " + words_.one + " of '" + request_.path + "' fulfils '" + request_.where + "'", "",
         messages_);
  }
  if (others_ > 0) fail_others();
  fail("'" + request_.path + "' has no " + words_.wanted,
       is_osm() && request_.layer.empty() ? words_.osm_tag : "", messages_);
}

}  // namespace
}  // namespace mansard

extern "C" bool mansard_read_gis(const mansard::GisRequest& request, mansard::RawSet& set,
                                 mansard::GisProblem& problem) try {
  mansard::configure();
  GDALAllRegister();
  mansard::Reader(request, set).read();
  return true;
} catch (mansard::Failed& failed) {
  problem = std::move(failed.problem);
  return false;
} catch (const mansard::Failure& failure) {  // of where the features are kept
  problem.text = failure.diagnostic.text;
  problem.help = failure.diagnostic.help;
  return false;
} catch (const std::exception& e) {
  problem.text = "can not read '" + request.path + "': " + e.what();
  return false;
}
