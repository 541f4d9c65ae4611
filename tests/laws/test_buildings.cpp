// What holds for whole buildings: tiled facades, closed masses, the same bytes again.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>

#include "tests/laws/closed.hpp"
#include "tests/laws/derive.hpp"

namespace {

using namespace mansard;
using namespace mansard::test;

struct Rectangle {
  Vec2 low, high;
};

/// The polygons that look along the normal, seen in the facade's plane.
std::vector<Rectangle> seen_along(const Surface& surface, Vec3 normal) {
  const Vec3 across = cross({0, 1, 0}, normal);
  std::vector<Rectangle> seen;
  for (std::size_t polygon = 0; polygon < surface.polygons(); ++polygon) {
    if (dot(surface.normals[polygon], normal) < 0.999) continue;
    Rectangle r{{1e9, 1e9}, {-1e9, -1e9}};
    for (const Vec3 p : surface.loop(polygon)) {
      const Vec2 q{dot(p, across), p.y};
      r.low = {std::min(r.low.x, q.x), std::min(r.low.y, q.y)};
      r.high = {std::max(r.high.x, q.x), std::max(r.high.y, q.y)};
    }
    seen.push_back(r);
  }
  return seen;
}

bool same(const Surface& a, const Surface& b) {
  return a.points == b.points && a.uvs == b.uvs && a.ends == b.ends && a.normals == b.normals;
}

/// The points of the polygons whose normal looks that way, in order.
std::vector<Vec3> points_along(const Surface& surface, Vec3 normal) {
  std::vector<Vec3> points;
  for (std::size_t polygon = 0; polygon < surface.polygons(); ++polygon) {
    if (dot(surface.normals[polygon], normal) < 0.999) continue;
    const auto loop = surface.loop(polygon);
    points.insert(points.end(), loop.begin(), loop.end());
  }
  return points;
}

const auto at_ground = [](Vec3 p) { return std::abs(p.y) < 1e-6; };

}  // namespace

TEST_CASE("a box facade's terminals tile it") {
  const Script script = Script::file("bench/facade_box.style");
  const Building building = script.derive("rect:10x8");
  for (const Vec3 normal : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{-1, 0, 0}}) {
    const double width = normal.z != 0 ? 10 : 8;
    // Reveals look along the other facades' normals: they are left out.
    std::vector<Rectangle> all;
    for (const Rectangle& r : seen_along(building.surface, normal)) {
      if (r.high.x - r.low.x > 0.1 + 1e-9 || r.high.y - r.low.y > 1.5 + 1e-9) all.push_back(r);
    }
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      sum += (all[i].high.x - all[i].low.x) * (all[i].high.y - all[i].low.y);
      for (std::size_t j = 0; j < i; ++j) {
        const double x =
            std::min(all[i].high.x, all[j].high.x) - std::max(all[i].low.x, all[j].low.x);
        const double y =
            std::min(all[i].high.y, all[j].high.y) - std::max(all[i].low.y, all[j].low.y);
        CHECK_FALSE((x > 1e-9 && y > 1e-9));
      }
    }
    CHECK(sum == doctest::Approx(width * 12).epsilon(1e-12));
  }
}

TEST_CASE("the check of closed masses sees what is missing") {
  const auto open = [](const char* parts) {
    const Script script = Script::text(
        std::string("style A { Plot { FOOTPRINT -> extrude(6) comp { ") + parts + " } } }");
    return open_length(script.derive("rect:10x8").surface, at_ground);
  };
  CHECK(open("side : WALL | top : TOP") == 0);
  CHECK(open("side : WALL") == doctest::Approx(36));
  CHECK(open("front : subdiv(\"X\", 3, 1r) { NIL | WALL } | side : WALL | top : TOP") ==
        doctest::Approx(3 + 6 + 6));
  CHECK(open("front : detrude(0.2) { IN } | side : WALL | top : TOP") ==
        doctest::Approx(2 * 32 - 20));
}

TEST_CASE("the facade box is closed and looks outwards") {
  const Script script = Script::file("bench/facade_box.style");
  const Building building = script.derive("rect:10x8");
  CHECK(open_length(building.surface, at_ground) < 1e-6);
  const double recesses = 0.1 * area_of(building, script.symbol("WINDOW"));
  CHECK(volume_above(building.surface, 0) == doctest::Approx(960 - recesses).epsilon(1e-12));
}

TEST_CASE("the listings' buildings are closed but for the roof that they drop") {
  for (const char* const style : {"Building1", "Building2"}) {
    CAPTURE(style);
    const Script script = Script::file("styles/library/listings.style", {{}, style});
    Footprint on = footprint("rect:10x8");
    on.properties.push_back({"height", 5.0});
    for (uint64_t seed = 0; seed < 5; ++seed) {
      const Building building = script.derive(on, {.seed = seed});
      CHECK(open_length(building.surface, [](Vec3 p) {
              return std::abs(p.y) < 1e-6 || std::abs(p.y - 5) < 1e-6;
            }) < 1e-6);
      // The top that is missing lies 5 m above the ground.
      CHECK(volume_above(building.surface, 0) + 5 * 80 / 3.0 > 0.95 * 400);
    }
  }
}

