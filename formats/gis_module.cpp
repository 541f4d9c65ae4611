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

class Reader {
 public:
  Reader(const GisRequest& request, RawSet& set) : request_(request), set_(set) {
    data_.reset(GDALDataset::Open(request.path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
    if (!data_) {
      fail("can not read footprints from '" + request.path + "'",
           "GeoJSON, Shapefile, GeoPackage, FlatGeobuf, OpenStreetMap (.osm, .pbf), OBJ and "
           "whatever "
           "else GDAL knows will do",
           messages_);
    }
    driver_ = data_->GetDriverName();
    set_.rings_close = true;
  }

  void read() {
    for (OGRLayer* layer : chosen_layers()) read(*layer);
    if (set_.features.empty()) fail_empty();
    if (heights_) set_.notes.push_back({"", "heights (Z) of the points are ignored", false});
    if (no_areas_ > 0) {
      set_.notes.push_back(
          {"", std::to_string(no_areas_) + " points and lines are left out", false});
    }
    check_ids();
    messages_.clear();
    const std::string problem = to_local_metres(set_, ranges_, driver_ == "GeoJSON");
    if (!problem.empty()) fail(problem, "", messages_);
  }

 private:
  bool is_osm() const { return driver_ == "OSM"; }
  std::vector<OGRLayer*> chosen_layers();
  void read(OGRLayer& layer);
  void read_filtered(OGRLayer& layer, bool has_ids);
  std::string osm_query(OGRLayer& layer) const;
  bool gives_numbers(OGRLayer& layer) const;
  void check_ids();
  [[noreturn]] void fail_empty();
  [[noreturn]] void fail_no_areas();

  const GisRequest& request_;
  RawSet& set_;
  Messages messages_;
  GDALDatasetUniquePtr data_;
  std::string driver_;
  std::vector<GisRange> ranges_;
  std::vector<std::unique_ptr<OGRSpatialReference>> systems_;
  bool several_layers_ = false, heights_ = false;
  std::size_t no_areas_ = 0, without_id_ = 0;
};

bool can_hold_areas(OGRLayer& layer) {
  const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
  return type == wkbUnknown || OGR_GT_IsSubClassOf(type, wkbSurface) ||
         OGR_GT_IsSubClassOf(type, wkbMultiSurface) || type == wkbGeometryCollection;
}

std::vector<OGRLayer*> Reader::chosen_layers() {
  std::string wanted = request_.layer;
  if (wanted.empty() && is_osm()) wanted = "multipolygons";
  std::vector<OGRLayer*> layers;
  std::vector<std::string> names;
  for (OGRLayer* layer : data_->GetLayers()) {
    names.emplace_back(layer->GetName());
    if (wanted.empty() ? can_hold_areas(*layer) : names.back() == wanted) layers.push_back(layer);
  }
  if (layers.empty() && !wanted.empty()) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    throw Failed{{"'" + request_.path + "' has no layer '" + wanted + "'", "its layers are " + list,
                  "", wanted, names}};
  }
  if (layers.empty() && !names.empty()) fail_no_areas();
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
  if (request_.layer.empty()) conditions = "building IS NOT NULL AND building <> 'no'";
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
  GisRange range{set_.features.size(), 0, nullptr};
  if (const OGRSpatialReference* crs = layer.GetSpatialRef()) {
    systems_.emplace_back(crs->Clone());
    range.crs = systems_.back().get();
  }
  GisFeatures features(*layer.GetLayerDefn(), has_ids, request_.id,
                       several_layers_ ? layer.GetName() + std::string("/") : "");
  messages_.clear();
  layer.ResetReading();
  while (const std::unique_ptr<OGRFeature> feature{layer.GetNextFeature()}) {
    features.add(*feature, set_);
  }
  if (!messages_.error().empty()) {
    fail("'" + request_.path + "' is damaged: reading stopped after " +
             std::to_string(set_.features.size() - range.begin) + " footprints",
         "", messages_);
  }
  range.end = set_.features.size();
  if (range.end > range.begin) ranges_.push_back(range);
  no_areas_ += features.points_and_lines();
  without_id_ += features.without_id();
  heights_ = heights_ || features.has_heights();
}

void Reader::check_ids() {
  if (without_id_ == 0) return;
  if (without_id_ < set_.features.size()) {
    set_.notes.push_back({"",
                          std::to_string(without_id_) + " footprints without '" + request_.id +
                              "' are named as usual",
                          false});
    return;
  }
  std::vector<std::string> names;
  for (const RawFeature& feature : set_.features) {
    for (const Property& p : feature.properties) {
      if (std::find(names.begin(), names.end(), p.name) == names.end()) names.push_back(p.name);
    }
  }
  throw Failed{{"no footprint has a property '" + request_.id + "'", "", "", request_.id, names}};
}

void Reader::fail_no_areas() {
  messages_.clear();
  fail("'" + request_.path + "' has no areas, only points and lines", "footprints are polygons",
       messages_);
}

void Reader::fail_empty() {
  messages_.clear();
  if (!request_.where.empty()) {
    fail("no footprint of '" + request_.path + "' fulfils '" + request_.where + "'", "", messages_);
  }
  if (no_areas_ > 0) fail_no_areas();
  fail("'" + request_.path + "' has no footprints",
       is_osm() && request_.layer.empty() ? "no closed way or relation is tagged 'building'" : "",
       messages_);
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
} catch (const std::exception& e) {
  problem.text = "can not read '" + request.path + "': " + e.what();
  return false;
}
