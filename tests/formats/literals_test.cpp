#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <random>

#include "formats/footprints.hpp"

using namespace mansard;

namespace {

Footprint only(const std::string& what) {
  const FootprintSet set = read_footprints(what, {});
  REQUIRE(set.footprints.size() == 1);
  return set.footprints[0];
}

Diagnostic failure(const std::string& what, const FootprintOptions& options = {}) {
  try {
    read_footprints(what, options);
  } catch (const Failure& f) {
    return f.diagnostic;
  }
  FAIL("no failure for " << what);
  return {};
}

}  // namespace

TEST_CASE("literals draw what their numbers say") {
  struct Case {
    const char* text;
    double area;
    std::size_t corners, rings;
  };
  for (const Case& c :
       {Case{"rect:10x8", 80, 4, 1}, Case{"rect: 10.5 x 8", 84, 4, 1},
        Case{"L:12x9x5x4", 12 * 9 - 5 * 4, 6, 1}, Case{"T:14x10x4x6", 14 * 4 + 4 * 6, 8, 1},
        Case{"U:14x10x6x5", 14 * 10 - 6 * 5, 8, 1},
        Case{"ring:20x16x8x6", 20 * 16 - 8 * 6, 8, 2}}) {
    CAPTURE(c.text);
    const Footprint f = only(c.text);
    CHECK(area(f.polygon) == doctest::Approx(c.area));
    CHECK(f.polygon.points.size() == c.corners);
    CHECK(f.polygon.rings() == c.rings);
    CHECK(area(f.polygon.ring(0)) > 0);
    // The first edge is the front.
    CHECK(f.polygon.points[0] == Vec2{0, 0});
    CHECK(f.polygon.points[1].y == 0);
    for (std::size_t i = 0; i < f.polygon.tags.size(); ++i) CHECK(f.polygon.tags[i].wall == i);
  }
}

TEST_CASE("the L misses its back right corner") {
  const Polygon p = only("L:12x9x5x4").polygon;
  CHECK(contains(p, {6, 8}));
  CHECK(!contains(p, {8, 8}));
  CHECK(contains(p, {8, 4}));
}

TEST_CASE("well-known text") {
  CHECK(area(only("WKT:POLYGON((0 0, 10 0, 10 8, 0 8, 0 0))").polygon) == 80);
  CHECK(area(only("WKT:polygon z ((0 0 5, 10 0 5, 10 8 5, 0 8 5, 0 0 5))").polygon) == 80);
  const Footprint court = only("WKT:POLYGON((0 0,10 0,10 10,0 10,0 0),(2 2,8 2,8 8,2 8,2 2))");
  CHECK(area(court.polygon) == 64);
  CHECK(area(court.polygon.ring(1)) < 0);
  const FootprintSet two =
      read_footprints("WKT:MULTIPOLYGON(((0 0,1 0,1 1,0 1,0 0)),((5 5,7 5,7 7,5 7,5 5)))", {});
  REQUIRE(two.footprints.size() == 2);
  CHECK(two.footprints[0].id == "0");
  CHECK(two.footprints[1].id == "0:2");
  CHECK(area(two.footprints[1].polygon) == 4);
  REQUIRE(two.notes.size() == 1);
  CHECK(two.notes[0].text == "has 2 parts, each a building of its own");
}

TEST_CASE("rings are repaired with a note, and broken only without an area") {
  const auto notes = [](const std::string& ring) {
    return read_footprints("WKT:POLYGON(" + ring + ")", {});
  };
  const FootprintSet open = notes("(0 0, 10 0, 10 8, 0 8)");
  REQUIRE(open.footprints.size() == 1);
  CHECK(open.notes.at(0).text == "open ring closed");
  CHECK(!open.notes.at(0).broken);
  CHECK(area(open.footprints[0].polygon) == 80);

  const FootprintSet repeated = notes("(0 0, 10 0, 10 0, 10 8, 10 8, 0 8, 0 0, 0 0)");
  CHECK(repeated.notes.at(0).text == "repeated points removed");
  CHECK(repeated.footprints.at(0).polygon.points.size() == 4);

  const FootprintSet bow = notes("(0 0, 10 10, 10 0, 0 10, 0 0)");
  CHECK(bow.notes.at(0).text == "self-crossing ring repaired");
  REQUIRE(bow.footprints.size() == 2);
  CHECK(area(bow.footprints[0].polygon) + area(bow.footprints[1].polygon) == doctest::Approx(50));
  CHECK(bow.footprints[1].id == "0:2");

  // A ring that overlaps itself is no court.
  const FootprintSet overlap = notes("(0 0,10 0,10 10,4 10,4 4,12 4,12 6,2 6,2 10,0 10,0 0)");
  REQUIRE(overlap.footprints.size() >= 1);
  CHECK(contains(overlap.footprints[0].polygon, {5, 5}));

  const FootprintSet spike = notes("(0 0, 10 0, 20 0, 10 0, 10 8, 0 8, 0 0)");
  REQUIRE(spike.footprints.size() == 1);
  CHECK(area(spike.footprints[0].polygon) == doctest::Approx(80));
  CHECK(bounds(spike.footprints[0].polygon.points).high.x == 10);

  for (const char* ring : {"(0 0, 10 0, 0 0)", "(0 0, 10 0, 20 0, 0 0)", "(1 1, 1 1, 1 1, 1 1)"}) {
    const FootprintSet broken = notes(ring);
    CHECK(broken.footprints.empty());
    REQUIRE(broken.notes.size() >= 1);
    CHECK(broken.notes.back().broken);
  }
  const FootprintSet nan = notes("(0 0, nan 0, 10 10, 0 0)");
  CHECK(nan.notes.at(0).text == "has a coordinate that is not a number");
  CHECK(nan.notes.at(0).broken);
}

