// What cleaning drops, and that it says what became of every point and edge.
#include <doctest/doctest.h>

#include <algorithm>

#include "geometry/clean.hpp"
#include "tests/geometry/random_polygons.hpp"

namespace mansard {
namespace {

constexpr uint32_t none = Cleaned::no_edge;
using Numbers = std::vector<uint32_t>;

Polygon of(std::initializer_list<Vec2> points) {
  Polygon polygon;
  for (const Vec2 p : points) polygon.add_point(p, {0, static_cast<uint16_t>(polygon.tags.size())});
  polygon.close_ring();
  return polygon;
}

void add_hole(Polygon& polygon, std::initializer_list<Vec2> points) {
  for (const Vec2 p : points) polygon.add_point(p);
  polygon.close_ring();
}

// Of the line, since the sides of spikes run past their edge's end.
double off_the_line(const Polygon& polygon, uint32_t edge, Vec2 p) {
  double off = 1e300;
  for_each_edge(polygon, [&](uint32_t e, Vec2 a, Vec2 b) {
    if (e == edge) off = std::abs(cross(normalized(b - a), p - a));
  });
  return off;
}

// The first promise of Cleaned that is not kept, or nothing.
std::string broken_promise(const Polygon& original, const Cleaned& cleaned, double within) {
  const Polygon& polygon = cleaned.polygon;
  const std::size_t n = polygon.points.size();
  if (cleaned.points.size() != n || cleaned.edges.size() != n || polygon.tags.size() != n ||
      cleaned.edge_of.size() != original.points.size()) {
    return "the lists do not fit";
  }
  std::vector<char> has_part(n, 0);
  for (uint32_t e = 0; e < n; ++e) {
    if (cleaned.edge_of[cleaned.edges[e]] != e) return "the longest part is no part";
    if (polygon.tags[e] != original.tags[cleaned.edges[e]]) return "a wrong tag";
    if (!cleaned.moved && polygon.points[e] != original.points[cleaned.points[e]]) {
      return "a corner has moved";
    }
  }
  std::string why;
  for_each_edge(original, [&](uint32_t e, Vec2 a, Vec2 b) {
    const uint32_t to = cleaned.edge_of[e];
    if (to == none) return;
    if (to >= n) {
      why = "no such edge";
      return;
    }
    const double off = std::max(off_the_line(polygon, to, a), off_the_line(polygon, to, b));
    const bool on = cleaned.moved || off < within;
    if (on) has_part[to] = 1;
    if (!on && length(b - a) > 0) why = "a part is off its edge";
  });
  if (why.empty() && std::count(has_part.begin(), has_part.end(), 0) > 0)
    why = "an edge of nothing";
  return why;
}

TEST_CASE("cleaning drops points on edges, near points and spikes, and says so") {
  struct Example {
    Polygon polygon;
    Numbers points, edge_of;
  };
  for (const Example& e : std::vector<Example>{
           {of({{0, 0}, {3, 0}, {8, 0}, {8, 4}, {0, 4}}), {0, 2, 3, 4}, {0, 0, 1, 2, 3}},
           {of({{4, 0}, {8, 0}, {8, 4}, {0, 4}, {0, 0}}), {1, 2, 3, 4}, {3, 0, 1, 2, 3}},
           {of({{0, 0}, {1e-6, 0}, {8, 0}, {8, 4}, {0, 4}}), {0, 2, 3, 4}, {0, 0, 1, 2, 3}},
           {of({{0, 0}, {8, 0}, {8, 4}, {0, 4}, {0, 1e-6}}), {0, 1, 2, 3}, {0, 1, 2, 3, 3}},
           // spikes: beside a corner, beyond one, on an edge, of two parts
           {of({{0, 0}, {8, 0}, {8, 4}, {0, 4}, {-2, 4}, {0, 4}}),
            {0, 1, 2, 5},
            {0, 1, 2, none, none, 3}},
           {of({{0, 0}, {8, 0}, {8, 6}, {8, 4}, {0, 4}}), {0, 1, 3, 4}, {0, 1, none, 2, 3}},
           {of({{0, 0}, {5, 0}, {5, -3}, {5, 0}, {8, 0}, {8, 4}, {0, 4}}),
            {0, 4, 5, 6},
            {0, none, none, 0, 1, 2, 3}},
           {of({{0, 0}, {8, 0}, {8, 5}, {8, 6}, {8, 4}, {0, 4}}),
            {0, 1, 4, 5},
            {0, 1, none, none, 2, 3}},
           // clockwise
           {of({{0, 0}, {0, 4}, {8, 4}, {8, 2}, {8, 0}}), {4, 2, 1, 0}, {2, 1, 0, 0, 3}},
       }) {
    const auto cleaned = clean(e.polygon, {});
    REQUIRE(cleaned);
    CHECK(cleaned->points == e.points);
    CHECK(cleaned->edge_of == e.edge_of);
    CHECK(broken_promise(e.polygon, *cleaned, 1e-5) == "");
  }
}

TEST_CASE("cleaning drops holes without area, outside, or within others") {
  Polygon house = of({{0, 0}, {20, 0}, {20, 20}, {0, 20}});
  add_hole(house, {{5, 5}, {5, 15}, {15, 15}, {15, 5}});
  add_hole(house, {{2, 2}, {2, 2.0005}, {2.0005, 2}});
  add_hole(house, {{30, 5}, {30, 15}, {35, 5}});
  add_hole(house, {{8, 8}, {8, 9}, {9, 8}});
  const auto cleaned = clean(house, {});
  REQUIRE(cleaned);
  CHECK(cleaned->points == Numbers{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(cleaned->edge_of[3] == 3);
  CHECK(cleaned->edge_of[7] == 7);
  for (uint32_t e = 8; e < house.points.size(); ++e) CHECK(cleaned->edge_of[e] == none);
}

TEST_CASE("every point and edge is accounted for after cleaning") {
  const CleanTolerance tolerance;
  test::RandomPolygons random(11);
  std::vector<test::Named> all;
  all.reserve(2000);
  for (int i = 0; i < 2000; ++i) all.push_back({std::to_string(i), random.next()});
  for (test::Named& named : test::real_footprints(10)) all.push_back(std::move(named));
  for (const test::Named& named : all) {
    CAPTURE(named.name);
    const auto cleaned = clean(named.polygon, tolerance);
    if (cleaned) CHECK(broken_promise(named.polygon, *cleaned, tolerance.near + 1e-9) == "");
  }
}

}  // namespace
}  // namespace mansard
