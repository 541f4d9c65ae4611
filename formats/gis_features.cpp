#include "formats/gis_features.hpp"

#include <ogrsf_frmts.h>

#include <array>
#include <charconv>
#include <cmath>
#include <memory>

#include "formats/gis_osm.hpp"

namespace mansard {
namespace {

void add_ring(const OGRLinearRing& ring, RawPolygon& to) {
  RawRing& points = to.emplace_back();
  points.reserve(ring.getNumPoints());
  for (int i = 0; i < ring.getNumPoints(); ++i) points.push_back({ring.getX(i), ring.getY(i)});
}

void add_polygon(const OGRPolygon& polygon, std::vector<RawPolygon>& to) {
  const OGRLinearRing* outline = polygon.getExteriorRing();
  if (outline == nullptr) return;
  RawPolygon& raw = to.emplace_back();
  add_ring(*outline, raw);
  for (int i = 0; i < polygon.getNumInteriorRings(); ++i) {
    add_ring(*polygon.getInteriorRing(i), raw);
  }
}

/// The areas of any geometry; false when it has none because it is made of points and lines.
bool add_areas(const OGRGeometry& geometry, std::vector<RawPolygon>& to) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (geometry.hasCurveGeometry()) {
    const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry());
    return straight && add_areas(*straight, to);
  }
  if (OGR_GT_IsSubClassOf(type, wkbPolygon)) {
    add_polygon(*geometry.toPolygon(), to);
    return true;
  }
  if (type == wkbPolyhedralSurface || type == wkbTIN) {
    for (const OGRPolygon* face : *geometry.toPolyhedralSurface()) add_polygon(*face, to);
    return true;
  }
  if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
    bool any = geometry.IsEmpty();
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
      any = add_areas(*part, to) || any;
    }
    return any;
  }
  return false;
}

/// The lines of any geometry; false when it has none.
bool add_lines(const OGRGeometry& geometry, std::vector<RawPolygon>& to) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (geometry.hasCurveGeometry()) {
    const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry());
    return straight && add_lines(*straight, to);
  }
  if (OGR_GT_IsSubClassOf(type, wkbLineString)) {
    const OGRLineString& line = *geometry.toLineString();
    RawRing& points = to.emplace_back().emplace_back();
    for (int i = 0; i < line.getNumPoints(); ++i) points.push_back({line.getX(i), line.getY(i)});
    return true;
  }
  bool any = false;
  if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection())
      any = add_lines(*part, to) || any;
  }
  return any;
}

std::string as_text(const PropertyValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* yes = std::get_if<bool>(&value)) return *yes ? "true" : "false";
  std::array<char, 40> text;
  char* end = std::to_chars(text.data(), text.data() + text.size(), std::get<double>(value)).ptr;
  return std::string(text.data(), end);
}

/// The first of `names` that is there, as text; empty when none is.
std::string first_of(const std::vector<Property>& properties,
                     std::initializer_list<std::string_view> names) {
  for (std::string_view name : names) {
    for (const Property& p : properties) {
      if (p.name == name) return as_text(p.value);
    }
  }
  return {};
}

}  // namespace

GisFeatures::GisFeatures(GisGeometry geometry, const OGRFeatureDefn& fields, bool has_ids,
                         std::string id_name, std::string prefix)
    : geometry_(geometry),
      has_ids_(has_ids),
      id_name_(std::move(id_name)),
      prefix_(std::move(prefix)) {
  for (int i = 0; i < fields.GetFieldCount(); ++i) {
    const OGRFieldDefn& field = *fields.GetFieldDefn(i);
    const OGRFieldType type = field.GetType();
    const bool is_number = type == OFTInteger || type == OFTInteger64 || type == OFTReal;
    Kind kind = is_number ? Kind::number : Kind::text;
    if (field.GetSubType() == OFSTBoolean) kind = Kind::boolean;
    if (std::string_view(field.GetNameRef()) == "other_tags") kind = Kind::tags;
    fields_.push_back({field.GetNameRef(), kind});
  }
}

bool GisFeatures::convert(const OGRFeature& feature, RawFeature& raw) {
  ++place_;
  raw.parts.clear();
  raw.properties.clear();
  if (const OGRGeometry* geometry = feature.GetGeometryRef()) {
    const bool is_one = geometry_ == GisGeometry::areas ? add_areas(*geometry, raw.parts)
                                                        : add_lines(*geometry, raw.parts);
    if (!is_one) {
      ++others_;
      return false;
    }
    has_heights_ = has_heights_ || geometry->Is3D();
  }
  add_properties(feature, raw.properties);
  raw.id = prefix_ + id_of(feature, raw.properties);
  return true;
}

void GisFeatures::add_properties(const OGRFeature& feature, std::vector<Property>& to) const {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Field& field = fields_[i];
    const int number = static_cast<int>(i);
    if (!feature.IsFieldSetAndNotNull(number)) continue;
    switch (field.kind) {
      case Kind::number:
        to.push_back({field.name, feature.GetFieldAsDouble(number)});
        break;
      case Kind::boolean:
        to.push_back({field.name, feature.GetFieldAsInteger(number) != 0});
        break;
      case Kind::text:
        to.push_back({field.name, std::string(feature.GetFieldAsString(number))});
        break;
      case Kind::tags:
        add_hstore(feature.GetFieldAsString(number), to);
        break;
    }
  }
}

std::string GisFeatures::id_of(const OGRFeature& feature, const std::vector<Property>& properties) {
  if (!id_name_.empty()) {
    std::string id = first_of(properties, {id_name_});
    if (!id.empty()) return id;
    ++without_id_;
  }
  std::string id = first_of(properties, {"osm_id", "osm_way_id"});
  if (!id.empty()) return id;
  const GIntBig number = feature.GetFID();
  if (has_ids_ && number != OGRNullFID) return std::to_string(number);
  id = first_of(properties, {"id"});
  if (!id.empty()) return id;
  // Counted by GDAL over the unfiltered file.
  return std::to_string(number != OGRNullFID ? number : GIntBig(place_ - 1));
}

}  // namespace mansard
