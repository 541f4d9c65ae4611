#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>

#include "formats/footprints.hpp"
#include "support.hpp"

using namespace mansard;
using mansard::test::Folder;

namespace {

Diagnostic failure(const std::string& what, const FootprintOptions& options = {}) {
  try {
    read_footprints(what, options);
  } catch (const Failure& f) {
    return f.diagnostic;
  }
  FAIL("no failure for " << what);
  return {};
}

std::string feature(const std::string& geometry, const std::string& properties = "",
                    const std::string& id = "") {
  return R"({"type":"Feature",)" + (id.empty() ? "" : "\"id\":" + id + ",") + R"("properties":{)" +
         properties + R"(},"geometry":)" + geometry + "}";
}

std::string polygon(const std::string& rings) {
  return R"({"type":"Polygon","coordinates":[)" + rings + "]}";
}

/// A square of `size` metres at (x, y).
std::string square(double x, double y, double size) {
  const auto p = [](double u, double v) {
    return "[" + std::to_string(u) + "," + std::to_string(v) + "]";
  };
  return "[" + p(x, y) + "," + p(x + size, y) + "," + p(x + size, y + size) + "," + p(x, y + size) +
         "," + p(x, y) + "]";
}

std::string collection(const std::string& features, const std::string& crs = "EPSG:3067") {
  const std::string member =
      crs.empty() ? "" : R"("crs":{"type":"name","properties":{"name":")" + crs + "\"}},";
  return R"({"type":"FeatureCollection",)" + member + R"("features":[)" + features + "]}";
}

bool has_note(const FootprintSet& set, const std::string& id, const std::string& text) {
  for (const FootprintNote& n : set.notes) {
    if (n.id == id && n.text == text) return true;
  }
  return false;
}

