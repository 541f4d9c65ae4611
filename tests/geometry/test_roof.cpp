// Laws of roofs, over random and real footprints.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <sstream>
#include <tuple>

#include "geometry/clean.hpp"
#include "geometry/roof.hpp"
#include "geometry/skeleton.hpp"
#include "tests/geometry/roof_input.hpp"
#include "tests/geometry/roof_laws.hpp"

namespace mansard {
namespace {

using test::all_kinds;
using test::area_vector;
using test::broken_law;

std::string text_of(const Polygon& polygon) {
  std::ostringstream out;
  out.precision(17);
  for (const Vec2 p : polygon.points) out << p.x << ' ' << p.y << ", ";
  return out.str();
}

TEST_CASE("roofs over random footprints obey every law") {
  constexpr unsigned seed = 7;
  CAPTURE(seed);
  test::RandomFootprints footprints(seed);
  for (int i = 0; i < 600; ++i) {
    Polygon polygon = footprints.next();
    for (std::size_t e = 0; e < polygon.tags.size(); e += 3) {
      if (i % 2 == 1) polygon.tags[e].flags = EdgeTag::party;
    }
    for (const RoofOptions& options : all_kinds()) {
      const std::string why = broken_law(polygon, options, 1e-5);
      if (!why.empty()) {
        CAPTURE(text_of(polygon));
        CAPTURE(static_cast<int>(options.kind));
        CAPTURE(options.overhang);
        FAIL_CHECK(why << " at number " << i);
      }
    }
    CHECK(roof(polygon, {}).fallback == 1);
  }
}

double highest(const Roof& roof) {
  double up = 0;
  for (const RoofFace& face : roof.faces) {
    for (const Vec3 p : face.loop) up = std::max(up, p.z);
  }
  return up;
}

int count(const Roof& roof, RoofPart part) {
  return static_cast<int>(std::count_if(roof.faces.begin(), roof.faces.end(),
                                        [&](const RoofFace& f) { return f.part == part; }));
}

TEST_CASE("a gable roof's ridge is as high over a rectangle as half its width says") {
  const Polygon house = rectangle(8, 12);
  RoofOptions options;
  options.kind = RoofKind::gable;
  options.pitch = 45;
  const Roof made = roof(house, options);
  CHECK(count(made, RoofPart::gable) == 2);
  CHECK(count(made, RoofPart::slope) == 2);
  CHECK(made.faces[0].part == RoofPart::gable);  // in the order of the edges
  CHECK(made.faces[1].part == RoofPart::slope);
  CHECK(highest(made) == doctest::Approx(4));
  options.height = 2.5;
  CHECK(highest(roof(house, options)) == doctest::Approx(2.5));
}

TEST_CASE("gables stand only where they may") {
  Polygon house = rectangle(8, 12);
  RoofOptions options;
  options.kind = RoofKind::gable;
  options.pitch = 45;
  options.gables = {0, 0, 1, 0};
  CHECK(count(roof(house, options), RoofPart::gable) == 1);
  CHECK(count(roof(house, options), RoofPart::slope) == 3);
  options.gables = {0, 1, 0, 1};  // the long sides: the ridge turns
  CHECK(highest(roof(house, options)) == doctest::Approx(6));
  options.gables = {0, 0, 0, 0};
  CHECK(count(roof(house, options), RoofPart::slope) == 4);
}

TEST_CASE("a square and the wings of a T get gables") {
  RoofOptions options;
  options.kind = RoofKind::gable;
  CHECK(count(roof(rectangle(9, 9), options), RoofPart::gable) == 2);
  Polygon t;
  for (const Vec2 p : {Vec2{0, 0}, Vec2{15, 0}, Vec2{15, 6}, Vec2{10, 6}, Vec2{10, 12}, Vec2{5, 12},
                       Vec2{5, 6}, Vec2{0, 6}}) {
    t.add_point(p);
  }
  t.close_ring();
  CHECK(count(roof(t, options), RoofPart::gable) == 3);
}

TEST_CASE("no roof stands out over a party wall") {
  Polygon house = rectangle(8, 12);
  house.tags[2].flags = EdgeTag::party;
  for (RoofOptions options : all_kinds()) {
    if (options.overhang == 0) continue;
    CAPTURE(static_cast<int>(options.kind));
    Vec3 sum;
    double depth = 0, wide = 0;
    for (const RoofFace& face : roof(house, options).faces) {
      sum = sum + area_vector(face);
      for (const Vec3 p : face.loop) {
        depth = std::max(depth, p.y);
        wide = std::max(wide, p.x);
      }
    }
    CHECK(depth == doctest::Approx(12));
    const bool bare = options.kind == RoofKind::pyramid ||
                      (test::swept(options.kind) && options.kind != RoofKind::flat &&
                       options.kind != RoofKind::cross_gable);
    CHECK(wide == doctest::Approx(bare ? 8 : 8.4));
    CHECK(length(sum - Vec3{0, 0, 96}) < 1e-9);  // closed but for the footprint
    CHECK(broken_law(house, options, 1e-5) == "");
  }
}

TEST_CASE("what crosses itself is repaired, what has no inside gets no roof") {
  Polygon crossing;
  for (const Vec2 p : {Vec2{0, 0}, Vec2{10, 10}, Vec2{10, 0}, Vec2{0, 9}}) crossing.add_point(p);
  crossing.close_ring();
  CHECK(roof(crossing, {}).fallback == 4);
  CHECK(count(roof(crossing, {}), RoofPart::slope) == 6);  // two triangles
  CHECK(roof(Polygon{}, {}).faces.empty());
  Polygon point;
  point.add_point({1, 1});
  point.close_ring();
  CHECK(roof(point, {}).faces.empty());
  Polygon nan = rectangle(3, 4);
  nan.points[2].x = std::nan("");
  CHECK(roof(nan, {}).faces.empty());
  Polygon huge = rectangle(1e9, 1e9);
  CHECK(roof(huge, {}).faces.size() == 4);
}

TEST_CASE("rings that touch are moved apart, and what pinches itself too") {
  for (const char* wkt : {
           "POLYGON((0 0,20 0,20 14,0 14),(0 5,6 8,6 4))",                  // on an edge
           "POLYGON((0 0,20 0,20 14,0 14),(20 14,14 8,16 6))",              // at a corner
           "POLYGON((0 0,20 0,20 14,0 14),(4 4,4 8,9 6),(9 6,14 9,13 4))",  // two holes
           "POLYGON((0 0,10 0,10 6,20 0,20 12,10 6,10 12,0 12))",           // from outside
       }) {
    CAPTURE(wkt);
    const Polygon polygon = test::polygon_of_wkt(wkt);
    RoofOptions options;
    options.pitch = 40;
    CHECK(roof(polygon, options).fallback <= 3);
    CHECK(broken_law(polygon, options, 1e-6) == "");
  }
}

TEST_CASE("eaves without room stand flush, with every point of the walls' tops") {
  // The outline nearly turns back at a corner, whose eaves would be metres long; one of the walls
  // there has a point in its middle.
  const Polygon thorn = test::polygon_of_wkt(
      "POLYGON((7 11,11.259679 6.926099,6.540326 2.256819,6.479627 2.312406,8.463728 0.322403,"
      "10.447829 -1.6676,6 -6,-4 0))");
  RoofOptions options;
  options.overhang = 0.4;
  options.pitch = 40;
  CHECK(broken_law(thorn, options, 1e-5) == "");
}

TEST_CASE("a parapet stands flush with the facade and inside it") {
  RoofOptions options;
  options.kind = RoofKind::flat;
  options.parapet = 1;
  const Roof made = roof(rectangle(8, 12), options);
  CHECK(count(made, RoofPart::parapet) == 12);
  double caps = 0;
  for (const RoofFace& face : made.faces) {
    for (const Vec3 p : face.loop) CHECK((p.x >= 0 && p.x <= 8 && p.y >= 0 && p.y <= 12));
    if (face.part == RoofPart::parapet) caps += area_vector(face).z;
    if (face.part == RoofPart::top) CHECK(area_vector(face).z == doctest::Approx(7.5 * 11.5));
  }
  CHECK(caps == doctest::Approx(8 * 12 - 7.5 * 11.5));
}

TEST_CASE("every edge has its face in a skeleton, merged ones share it") {
  Polygon house = rectangle(8, 4);
  house.points.insert(house.points.begin() + 1, {3, 0});
  house.tags.emplace_back();
  house.ring_ends[0] = 5;
  const auto on = best_skeleton(house);
  REQUIRE(on);
  CHECK(on->edge_of[0] == on->edge_of[1]);
  CHECK(on->edges[on->edge_of[0]] == 1);  // 5 m of 8
  CHECK(on->mesh.face(on->edge_of[1]).size() == 4);
  CHECK(on->mesh.face(on->edge_of[2]).size() == 3);
}

}  // namespace
}  // namespace mansard
