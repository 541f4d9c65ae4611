#include <doctest/doctest.h>

#include <algorithm>

#include "geometry/polygon.hpp"
#include "tests/geometry/random_polygons.hpp"

namespace mansard {
namespace {

Polygon ell() {
  Polygon p;
  for (const Vec2 q : {Vec2{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}) {
    p.add_point(q, {0, static_cast<uint16_t>(p.points.size())});
  }
  p.close_ring();
  return p;
}

TEST_CASE("measures of an L with a hole") {
  Polygon p = ell();
  for (const Vec2 q : {Vec2{1, 1}, {1, 1.5}, {1.5, 1.5}, {1.5, 1}}) p.add_point(q);
  p.close_ring();
  CHECK(area(p) == doctest::Approx(11.75));
  CHECK(perimeter(p) == doctest::Approx(18));
  CHECK(bounds(p.points).size() == Vec2{4, 4});
  CHECK_FALSE(is_convex(p));
  CHECK(contains(p, {0.5, 3}));
  CHECK(contains(p, {2, 3}));    // on the border
  CHECK(contains(p, {1, 1.2}));  // on the hole's border
  CHECK_FALSE(contains(p, {1.2, 1.2}));
  CHECK_FALSE(contains(p, {3, 3}));
}

TEST_CASE("convex and axis-parallel") {
  CHECK(is_convex(rectangle(3, 2)));
  CHECK(is_axis_rectangle(rectangle(3, 2), 1e-9));
  CHECK_FALSE(is_convex(ell()));
  Polygon turned = rectangle(1, 1);
  for (Vec2& p : turned.points) p = {p.x - p.y, p.x + p.y};
  CHECK(is_convex(turned));
  CHECK_FALSE(is_axis_rectangle(turned, 1e-9));
  Polygon with_straight_point = rectangle(2, 2);
  with_straight_point.points.insert(with_straight_point.points.begin() + 1, Vec2{1, 0});
  with_straight_point.tags.emplace_back();
  with_straight_point.ring_ends = {5};
  CHECK(is_convex(with_straight_point));
  CHECK_FALSE(is_convex(Polygon{}));
  Polygon pentagram;
  for (int i = 0; i < 5; ++i) {
    const double angle = i * 4 * std::numbers::pi / 5;
    pentagram.add_point({std::cos(angle), std::sin(angle)});
  }
  pentagram.close_ring();
  CHECK_FALSE(is_convex(pentagram));
}

TEST_CASE("mirroring keeps areas, orientation and the tag of every edge") {
  test::RandomPolygons random(1);
  for (int i = 0; i < 500; ++i) {
    const Polygon p = random.next();
    Polygon q = p;
    mirror_u(q);
    REQUIRE(area(q) == doctest::Approx(area(p)));
    REQUIRE(test::well_formed(q));
    for_each_edge(q, [&](uint32_t edge, Vec2 from, Vec2 to) {
      const uint16_t wall = q.tags[edge].wall;  // the number of the edge in p
      for_each_edge(p, [&](uint32_t e, Vec2 a, Vec2 b) {
        if (e == wall) REQUIRE((a == Vec2{-to.x, to.y} && b == Vec2{-from.x, from.y}));
      });
    });
  }
}

TEST_CASE("orient turns rings and keeps their first edge first") {
  Polygon p = ell();
  std::reverse(p.points.begin(), p.points.end());
  const Vec2 from = p.points[0], to = p.points[1];
  orient(p);
  CHECK(area(p.ring(0)) > 0);
  CHECK(p.points[1] == from);
  CHECK(p.points[0] == to);
  CHECK(p.tags[0].wall == 0);
  const Polygon once = p;
  orient(p);
  CHECK(p.points == once.points);
}

}  // namespace
}  // namespace mansard