double worst_distance(const FootprintSet& a, const FootprintSet& b) {
  REQUIRE(a.footprints.size() == b.footprints.size());
  double worst = 0;
  for (std::size_t i = 0; i < a.footprints.size(); ++i) {
    const Polygon &p = a.footprints[i].polygon, &q = b.footprints[i].polygon;
    REQUIRE(p.points.size() == q.points.size());
    for (std::size_t k = 0; k < p.points.size(); ++k) {
      worst = std::max(worst, length(p.points[k] - q.points[k]));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("GeoJSON: properties, holes, several parts, heights") {
  const Folder folder;
  const std::string path = folder.write(
      "town.geojson",
      collection(
          feature(polygon(square(385000, 6671000, 10)),
                  R"("name":"Town hall","height":12.5,"levels":4,"listed":true,"none":null)", "7") +
          "," +
          feature(polygon(square(385100, 6671000, 20) + "," + square(385105, 6671005, 8)), "",
                  "8") +
          "," +
          feature(R"({"type":"MultiPolygon","coordinates":[[)" + square(385200, 6671000, 5) +
                      "],[" + square(385200, 6671050, 6) + "]]}",
                  "", "9") +
          "," +
          feature(R"({"type":"Polygon","coordinates":[[[385300,6671000,3],[385310,6671000,3],)"
                  R"([385310,6671010,3],[385300,6671000,3]]]})",
                  "", "10") +
          "," + feature(R"({"type":"Point","coordinates":[385300,6671000]})", "", "11") + "," +
          feature("null", "", "12")));
  const FootprintSet set = read_footprints(path, {});
  REQUIRE(set.footprints.size() == 5);
  const Footprint& hall = set.footprints[0];
  CHECK(hall.id == "7");
  CHECK(std::get<std::string>(hall.find("name")->value) == "Town hall");
  CHECK(std::get<double>(hall.find("height")->value) == 12.5);
  CHECK(std::get<double>(hall.find("levels")->value) == 4);
  CHECK(std::get<bool>(hall.find("listed")->value) == true);
  CHECK(hall.find("none") == nullptr);
  CHECK(area(hall.polygon) == doctest::Approx(100));
  CHECK(area(set.footprints[1].polygon) == doctest::Approx(400 - 64));
  CHECK(area(set.footprints[1].polygon.ring(1)) < 0);
  CHECK(set.footprints[2].id == "9");
  CHECK(set.footprints[3].id == "9:2");
  CHECK(has_note(set, "9", "has 2 parts, each a building of its own"));
  CHECK(has_note(set, "", "heights (Z) of the points are ignored"));
  CHECK(has_note(set, "", "1 points and lines are left out"));
  CHECK(has_note(set, "12", "is empty"));
  // Projected metres stay metres, less whole ones.
  CHECK(set.shift == Vec2{385200, 6671000});
  CHECK(hall.polygon.points[0] == Vec2{-200, 0});
  CHECK(set.origin == "EPSG:3067 less (385200, 6671000)");
}

TEST_CASE("rings in files are repaired") {
  const Folder folder;
  const FootprintSet set = read_footprints(
      folder.write("a.geojson",
                   collection(feature(polygon("[[0,0],[10,10],[10,0],[0,10],[0,0]]")) + "," +
                              feature(polygon("[[50,0],[60,0],[60,0],[60,10],[50,10],[50,0]]")) +
                              "," + feature(polygon("[[90,0],[99,0],[99,9],[90,9]]")) + "," +
                              feature(polygon("[[0,50],[0,60],[10,60],[10,50],[0,50]]")) + "," +
                              feature(polygon("[[0,90],[10,90],[0,90]]")))),
      {});
  CHECK(has_note(set, "0", "self-crossing ring repaired"));
  CHECK(has_note(set, "1", "repeated points removed"));
  CHECK(has_note(set, "2", "open ring closed"));
  REQUIRE(set.footprints.size() == 5);
  CHECK(set.footprints[1].id == "0:2");
  CHECK(area(set.footprints[3].polygon) == doctest::Approx(81));
  // Turned, its first edge first.
  const Polygon& turned = set.footprints[4].polygon;
  CHECK(area(turned) == doctest::Approx(100));
  CHECK(turned.points[0] == turned.points[1] + Vec2{0, 10});
  bool broken = false;
  for (const FootprintNote& n : set.notes) broken = broken || (n.id == "4" && n.broken);
  CHECK(broken);
}

TEST_CASE("coordinate systems end in the same true metres") {
  const Folder folder;
  // Ground truth: transverse Mercator about the place itself.
  std::string features;
  for (int i = 0; i < 9; ++i) {
    features += (i ? "," : "") + feature(polygon(square(200.0 * (i % 3), 150.0 * (i / 3), 12 + i)));
  }
  const std::string truth = folder.write("truth.geojson", collection(features, ""));
  const auto converted = [&](const std::string& to, const std::string& name) {
    const std::string command =
        "ogr2ogr -a_srs '' -s_srs '+proj=tmerc +lat_0=60.17 +lon_0=24.94 "
        "+ellps=WGS84 +k=1' -t_srs '" +
        to + "' -overwrite '" + (folder / name) + "' '" + truth + "' 2>/dev/null";
    return std::system(command.c_str()) == 0;
  };
  if (!converted("EPSG:4326", "wgs84.geojson")) {
    MESSAGE("skipped: ogr2ogr is not here");
    return;
  }
  const FootprintSet wgs84 = read_footprints(folder / "wgs84.geojson", {});
  REQUIRE(wgs84.footprints.size() == 9);
  for (int i = 0; i < 9; ++i) {
    CHECK(area(wgs84.footprints[i].polygon) ==
          doctest::Approx((12.0 + i) * (12 + i)).epsilon(1e-5));
  }
  CHECK(wgs84.origin.find("local metres about lon 24.94") == 0);
  // Web Mercator's metres are half as long here, and are not believed.
  REQUIRE(converted("EPSG:3857", "mercator.gpkg"));
  CHECK(worst_distance(wgs84, read_footprints(folder / "mercator.gpkg", {})) < 2e-3);
  // US survey feet become metres; UTM's are believed to within its scale.
  REQUIRE(converted("+proj=tmerc +lat_0=60 +lon_0=24.9 +ellps=WGS84 +units=us-ft", "feet.shp"));
  const FootprintSet feet = read_footprints(folder / "feet.shp", {});
  REQUIRE(feet.footprints.size() == 9);
  CHECK(area(feet.footprints[8].polygon) == doctest::Approx(400).epsilon(1e-4));
  REQUIRE(converted("EPSG:32635", "utm.fgb"));
  const FootprintSet utm = read_footprints(folder / "utm.fgb", {});
  REQUIRE(utm.footprints.size() == 9);
  double sum = 0, expected = 0;
  for (int i = 0; i < 9; ++i) {
    sum += area(utm.footprints[i].polygon);
    expected += (12 + i) * (12 + i);
  }
  CHECK(sum == doctest::Approx(expected).epsilon(2e-3));
}

TEST_CASE("files without a coordinate system") {
  const Folder folder;
  // GeoJSON is WGS 84 by its standard, but these are no degrees.
  const FootprintSet metres = read_footprints(
      folder.write("m.geojson", collection(feature(polygon(square(400, 500, 10))), "")), {});
  CHECK(metres.footprints.at(0).polygon.points[0] == Vec2{400, 500});
  CHECK(has_note(metres, "", "the coordinates are no longitudes and latitudes: read as metres"));
  const FootprintSet csv = read_footprints(
      folder.write(
          "w.csv",
          "id,WKT\na,\"POLYGON((24.94 60.17,24.9402 60.17,24.9402 60.1701,24.94 60.17))\"\n"),
      {});
  CHECK(csv.footprints.at(0).id == "a");
  CHECK(area(csv.footprints[0].polygon) == doctest::Approx(62).epsilon(0.02));
  CHECK(
      has_note(csv, "", "no coordinate system is given: read as longitude and latitude (WGS 84)"));
}

TEST_CASE("who a footprint is") {
  const Folder folder;
  const auto ids = [&](const std::string& features, const FootprintOptions& options = {}) {
    std::string all;
    for (const Footprint& f :
         read_footprints(folder.write("i.geojson", collection(features)), options).footprints) {
      all += f.id + " ";
    }
    return all;
  };
  const std::string a = polygon(square(0, 0, 5)), b = polygon(square(50, 0, 5));
  CHECK(ids(feature(a) + "," + feature(b)) == "0 1 ");
  CHECK(ids(feature(a, R"("id":30)") + "," + feature(b, R"("id":40)")) == "30 40 ");
  CHECK(ids(feature(a, R"("id":30)", "70") + "," + feature(b, R"("id":40)", "80")) == "70 80 ");
  CHECK(ids(feature(a, R"("osm_id":"5")", "70") + "," + feature(b, R"("osm_id":"6")", "80")) ==
        "5 6 ");
  CHECK(ids(feature(a, "", R"("way/1")") + "," + feature(b, "", R"("way/2")")) == "way/1 way/2 ");
  CHECK(ids(feature(a, R"("plot":"x")") + "," + feature(b, R"("plot":"y")"), {.id = "plot"}) ==
        "x y ");
  CHECK(ids(feature(a, R"("plot":"x")") + "," + feature(b, R"("plot":"x")"), {.id = "plot"}) ==
        "x x:2 ");
  // The place is that in the unfiltered file.
  CHECK(ids(feature(a, R"("n":1)") + "," + feature(b, R"("n":2)"), {.where = "n = 2"}) == "1 ");
  const Diagnostic unknown =
      failure(folder.write("u.geojson", collection(feature(a, R"("plot":1)"))), {.id = "plott"});
  CHECK(unknown.text == "no footprint has a property 'plott'");
  CHECK(unknown.help == "did you mean 'plot'?");
}

TEST_CASE("GIS files that can not be used say why") {
  const Folder folder;
  const std::string good =
      folder.write("good.geojson", collection(feature(polygon(square(0, 0, 5)), R"("height":3)")));
  CHECK(failure(folder / "none.geojson").text ==
        "no such file: '" + (folder / "none.geojson") + "'");
  CHECK(failure(folder.string()).text ==
        "'" + folder.string() + "' is a folder, not a file of footprints");
  const std::string text = folder.write("a.txt", "hello");
  CHECK(failure(text).text == "can not read footprints from '" + text + "'");
  CHECK(failure(folder.write("cut.geojson", R"({"type":"FeatureCollection","features":[{"type")"))
            .text == "can not read footprints from '" + (folder / "cut.geojson") + "'");
  CHECK(failure(folder.write("none.geojson", collection(""))).text ==
        "'" + (folder / "none.geojson") + "' has no footprints");
  const std::string points =
      folder.write("p.geojson", collection(feature(R"({"type":"Point","coordinates":[1,2]})")));
  CHECK(failure(points).text == "'" + points + "' has no areas, only points and lines");
  CHECK(failure(good, {.where = "height = 9"}).text ==
        "no footprint of '" + good + "' fulfils 'height = 9'");
  const Diagnostic where = failure(good, {.where = "hieght > 2"});
  CHECK(where.text == "'hieght > 2' is not a condition of OGR SQL");
  REQUIRE(where.notes.size() == 1);
  CHECK(where.notes[0].text.find("hieght") != std::string::npos);
  CHECK(failure(good, {.where = "((("}).text == "'(((' is not a condition of OGR SQL");
  const Diagnostic layer = failure(good, {.layer = "godo"});
  CHECK(layer.text == "'" + good + "' has no layer 'godo'");
  CHECK(layer.help == "did you mean 'good'? its layers are good");
  CHECK(failure(good, {.select = {"4"}}).text == "there is no footprint '4'");
}

TEST_CASE("faces of an OBJ are footprints") {
  const Folder folder;
  const FootprintSet set =
      read_footprints(folder.write("plots.obj",
                                   "v 0 1 0\nv 10 1 0\nv 10 1 -8\nv 0 1 -8\nv 20 1 0\nv 20 1 -4\n"
                                   "f 1 2 3 4\no shop\nf 2 5 6 3\nf 5 6 3 2\no line\nf 1 2 1\n"),
                      {});
  REQUIRE(set.footprints.size() == 3);
  CHECK(set.footprints[0].id == "0");
  CHECK(set.footprints[1].id == "shop");
  CHECK(set.footprints[2].id == "shop:2");
  CHECK(area(set.footprints[0].polygon) == doctest::Approx(80));
  CHECK(set.footprints[0].polygon.points[2] == Vec2{10, 8});
  CHECK(has_note(set, "", "heights (y) of the points are ignored"));
  CHECK(set.notes.back().broken);
  CHECK(failure(folder.write("bad.obj", "v 0 0 0\nf 1 2 3\n")).text ==
        "can not read footprints from '" + (folder / "bad.obj") +
            "': line 2: face of unknown vertex");
}

TEST_CASE("the middle of a set is not moved by strays, nor by the date line") {
  const Folder folder;
  std::string near, across;
  for (int i = 0; i < 5; ++i) {
    near += feature(polygon(square(24.94 + i * 1e-3, 60.17, 1e-4))) + ",";
    across += (i ? "," : "") + feature(polygon(square(i < 3 ? 179.9985 : -179.999, -17, 1e-4)));
  }
  const FootprintSet set = read_footprints(
      folder.write("stray.geojson", collection(near + feature(polygon(square(0, 0, 1e-4))), "")),
      {});
  CHECK(length(set.footprints.at(0).polygon.points[0]) < 1000);
  const FootprintSet fiji =
      read_footprints(folder.write("fiji.geojson", collection(across, "")), {});
  for (const Footprint& f : fiji.footprints) CHECK(length(f.polygon.points[0]) < 1000);
}

TEST_CASE("all layers of areas are read, or the one that is named") {
  const Folder folder;
  const std::string part =
      folder.write("part.geojson", collection(feature(polygon(square(385000, 6671000, 10)))));
  const std::string file = folder / "town.gpkg";
  for (const char* how : {"-nln houses", "-update -nln sheds"}) {
    const std::string command =
        "ogr2ogr -f GPKG " + std::string(how) + " '" + file + "' '" + part + "' 2>/dev/null";
    if (std::system(command.c_str()) != 0) {
      MESSAGE("skipped: ogr2ogr is not here");
      return;
    }
  }
  const FootprintSet both = read_footprints(file, {});
  REQUIRE(both.footprints.size() == 2);
  CHECK(both.footprints[0].id == "houses/1");
  CHECK(both.footprints[1].id == "sheds/1");
  const FootprintSet one = read_footprints(file, {.layer = "sheds"});
  REQUIRE(one.footprints.size() == 1);
  CHECK(one.footprints[0].id == "1");
  const Diagnostic unknown = failure(file, {.layer = "shed"});
  CHECK(unknown.help == "did you mean 'sheds'? its layers are houses, sheds");
}
