#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

#include "formats/streets.hpp"
#include "support.hpp"

using namespace mansard;
using mansard::test::Folder;

namespace {

Diagnostic failure(const std::string& what, const FootprintSet& beside = {},
                   const StreetOptions& options = {}) {
  try {
    read_streets(what, options, beside);
  } catch (const Failure& f) {
    return f.diagnostic;
  }
  FAIL("no failure for " << what);
  return {};
}

std::string feature(const std::string& type, const std::string& coordinates,
                    const std::string& name = "") {
  return R"({"type":"Feature","properties":{"name":")" + name + R"("},"geometry":{"type":")" +
         type + R"(","coordinates":)" + coordinates + "}}";
}

std::string collection(const std::string& features, const std::string& crs) {
  const std::string member =
      crs.empty() ? "" : R"("crs":{"type":"name","properties":{"name":")" + crs + "\"}},";
  return R"({"type":"FeatureCollection",)" + member + R"("features":[)" + features + "]}";
}

/// 10 m square at the easting and northing (EPSG:3067).
std::string house(double x, double y) {
  const auto p = [&](double u, double v) {
    return "[" + std::to_string(x + u) + "," + std::to_string(y + v) + "]";
  };
  return feature("Polygon", "[[" + p(0, 0) + "," + p(10, 0) + "," + p(10, 10) + "," + p(0, 10) +
                                "," + p(0, 0) + "]]");
}

}  // namespace

TEST_CASE("streets as literals") {
  const StreetSet one = read_streets("WKT:LINESTRING(-5 -4, 15 -4, 15 -4, 15 20)", {}, {});
  REQUIRE(one.lines.size() == 1);
  CHECK(one.lines[0] == StreetLine{{-5, -4}, {15, -4}, {15, 20}});
  CHECK(
      read_streets("WKT:MULTILINESTRING Z ((0 0 1, 1 0 1), (2 2 0, 3 3 0))", {}, {}).lines.size() ==
      2);
  CHECK(failure("WKT:LINESTRING(1 1, 1 1)").text ==
        "'WKT:LINESTRING(1 1, 1 1)' has no street of any length");
  CHECK(failure("WKT:POLYGON((0 0, 1 0, 1 1))").text ==
        "'WKT:POLYGON((0 0, 1 0, 1 1))' is 'POLYGON', not a LINESTRING or MULTILINESTRING");
  CHECK(failure("WKT:LINESTRING(0 0, 1)").text == "'WKT:LINESTRING(0 0, 1)' needs a number at ')'");
  CHECK(failure("none.geojson").text == "no such file: 'none.geojson'");
  CHECK(failure(".").text == "'.' is a folder, not a file of streets");
}

TEST_CASE("streets lie in the metres of the footprints") {
  const Folder folder;
  const FootprintSet houses = read_footprints(
      folder.write("houses.geojson", collection(house(385000, 6671000), "EPSG:3067")), {});
  // In the same coordinates, and in degrees: the same places.
  const std::string line = feature("LineString", "[[385000,6670990],[385020,6670990]]");
  const StreetSet same =
      read_streets(folder.write("same.geojson", collection(line, "EPSG:3067")), {}, houses);
  REQUIRE(same.lines.size() == 1);
  CHECK(same.lines[0][0] == Vec2{385000 - houses.shift.x, 6670990 - houses.shift.y});
  CHECK(same.lines[0][0].y == houses.footprints[0].polygon.points[0].y - 10);
  // Without a coordinate system, numbers that are no degrees: those of the footprints' file.
  const StreetSet bare =
      read_streets(folder.write("bare.geojson", collection(line, "")), {}, houses);
  CHECK(length(bare.lines[0][0] - same.lines[0][0]) < 1e-6);

  // Degrees; footprints about their middle.
  const std::string degrees = R"([[24.93,60.17],[24.94,60.17]])";
  const StreetSet far = read_streets(
      folder.write("degrees.geojson", collection(feature("LineString", degrees), "")), {}, houses);
  CHECK(length(far.lines[0][0]) > 100);
  CHECK(length(far.lines[0][0]) < 5000);
  const FootprintSet round = read_footprints(
      folder.write("round.geojson",
                   collection(feature("Polygon",
                                      "[[[24.93,60.17],[24.9301,60.17],[24.9301,60.1701],"
                                      "[24.93,60.1701],[24.93,60.17]]]"),
                              "")),
      {});
  const StreetSet beside = read_streets(folder / "degrees.geojson", {}, round);
  CHECK(length(beside.lines[0][0] - round.footprints[0].polygon.points[0]) < 1e-6);
}

TEST_CASE("a file without lines, or in coordinates that nobody can bring together") {
  const Folder folder;
  const std::string houses =
      folder.write("houses.geojson", collection(house(385000, 6671000), "EPSG:3067"));
  const FootprintSet set = read_footprints(houses, {});
  CHECK(failure(houses, set).text == "'" + houses + "' has no lines, only points and areas");
  const std::string noise = folder.write("noise.geojson", "what is this?");
  CHECK(failure(noise, set).text == "can not read streets from '" + noise + "'");
  const std::string line = feature("LineString", "[[385000,6670990],[385020,6670990]]", "Main");
  const std::string streets = folder.write("s.geojson", collection(line, "EPSG:3067"));
  const FootprintSet literal = read_footprints("rect:10x8", {});
  CHECK(failure(folder.write("none.geojson", collection("", "EPSG:3067")), set)
            .text.find("has no streets") != std::string::npos);
  CHECK(failure(streets, set, {"", "name = 'Side'"}).text ==
        "no street of '" + streets + "' fulfils 'name = 'Side''");
  CHECK(failure(streets, set, {"roads", ""}).text == "'" + streets + "' has no layer 'roads'");
  CHECK(read_streets(streets, {"", "name = 'Main'"}, set).lines.size() == 1);
  (void)literal;
}

TEST_CASE("OpenStreetMap's roads") {
  const std::string path = "../shared/data/monaco.osm.pbf";
  if (!std::filesystem::exists(path)) {
    MESSAGE("skipped: " << path << " is not here");
    return;
  }
  const FootprintSet houses = read_footprints(path, {});
  const StreetSet roads = read_streets(path, {}, houses);
  const StreetSet all = read_streets(path, {"", "highway IS NOT NULL"}, houses);
  CHECK(roads.lines.size() > 300);
  CHECK(all.lines.size() > 2 * roads.lines.size());  // steps, footways, tunnels
  // Most houses stand at one.
  const Streets streets(roads.lines);
  std::size_t near = 0;
  for (const Footprint& f : houses.footprints)
    near += streets.nearest(f.polygon.points[0], f.polygon.points[0], 60).has_value();
  CHECK(near > houses.footprints.size() * 3 / 4);
}