TEST_CASE("clockwise outlines are turned and keep their first edge first") {
  const Polygon p = only("WKT:POLYGON((0 0, 0 8, 10 8, 10 0, 0 0))").polygon;
  CHECK(area(p) == 80);
  CHECK(p.points[0] == Vec2{0, 8});
  CHECK(p.points[1] == Vec2{0, 0});
}

TEST_CASE("slips in literals are quoted and the right form is shown") {
  const auto has = [](const std::string& text, const char* part) {
    CAPTURE(text);
    CHECK(text.find(part) != text.npos);
  };
  const Diagnostic letters = failure("rect:10xa");
  CHECK(letters.text == "'rect:10xa' has 'a' where a number is expected");
  CHECK(letters.help == "write rect:10x8: width and depth, in metres");
  CHECK(failure("rect:10").text == "'rect:10' has 1 of 2 numbers");
  CHECK(failure("rect:").text == "'rect:' ends where a number is expected");
  CHECK(failure("rect:10*8").text == "'rect:10*8' has '*8' where 'x' is expected");
  CHECK(failure("rect:-1x8").text == "'rect:-1x8' has a length that is not positive");
  CHECK(failure("rect:infx8").text == "'rect:infx8' has 'infx8' where a number is expected");
  CHECK(failure("rect:nanx8").text == "'rect:nanx8' has 'nanx8' where a number is expected");
  CHECK(failure("rect:1e9x8").text == "'rect:1e9x8' is longer than 100 km");
  has(failure("L:12x9x12x4").text, "not smaller than the whole");
  has(failure("L:12x9").help, "L:12x9x5x4");
  has(failure("WKT:POLYGON((0 0, 1 0").text, "needs ')' at its end");
  has(failure("WKT:POINT(0 0)").text, "is 'POINT'");
  has(failure("WKT:POLYGON((0 0, x 1))").text, "needs a number at 'x 1))'");
  has(failure("WKT:POLYGON EMPTY").text, "is empty");
  has(failure("WKT:POLYGON((0 0,1 0,1 1,0 0)) x").text, "goes on after its end: 'x'");
  has(failure("WKT:").text, "not a POLYGON");
  const Diagnostic missing = failure("reckt:10x8");
  CHECK(missing.text == "no such file: 'reckt:10x8'");
  has(missing.help, "rect:10x8");
}

TEST_CASE("attributes, selection and limit") {
  FootprintOptions options;
  options.attributes = {{"height", 12.0}, {"name", std::string("x")}};
  const FootprintSet set = read_footprints("rect:10x8", options);
  REQUIRE(set.footprints[0].find("height") != nullptr);
  CHECK(std::get<double>(set.footprints[0].find("height")->value) == 12);

  const std::string two = "WKT:MULTIPOLYGON(((0 0,1 0,1 1,0 1,0 0)),((5 5,7 5,7 7,5 7,5 5)))";
  CHECK(read_footprints(two, {.select = {"0"}}).footprints.size() == 2);
  CHECK(read_footprints(two, {.select = {"0:2"}}).footprints.size() == 1);
  CHECK(read_footprints(two, {.limit = 1}).footprints.size() == 1);
  CHECK(failure(two, {.select = {"7"}}).text == "there is no footprint '7'");
  const FootprintSet broken = read_footprints("WKT:POLYGON((0 0,1 1,2 2,0 0))", {.limit = 1});
  CHECK(broken.footprints.empty());
  CHECK(broken.notes.size() == 1);
}

TEST_CASE("scribbles and very long rings do not keep anybody waiting") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 100);
  std::string scribble = "WKT:POLYGON((0 0", comb = "WKT:POLYGON((0 -1";
  for (int i = 0; i < 5000; ++i) {
    scribble += ", " + std::to_string(any(random)) + " " + std::to_string(any(random));
    comb += ", " + std::to_string(i) + " 0, " + std::to_string(i) + ".5 100";
  }
  const auto begin = std::chrono::steady_clock::now();
  const FootprintSet broken = read_footprints(scribble + ", 0 0))", {});
  CHECK(broken.footprints.empty());
  CHECK(broken.notes.at(0).broken);
  CHECK(broken.notes.at(0).text == "crosses itself more than 1,000 times");
  const FootprintSet long_one = read_footprints(comb + ", 5000 -1, 0 -1))", {});
  CHECK(long_one.footprints.size() == 1);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(2));
}
