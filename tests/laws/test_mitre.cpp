// Bands around a building whose ends are mitred meet without a gap, an overlap or two faces in one
// plane.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/geometry/random_polygons.hpp"
#include "tests/laws/closed.hpp"
#include "tests/laws/derive.hpp"

namespace mansard::test {
namespace {

constexpr double height = 6, low = 2, high = 2.5;

std::string banded(const std::string& depth) {
  return "style A { Mass { FOOTPRINT -> extrude(6) comp { side : FACADE | top : DECK } } Facade { "
         "FACADE -> subdiv(\"Y\", 2, 0.5, 1r) { WALL | extrude(" +
         depth + ", corners = \"mitre\") { BAND } | WALL } } }";
}

struct Corner {
  Vec2 at, outwards;  ///< outwards: for a band of 1 m
  double turn;        ///< degrees through the building
};

std::vector<Corner> corners(const Polygon& plan) {
  std::vector<Corner> all;
  const std::vector<uint32_t> next = next_points(plan);
  for (uint32_t i = 0; i < next.size(); ++i) {
    const uint32_t j = next[i];
    const Vec2 in = normalized(plan.points[j] - plan.points[i]);
    const Vec2 out = normalized(plan.points[next[j]] - plan.points[j]);
    const Vec2 a = left_of(in) * -1, b = left_of(out) * -1;
    all.push_back({plan.points[j], (a + b) * (1 / (1 + dot(a, b))),
                   180 - std::atan2(cross(in, out), dot(in, out)) * 180 / std::numbers::pi});
  }
  return all;
}

/// The bands can all be made whole: no corner is too sharp, no wall too short.
bool is_fit(const Polygon& plan, double depth) {
  double shortest = 1e9;
  for_each_edge(plan,
                [&](uint32_t, Vec2 a, Vec2 b) { shortest = std::min(shortest, length(b - a)); });
  for (const Corner& corner : corners(plan)) {
    if (corner.turn < 35 || corner.turn > 325 || std::abs(corner.turn - 180) < 0.5) return false;
    if (2 * depth * length(corner.outwards) > shortest) return false;
  }
  return true;
}

/// How many faces of the band have a corner there.
int faces_at(const Surface& surface, Vec3 place) {
  int count = 0;
  for (std::size_t polygon = 0; polygon < surface.polygons(); ++polygon) {
    for (const Vec3 p : surface.loop(polygon)) count += length(p - place) <= 1e-6;
  }
  return count;
}

Footprint on(const Polygon& plan) {
  Footprint footprint;
  footprint.id = "random";
  footprint.polygon = plan;
  return footprint;
}

}  // namespace

TEST_CASE("mitred bands meet at every corner, and the volume adds up") {
  RandomPolygons polygons(41);
  int buildings = 0, niches = 0;
  for (int i = 0; i < 1500 && buildings < 150; ++i) {
    const Polygon plan = polygons.next();
    const double depth = polygons.between(0.02, 0.4);
    if (!is_fit(plan, depth)) continue;
    ++buildings;
    CAPTURE(i);
    const Script script = Script::text(banded(std::to_string(depth)));
    REQUIRE_MESSAGE(script.good(), script.problems());
    const double d = std::stod(std::to_string(depth));
    const Building building = script.derive(on(plan));
    CHECK(open_length(building.surface, [](Vec3 p) { return p.y < 1e-9; }) < 1e-6);
    double band = 0;
    for_each_edge(plan, [&](uint32_t, Vec2 a, Vec2 b) { band += d * length(b - a); });
    for (const Corner& corner : corners(plan)) {
      band += d * d / std::tan(corner.turn * std::numbers::pi / 360);
      niches += corner.turn > 180;
      const Vec2 tip = corner.at + corner.outwards * d;
      for (const double up : {low, high})  // a front and a top or bottom of either band
        CHECK(faces_at(building.surface, {tip.x, up, -tip.y}) == 4);
    }
    CHECK(volume_above(building.surface, 0) ==
          doctest::Approx(area(plan) * height + band * (high - low)).epsilon(1e-6));
  }
  CHECK(buildings >= 50);
  CHECK(niches >= 50);
}

TEST_CASE("a second band on the first one's front is mitred, too") {
  const Script script = Script::text(
      "style A { Mass { FOOTPRINT -> extrude(6) comp { side : FACADE | top : DECK } } Facade { "
      "FACADE -> subdiv(\"Y\", 1r, 0.5) { WALL | extrude(0.3, corners = \"mitre\") { comp { front "
      ": "
      "FRONT | all : BAND } } } FRONT -> extrude(0.2, corners = \"mitre\") { BAND } } }");
  REQUIRE_MESSAGE(script.good(), script.problems());
  const Surface surface = script.derive("L:12x9x5x4").surface;
  CHECK(open_length(surface, [](Vec3 p) { return p.y < 1e-9; }) < 1e-6);
  const Box3 box = bounds(surface.points);
  CHECK(box.size().x == doctest::Approx(13));
  CHECK(box.size().z == doctest::Approx(10));
  // Both together are as deep as one: an edge of 0.5 m all around, square at corners and in a
  // niche.
  const double depth = 0.5, around = 42, corners_more = 5 - 1;
  CHECK(volume_above(surface, 0) ==
        doctest::Approx(area(footprint("L:12x9x5x4").polygon) * 6 +
                        0.5 * (around * depth + corners_more * depth * depth)));
}

TEST_CASE("bands have no ends where a wall turns ever so little") {
  for (const double out : {-1e-4, -1e-6, 1e-6, 1e-4}) {
    CAPTURE(out);
    Polygon plan = footprint("rect:10x8").polygon;
    plan.points.insert(plan.points.begin() + 1, Vec2{5, out});
    plan.tags.insert(plan.tags.begin() + 1, plan.tags[0]);
    plan.ring_ends[0] = 5;
    const Script script = Script::text(banded("0.3"));
    const Building building = script.derive(on(plan));
    const auto counts = by_symbol(script, building).at("BAND").size();
    CHECK(counts == 5 * 3 * 4);  // a front, a top and a bottom of four corners each
  }
}

TEST_CASE("bands end square where a wall was split") {
  const Script script = Script::text(
      "style A { Mass { FOOTPRINT -> extrude(6) comp { front : FACADE | all : WALL } } Facade { "
      "FACADE -> subdiv(\"X\", 1r, 1r) { extrude(0.5, corners = \"mitre\") { BAND } | WALL } } }");
  REQUIRE(script.good());
  const Building building = script.derive("rect:10x8");
  const auto band = by_symbol(script, building).at("BAND");
  const Box3 box = bounds(band);
  CHECK(box.low.x == doctest::Approx(-0.5));
  CHECK(box.high.x == doctest::Approx(5));
  CHECK(building.terminals[script.symbol("BAND")] == 1);
}

TEST_CASE("bands end square beside a neighbour") {
  std::string style = banded("0.5");
  style.insert(style.find("side :"), "party : WALL | ");
  const Script script = Script::text(style);
  REQUIRE_MESSAGE(script.good(), script.problems());
  for (const char* const plan : {"rect:10x8", "L:12x9x5x4"}) {
    CAPTURE(plan);
    Footprint footprint = test::footprint(plan);
    footprint.polygon.tags[1].flags |= EdgeTag::party;
    const Building building = script.derive(footprint);
    const double edge = bounds(footprint.polygon.points).high.x;
    CHECK(bounds(by_symbol(script, building).at("BAND")).high.x == doctest::Approx(edge));
  }
}

/// A mass that is split has walls that go on in the next part: there bands end square and meet.
TEST_CASE("bands run around the parts of a mass as around the whole") {
  for (const std::string plan : {"rect:10x8", "L:12x9x5x4"}) {
    for (const std::string parts : {"3", "6"}) {
      CAPTURE(plan);
      const Script script = Script::text(
          "style A { Mass { FOOTPRINT -> extrude(6) subdiv(\"X\", " + parts +
          ", 1r) { Part | Part } Part -> comp { cut : NIL | side : FACADE | top : DECK } } Facade "
          "{ "
          "FACADE -> subdiv(\"Y\", 1r, 0.5) { WALL | extrude(0.4, corners = \"mitre\") { BAND } } "
          "} }");
      REQUIRE_MESSAGE(script.good(), script.problems());
      const Footprint on = footprint(plan);
      const Building building = script.derive(on);
      double around = 0;
      for_each_edge(on.polygon, [&](uint32_t, Vec2 a, Vec2 b) { around += length(b - a); });
      CHECK(volume_above(building.surface, 0) ==
            doctest::Approx(area(on.polygon) * 6 + 0.5 * (around * 0.4 + 4 * 0.4 * 0.4)));
    }
  }
}

}  // namespace mansard::test
