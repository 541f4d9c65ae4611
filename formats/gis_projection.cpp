#include "formats/gis_projection.hpp"

#include <cpl_conv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <span>

namespace mansard {
namespace {

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Every ring of all features, in the file's coordinates.
template <class F>
void for_each_ring(const RawSet& set, F f) {
  set.features->for_each([&](std::size_t, const RawFeature& feature) {
    for (const RawPolygon& part : feature.parts) {
      for (const RawRing& ring : part) f(ring);
    }
  });
}

std::vector<Vec2> samples(const std::vector<GisRange>& ranges) {
  std::vector<Vec2> points;
  for (const GisRange& range : ranges)
    points.insert(points.end(), range.samples.begin(), range.samples.end());
  return points;
}

double median(std::span<double> values) {
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Coordinate by coordinate. It is never far from the set, as a box's middle would be where there
/// is a stray point (0, 0) or where the date line runs through.
Vec2 median(const std::vector<Vec2>& points) {
  if (points.empty()) return {};
  std::vector<double> x, y;
  for (Vec2 p : points) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  return {median(x), median(y)};
}

void transform(OGRCoordinateTransformation& by, std::vector<Vec2>& points) {
  std::vector<double> x, y;
  for (Vec2 p : points) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  std::vector<int> done(points.size());
  by.Transform(static_cast<int>(points.size()), x.data(), y.data(), nullptr, done.data());
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = done[i] ? Vec2{x[i], y[i]} : Vec2{nan, nan};
  }
}

Transformation transformation(const OGRSpatialReference& from, const OGRSpatialReference& to) {
  return Transformation(OGRCreateCoordinateTransformation(&from, &to));
}

OGRSpatialReference geographic(const OGRSpatialReference& crs) {
  OGRSpatialReference result;
  result.CopyGeogCSFrom(&crs);
  result.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return result;
}

/// Metres about a place, on the ellipsoid of `crs`.
OGRSpatialReference about(Vec2 lon_lat, const OGRSpatialReference& crs) {
  OGRSpatialReference result;
  result.SetProjCS("local metres");
  result.CopyGeogCSFrom(&crs);
  result.SetAE(lon_lat.y, lon_lat.x, 0, 0);
  result.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return result;
}

std::string name_of(const OGRSpatialReference& crs) {
  const char* authority = crs.GetAuthorityName(nullptr);
  const char* code = crs.GetAuthorityCode(nullptr);
  if (authority != nullptr && code != nullptr) return std::string(authority) + ":" + code;
  const char* name = crs.GetName();
  return name != nullptr ? name : "unnamed coordinate system";
}

std::string wkt_of(const OGRSpatialReference& crs) {
  constexpr std::array<const char*, 2> options{"FORMAT=WKT2_2019", nullptr};
  char* text = nullptr;
  crs.exportToWkt(&text, options.data());
  std::string wkt = text != nullptr ? text : "";
  CPLFree(text);
  return wkt;
}

OGRSpatialReference from_wkt(const std::string& wkt) {
  OGRSpatialReference crs;
  crs.importFromWkt(wkt.c_str());
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

std::string format(const char* pattern, double a, double b) {
  std::array<char, 100> text;
  std::snprintf(text.data(), text.size(), pattern, a, b);
  return text.data();
}

/// Longitude and latitude of the median, rounded to 1e-4 degrees so that they can be printed.
std::optional<Vec2> middle(const std::vector<GisRange>& ranges,
                           const OGRSpatialReference& degrees) {
  std::vector<Vec2> all;
  for (const GisRange& range : ranges) {
    std::vector<Vec2> points = range.samples;
    const Transformation to_degrees = transformation(*range.crs, degrees);
    if (!to_degrees) return {};
    transform(*to_degrees, points);
    std::erase_if(points, [](Vec2 p) { return !std::isfinite(p.x + p.y); });
    all.insert(all.end(), points.begin(), points.end());
  }
  const Vec2 result = median(all);
  return Vec2{std::round(result.x * 1e4) / 1e4, std::round(result.y * 1e4) / 1e4};
}

/// Whether u is east, v is north and both are metres, within 1 % and 10 degrees, about `at`.
/// Web Mercator is not, nor is plate carree, nor a grid that counts south and west.
bool is_true(const OGRSpatialReference& crs, double unit, Vec2 at, Vec2 lon_lat) {
  const OGRSpatialReference local = about(lon_lat, crs);
  const Transformation to_local = transformation(crs, local);
  if (!to_local) return true;  // nothing to compare with
  const double step = 100 / unit;
  std::vector<Vec2> p{at, at + Vec2{step, 0}, at + Vec2{0, step}};
  transform(*to_local, p);
  const Vec2 u = (p[1] - p[0]) * 0.01, v = (p[2] - p[0]) * 0.01;
  if (!std::isfinite(length(u) + length(v))) return true;
  const auto is_unit = [](Vec2 a) { return std::abs(length(a) - 1) < 0.01; };
  return is_unit(u) && is_unit(v) && std::abs(cross(u, v) - 1) < 0.02 && u.x > 0.985;
}

/// A transformation, where there is one, for each range; then metres, then the shift.
struct ToLocal {
  struct Part {
    std::size_t end = 0;  ///< one past its last feature
    std::shared_ptr<OGRCoordinateTransformation> by;
  };
  std::vector<Part> parts{};
  double unit = 1;
  Vec2 shift{};

  void operator()(std::size_t number, RawFeature& feature) const {
    const auto part = std::ranges::upper_bound(parts, number, {}, &Part::end);
    for (RawPolygon& polygon : feature.parts) {
      for (RawRing& ring : polygon) {
        if (part != parts.end() && part->by) transform(*part->by, ring);
        for (Vec2& p : ring) p = p * unit - shift;
      }
    }
  }
};

/// Shifts to the median, in whole metres. Values within 10 km of zero stay: they are local already.
void shift(RawSet& set, const std::vector<GisRange>& ranges, double unit, bool always) {
  const Vec2 at = median(samples(ranges)) * unit;
  if (always || length(at) > 10'000) set.shift = {std::round(at.x), std::round(at.y)};
  set.to_local = ToLocal{{}, unit, set.shift};
}

void take_as_metres(RawSet& set, const std::vector<GisRange>& ranges) {
  shift(set, ranges, 1, false);
  set.origin = "the file's own metres";
  if (set.shift != Vec2{}) {
    set.origin += format(" less (%.0f, %.0f)", set.shift.x, set.shift.y);
  }
}

/// Nobody said what the numbers are. Buildings of less than 0.1 m are buildings in degrees.
bool look_like_degrees(const RawSet& set) {
  double largest = 0;
  bool in_range = true;
  for_each_ring(set, [&](const RawRing& ring) {
    for (Vec2 p : ring) {
      in_range = in_range && std::abs(p.x) <= 180 && std::abs(p.y) <= 90;
      largest = std::max({largest, std::abs(p.x - ring[0].x), std::abs(p.y - ring[0].y)});
    }
  });
  return in_range && largest > 0 && largest < 0.1;
}

/// Most points lie where no longitude and latitude can.
bool can_not_be_degrees(const std::vector<GisRange>& ranges) {
  const std::vector<Vec2> points = samples(ranges);
  const auto outside = std::count_if(points.begin(), points.end(), [](Vec2 p) {
    return std::abs(p.x) > 360 || std::abs(p.y) > 90;
  });
  return 2 * std::size_t(outside) > points.size();
}

std::string to_equidistant(RawSet& set, const std::vector<GisRange>& ranges, Vec2 lon_lat) {
  const OGRSpatialReference& first = *ranges[0].crs;
  const OGRSpatialReference local = about(lon_lat, first);
  ToLocal to_local;
  for (const GisRange& range : ranges) {
    to_local.parts.push_back({range.end, transformation(*range.crs, local)});
    if (!to_local.parts.back().by) return "can not convert " + name_of(*range.crs) + " to metres";
  }
  set.to_local = to_local;
  set.reference = {wkt_of(first), wkt_of(local), 1};
  set.origin = format("local metres about lon %.4f, lat %.4f (", lon_lat.x, lon_lat.y) +
               name_of(first) + ", azimuthal equidistant)";
  return {};
}

}  // namespace

void GisRange::add_sample(const RawFeature& feature) {
  if (feature.parts.empty() || feature.parts[0].empty() || feature.parts[0][0].empty()) return;
  const Vec2 p = feature.parts[0][0][0];
  if (std::isfinite(p.x + p.y)) samples.push_back(p);
}

std::string to_local_metres(RawSet& set, std::vector<GisRange> ranges, bool guessed) {
  OGRSpatialReference wgs84;
  wgs84.SetWellKnownGeogCS("WGS84");
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);

  // What do the coordinates mean?
  const auto known = std::find_if(ranges.begin(), ranges.end(), [](const GisRange& r) {
    return r.crs != nullptr && !r.crs->IsLocal();
  });
  const OGRSpatialReference* crs = known != ranges.end() ? known->crs : nullptr;
  if (crs != nullptr && guessed && crs->IsGeographic() && can_not_be_degrees(ranges)) {
    crs = nullptr;
    set.notes.push_back(
        {"", "the coordinates are no longitudes and latitudes: read as metres", false});
  } else if (crs == nullptr && look_like_degrees(set)) {
    crs = &wgs84;
    set.notes.push_back(
        {"", "no coordinate system is given: read as longitude and latitude (WGS 84)", false});
  }
  if (crs == nullptr) {
    take_as_metres(set, ranges);
    return {};
  }
  bool alike = true;
  for (GisRange& range : ranges) {
    if (range.crs == nullptr || range.crs->IsLocal()) range.crs = crs;
    alike = alike && range.crs->IsSame(crs);
  }

  // Metres, or feet, that can stay?
  const std::optional<Vec2> lon_lat = middle(ranges, geographic(*crs));
  if (!lon_lat) return "can not convert " + name_of(*crs) + " to longitude and latitude";
  if (alike && crs->IsProjected()) {
    const double unit = crs->GetLinearUnits();
    const Vec2 at = median(samples(ranges));
    if (is_true(*crs, unit, at, *lon_lat)) {
      shift(set, ranges, unit, true);
      set.reference = {wkt_of(*crs), wkt_of(*crs), unit};
      set.origin = name_of(*crs) + (unit == 1 ? "" : " in metres") +
                   format(" less (%.0f, %.0f)", set.shift.x, set.shift.y);
      return {};
    }
  }
  return to_equidistant(set, ranges, *lon_lat);
}

std::string to_metres_of(const GisRequest::Beside& beside, RawSet& set,
                         const std::vector<GisRange>& ranges, bool guessed) {
  ToLocal to_local{{}, beside.reference.unit, beside.shift};
  const auto is_known = [&](const GisRange& range) {
    if (range.crs == nullptr || range.crs->IsLocal()) return false;
    return !(guessed && range.crs->IsGeographic() && can_not_be_degrees(ranges));
  };
  if (beside.reference.local.empty()) {
    const auto known = std::ranges::find_if(ranges, is_known);
    if (known != ranges.end() && !guessed)
      return "the streets are in " + name_of(*known->crs) +
             ", and the footprints have no coordinate system";
    set.to_local = to_local;
    return {};
  }
  const OGRSpatialReference given = from_wkt(beside.reference.given);
  const OGRSpatialReference local = from_wkt(beside.reference.local);
  for (const GisRange& range : ranges) {
    const OGRSpatialReference& crs = is_known(range) ? *range.crs : given;
    to_local.parts.push_back({range.end, transformation(crs, local)});
    if (!to_local.parts.back().by) return "can not convert " + name_of(crs) + " to metres";
  }
  set.to_local = to_local;
  return {};
}

}  // namespace mansard