TEST_CASE("masses over any plan are closed") {
  const char* const literals[] = {"rect:12x9",      "L:12x9x5x4",
                                  "T:14x10x4x6",    "U:14x10x6x5",
                                  "ring:20x16x8x6", "WKT:POLYGON((0 0,9 1,11 7,4 9,-2 5))"};
  const char* const successors[] = {
      "extrude(6) MASS",
      "extrude(6) comp { all : FACE }",
      // Off the ground the base must close it too.
      "t(0, 2, 0) extrude(6) comp { all : FACE }",
      "t(0, 2, 0) extrude(6) MASS",
      "t(0, 2, 0) extrude(6) subdiv(\"Z\", 2.9, 1r) { comp { all : FACE } | MASS }",
      "extrude(6) mirror(\"x\") comp { all : FACE }",
      "extrude(6) comp { side : repeat(\"X\", 2) { detrude(0.2) { IN | REVEAL } } | top : FACE }",
      "extrude(6) comp { side : repeat(\"X\", 2) { extrude(0.2) { OUT } } | top : FACE }",
      "extrude(6) comp { side : cut(\"arch\") { detrude(0.2) { IN | REVEAL } | WALL } | top : FACE "
      "}",
      "extrude(6) comp { side : WALL | top : roof(\"hip\", 35) { slope : SLATE } }",
      "extrude(6) comp { side : WALL | top : roof(\"hip\", 35, overhang = 0.4) { slope : SLATE | "
      "soffit : BOARD | fascia : BOARD } }",
      "extrude(6) comp { side : WALL | top : roof(\"flat\", parapet = 0.5) { top : DECK | parapet "
      ": COPING } }",
      "extrude(6) comp { side : WALL | top : taper(4) { SPIRE } }",
      "extrude(6) subdiv(\"X\", 3.1, 1r) { comp { all : FACE } | comp { all : FACE } }",
      "offset(1) { extrude(3) { A } | extrude(2) { B } }",
      "setback(1.5, \"front\") { extrude(3) { A } | extrude(2) { B } }",
      "chamfer(0.7) extrude(4) A",
      "s(4, 6, 3) cylinder(16) A",
      "s(4, 6, 3) cone(16) A",
      "s(4, 6, 3) sphere(16) A",
  };
  for (const char* const successor : successors) {
    const Script script =
        Script::text(std::string("style A { Plot { FOOTPRINT -> ") + successor + " } }");
    CAPTURE(successor);
    for (const char* const literal : literals) {
      CAPTURE(literal);
      const Building building = script.derive(literal);
      CHECK(open_length(building.surface, at_ground) < 1e-6);
      CHECK(volume_above(building.surface, 0) > 1);
    }
  }
}

TEST_CASE("the houses of the quarter are closed and look outwards") {
  const Script script = Script::file("examples/quarter/quarter.style");
  FootprintSet set =
      read_footprints(std::string(MANSARD_ROOT) + "/examples/quarter/footprints.geojson", {});
  mark_neighbours(set.footprints);
  Derivation derivation(script.program(), script.meshes(), {});
  Building building;
  for (const Footprint& on : set.footprints) {
    CAPTURE(on.id);
    derivation.derive(on, building);
    CHECK(open_length(building.surface, at_ground) < 1e-5);
    CHECK(volume_above(building.surface, 0) > 1);
  }
}

TEST_CASE("the same seed gives the same building, another another") {
  const Script script = Script::file("styles/library/listings.style");
  const Building a = script.derive("rect:10x8", {.seed = 4}),
                 b = script.derive("rect:10x8", {.seed = 4});
  CHECK(same(a.surface, b.surface));
  CHECK_FALSE(same(a.surface, script.derive("rect:10x8", {.seed = 5}).surface));
}

TEST_CASE("an edit of one branch leaves the others as they were") {
  const std::string before = R"(style A {
    Plot {
        FOOTPRINT -> extrude(9) comp { front : Front | left : SIDE | side : SIDE | top : SIDE }
        Front -> repeat("X", 2) { TILE }
        SIDE -> repeat("X", 2) { repeat("Y", 3) { Panel } }
        Panel -> subdiv("X", rand(0.2, 1), 1r) { A | B } : 1
        Panel -> subdiv("Y", rand(0.2, 1), 1r) { A | B } : 1
        TILE -> subdiv("Y", rand(1, 2), 1r) { Panel | Panel })";
  const Building a = Script::text(before + " } }").derive("rect:10x8");
  // A sill is drawn from too, and a part is added beside the others.
  const Building b = Script::text(before + R"( [ t(0, rand(0, 1), 0.1) SILL ] } }
style B : A { Plot { TILE -> subdiv("Y", rand(1, 2), rand(0.1, 0.2), 1r) { Panel | SILL | Panel } } })")
                         .derive("rect:10x8");
  CHECK(points_along(a.surface, {0, 0, 1}) != points_along(b.surface, {0, 0, 1}));
  for (const Vec3 other : {Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}}) {
    CHECK_FALSE(points_along(a.surface, other).empty());
    CHECK(points_along(a.surface, other) == points_along(b.surface, other));
  }
}

TEST_CASE("an empty style over another derives the same") {
  for (const char* const path : {"styles/library/listings.style", "bench/facade_box.style"}) {
    std::ifstream in(std::string(MANSARD_ROOT) + "/" + path);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    const Script plain = Script::text(text);
    const std::string name(plain.program().styles[plain.program().main_style].name);
    const Script heir = Script::text(text + "\nstyle Heir : " + name + " { }");
    for (uint64_t seed = 0; seed < 10; ++seed) {
      CHECK(same(plain.derive("rect:10x8", {.seed = seed}).surface,
                 heir.derive("rect:10x8", {.seed = seed}).surface));
    }
  }
  const std::string text =
      R"(style A { Plot { FOOTPRINT -> repeat("X", 1) { X }  X -> P1 : 1  X -> subdiv("X", rand(0.1, 0.9), 1r) { P2 | X1 } : 1 } }
style B : A { Plot { X -> [ t(0, rand(0, 1), 0) C1 ] super : 1  X -> super : 1 } })";
  const Script plain = Script::text(text), heir = Script::text(text + " style C : B { }");
  CHECK(same(plain.derive("rect:10x8").surface, heir.derive("rect:10x8").surface));
}
