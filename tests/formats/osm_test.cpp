#include <doctest/doctest.h>

#include <cstdio>
#include <filesystem>
#include <set>

#include "formats/footprints.hpp"
#include "support.hpp"

using namespace mansard;

namespace {

/// The real sets lie beside the project.
std::string data(const std::string& name) {
  const std::string path = "../shared/data/" + name;
  if (std::filesystem::exists(path)) return path;
  MESSAGE("skipped: " << path << " is not here");
  return {};
}

struct Real {
  const char* file;
  std::size_t at_least;
  double longitude, latitude;
};

std::size_t with(const FootprintSet& set, const char* property) {
  std::size_t count = 0;
  for (const Footprint& f : set.footprints) count += f.find(property) != nullptr;
  return count;
}

void check(const FootprintSet& set) {
  std::set<std::string> ids;
  std::size_t bad = 0, far = 0;
  for (const Footprint& f : set.footprints) {
    ids.insert(f.id);
    bad += !(area(f.polygon) > 0) || f.polygon.tags.size() != f.polygon.points.size();
    for (std::size_t r = 0; r < f.polygon.rings(); ++r) {
      bad += (area(f.polygon.ring(r)) > 0) != (r == 0);
    }
    far += length(f.polygon.points[0]) > 30'000;
  }
  CHECK(bad == 0);
  CHECK(far == 0);
  CHECK(ids.size() == set.footprints.size());
  CHECK(with(set, "building") == set.footprints.size());
}

}  // namespace

TEST_CASE("buildings of real towns") {
  for (const Real& real :
       {Real{"helsinki.osm.pbf", 497, 24.9, 60.2}, Real{"monaco.osm.pbf", 1207, 7.4, 43.7},
        Real{"baltimore.osm.pbf", 1731, -76.6, 39.3},
        Real{"liechtenstein.osm.pbf", 8993, 9.5, 47.1}}) {
    CAPTURE(real.file);
    const std::string path = data(real.file);
    if (path.empty()) continue;
    const FootprintSet set = read_footprints(path, {});
    CHECK(set.footprints.size() >= real.at_least);
    double lon = 0, lat = 0;
    REQUIRE(std::sscanf(set.origin.c_str(), "local metres about lon %lf, lat %lf", &lon, &lat) ==
            2);
    CHECK(lon == doctest::Approx(real.longitude).epsilon(0.01));
    CHECK(lat == doctest::Approx(real.latitude).epsilon(0.01));
    check(set);
  }
}

namespace {

/// Nodes 1 to 8: a square of about 11 m in a square of about 33 m.
const std::string nodes = R"(<?xml version="1.0" encoding="UTF-8"?><osm version="0.6">
<node id="1" lat="60.0000" lon="24.0000"/><node id="2" lat="60.0000" lon="24.0006"/>
<node id="3" lat="60.0003" lon="24.0006"/><node id="4" lat="60.0003" lon="24.0000"/>
<node id="5" lat="60.0001" lon="24.0002"/><node id="6" lat="60.0002" lon="24.0002"/>
<node id="7" lat="60.0002" lon="24.0004"/><node id="8" lat="60.0001" lon="24.0004"/>)";

std::string way(int id, const std::string& along, const std::string& tags) {
  std::string text = "<way id=\"" + std::to_string(id) + "\">";
  for (char node : along) text += std::string("<nd ref=\"") + node + "\"/>";
  return text + tags + "</way>";
}

std::string tag(const std::string& key, const std::string& value) {
  return "<tag k=\"" + key + "\" v=\"" + value + "\"/>";
}

}  // namespace

TEST_CASE("OpenStreetMap: ways, relations and tags") {
  const test::Folder folder;
  const std::string path = folder.write(
      "a.osm",
      nodes + way(10, "12341", "") + way(11, "56785", tag("building", "shed")) +
          way(12, "12341", tag("building", "no")) + way(13, "1234", tag("building", "yes")) +
          way(14, "5678", tag("highway", "service")) + way(15, "56785", tag("landuse", "grass")) +
          "<relation id=\"20\"><member type=\"way\" ref=\"10\" role=\"outer\"/>"
          "<member type=\"way\" ref=\"11\" role=\"inner\"/>" +
          tag("type", "multipolygon") + tag("building", "yes") + tag("building:levels", "4") +
          tag("roof:shape", "hipped") + tag("height", "12.5 m") + tag("addr:street", "Höfðatún") +
          tag("odd", "say &quot;a=>b&quot;, \\ok") + "</relation></osm>");
  const FootprintSet set = read_footprints(path, {});
  REQUIRE(set.footprints.size() == 2);
  const bool relation_first = set.footprints[0].id == "20";
  const Footprint& relation = set.footprints[relation_first ? 0 : 1];
  const Footprint& shed = set.footprints[relation_first ? 1 : 0];
  CHECK(relation.id == "20");
  CHECK(shed.id == "11");
  CHECK(relation.polygon.rings() == 2);
  const auto text = [&](const char* name) {
    const Property* p = relation.find(name);
    return p != nullptr ? std::get<std::string>(p->value) : "nothing";
  };
  CHECK(text("building:levels") == "4");
  CHECK(text("roof:shape") == "hipped");
  CHECK(text("height") == "12.5 m");
  CHECK(text("addr:street") == "Höfðatún");
  CHECK(text("odd") == "say \"a=>b\", \\ok");
  CHECK(area(shed.polygon) == doctest::Approx(11.14 * 11.16).epsilon(0.01));

  CHECK(read_footprints(path, {.where = "\"building:levels\" = '4'"}).footprints.size() == 1);
  const FootprintSet grass =
      read_footprints(path, {.layer = "multipolygons", .where = "landuse = 'grass'"});
  REQUIRE(grass.footprints.size() == 1);
  CHECK(grass.footprints[0].id == "15");
}

TEST_CASE("a damaged download is not taken for a small town") {
  const std::string path = data("monaco.osm.pbf");
  if (path.empty()) return;
  const test::Folder folder;
  const std::string whole = test::content(path);
  const std::string half = folder.write("half.osm.pbf", whole.substr(0, whole.size() / 2));
  CHECK_THROWS_AS(read_footprints(half, {}), Failure);
}
