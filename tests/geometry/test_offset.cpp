// Laws of setbacks and other plan figures, over random and real polygons.
#include <doctest/doctest.h>

#include <limits>

#include "geometry/clip.hpp"
#include "geometry/offset.hpp"
#include "tests/geometry/random_polygons.hpp"

namespace mansard {
namespace {

using test::RandomPolygons;
using test::total_area;
using test::well_formed;

constexpr unsigned seed = 4711;

double border_distance(const Polygon& polygon, Vec2 p) {
  double nearest = 1e300;
  for_each_edge(polygon, [&](uint32_t, Vec2 a, Vec2 b) {
    const Vec2 d = b - a;
    const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
    nearest = std::min(nearest, length(p - mix(a, b, t)));
  });
  return nearest;
}

double overlap(const std::vector<Polygon>& pieces) {
  double sum = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = i + 1; j < pieces.size(); ++j) {
      sum += total_area(intersection(pieces[i], pieces[j]));
    }
  }
  return sum;
}

/// Inside and border cover the polygon, and nothing twice.
void check_cover(const Polygon& p, const Inset& inset, bool pairs) {
  REQUIRE(well_formed(inset.inside));
  REQUIRE(well_formed(inset.border));
  const double whole = area(p), tolerance = 1e-6 * (whole + perimeter(p));
  const double sum = total_area(inset.inside) + total_area(inset.border);
  REQUIRE(std::abs(sum - whole) <= tolerance);
  REQUIRE(total_area(inset.inside) <= whole + tolerance);
  if (!pairs) return;
  std::vector<Polygon> all = inset.inside;
  all.insert(all.end(), inset.border.begin(), inset.border.end());
  REQUIRE(overlap(all) <= tolerance);
  for (const Polygon& piece : all) {
    REQUIRE(total_area(difference(piece, p)) <= tolerance);
  }
}

TEST_CASE("equal setbacks keep the inside at their distance") {
  RandomPolygons random(seed);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(seed);
    CAPTURE(i);
    const Polygon p = random.next();
    const double d = random.below(4) == 0 ? random.between(0.5, 1.5) : random.between(0.05, 0.5);
    const Inset inset = setback(p, [&](uint32_t) { return d; });
    check_cover(p, inset, i % 50 == 0);
    for (const Polygon& piece : inset.inside) {
      for (const Vec2 q : piece.points) REQUIRE(border_distance(p, q) >= d - 1e-6);
    }
  }
}

TEST_CASE("setbacks of some edges, by different distances") {
  RandomPolygons random(seed + 1);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const Polygon p = random.next();
    std::vector<double> distances;
    for (std::size_t e = 0; e < p.points.size(); ++e) {
      distances.push_back(random.below(2) == 0 ? 0 : random.between(0.05, 0.8));
    }
    const Inset inset = setback(p, [&](uint32_t e) { return distances[e]; });
    check_cover(p, inset, i % 50 == 0);
  }
}

TEST_CASE("setbacks of real footprints") {
  RandomPolygons random(seed + 2);
  int i = 0;
  for (const test::Named& footprint : test::simple_footprints(151)) {
    CAPTURE(footprint.name);
    if (footprint.polygon.points.size() > 120) continue;
    const double d = random.between(0.1, 3);
    const bool all = ++i % 2 == 0;
    const Inset inset =
        setback(footprint.polygon, [&](uint32_t e) { return all || e % 3 == 0 ? d : 0.0; });
    check_cover(footprint.polygon, inset, i % 50 == 0);
  }
}

TEST_CASE("a rectangle set back from its street") {
  Polygon p = rectangle(10, 6);
  for (uint16_t i = 0; i < 4; ++i) p.tags[i].wall = i;
  const Inset front = setback(p, [](uint32_t e) { return e == 0 ? 2.0 : 0.0; });
  REQUIRE(front.inside.size() == 1);
  CHECK(front.inside[0].points == std::vector<Vec2>{{0, 2}, {10, 2}, {10, 6}, {0, 6}});
  CHECK(front.inside[0].tags == p.tags);
  REQUIRE(front.border.size() == 1);
  CHECK(front.border[0].tags[0].wall == 0);
  CHECK(front.border[0].tags[1].wall == 1);
  CHECK(front.border[0].tags[2].has(EdgeTag::cut));
  CHECK(front.border[0].tags[3].wall == 3);

  const Inset around = setback(p, [](uint32_t) { return 1.0; });
  REQUIRE(around.inside.size() == 1);
  CHECK(around.inside[0].points == std::vector<Vec2>{{1, 1}, {9, 1}, {9, 5}, {1, 5}});
  REQUIRE(around.border.size() == 4);
  CHECK(area(around.border[0]) == doctest::Approx(9));
  CHECK(area(around.border[1]) == doctest::Approx(5));

  const Inset gone = setback(p, [](uint32_t) { return 4.0; });
  CHECK(gone.inside.empty());
  REQUIRE(gone.border.size() == 4);  // a hip roof's faces
  CHECK(area(gone.border[0]) == doctest::Approx(21));
  CHECK(area(gone.border[1]) == doctest::Approx(9));
  const Inset none = setback(p, [](uint32_t) { return 0.0; });
  CHECK(none.border.empty());
  CHECK(none.inside[0].points == p.points);
}

TEST_CASE("a deep setback splits a dumbbell in two and reaches no far wing") {
  Polygon p;  // two squares joined by a corridor 1 m wide
  for (const Vec2 q : {Vec2{0, 0},
                       {6, 0},
                       {6, 2.5},
                       {10, 2.5},
                       {10, 0},
                       {16, 0},
                       {16, 6},
                       {10, 6},
                       {10, 3.5},
                       {6, 3.5},
                       {6, 6},
                       {0, 6}}) {
    p.add_point(q);
  }
  p.close_ring();
  const Inset inset = setback(p, [](uint32_t) { return 0.75; });
  CHECK(inset.inside.size() == 2);
  CHECK(total_area(inset.inside) == doctest::Approx(2 * 4.5 * 4.5));

  Polygon u;  // the court between the wings is 1 m wide; the left wing's outer wall moves 4 m
  for (const Vec2 q : {Vec2{0, 0}, {7, 0}, {7, 8}, {4, 8}, {4, 2}, {3, 2}, {3, 8}, {0, 8}}) {
    u.add_point(q);
  }
  u.close_ring();
  const Inset left = setback(u, [](uint32_t e) { return e == 7 ? 4.0 : 0.0; });
  bool right_wing_stays = false;
  for (const Polygon& piece : left.inside) {
    right_wing_stays = right_wing_stays || contains(piece, {4.5, 7});
  }
  CHECK(right_wing_stays);
}

TEST_CASE("an outset is a larger polygon at its distance") {
  RandomPolygons random(seed + 3);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const Polygon p = random.next();
    const double d = random.between(0.05, 2);
    const auto grown = outset(p, d);
    REQUIRE(grown.size() == 1);
    REQUIRE(well_formed(grown));
    for (const Vec2 q : grown[0].points) {
      REQUIRE(border_distance(p, q) >= d - 1e-6);
      REQUIRE(border_distance(p, q) <= 4 * d + 1e-6);
    }
    if (i % 50 == 0) REQUIRE(total_area(difference(p, grown[0])) <= 1e-6);
  }
  const auto square = outset(rectangle(2, 2), 1);
  CHECK(square[0].points == std::vector<Vec2>{{-1, -1}, {3, -1}, {3, 3}, {-1, 3}});
}

TEST_CASE("outsets of real footprints") {
  for (const test::Named& footprint : test::simple_footprints(151)) {
    CAPTURE(footprint.name);
    const auto grown = outset(footprint.polygon, 0.5);
    REQUIRE(grown.size() == 1);
    REQUIRE(well_formed(grown));
    REQUIRE(area(grown[0]) > area(footprint.polygon));
  }
}

TEST_CASE("chamfers cut convex corners between chosen edges") {
  const auto all = [](uint32_t) { return true; };
  const Polygon octagon = chamfer(rectangle(4, 4), 1, all);
  CHECK(octagon.points.size() == 8);
  CHECK(area(octagon) == doctest::Approx(14));
  const Polygon diamond = chamfer(rectangle(4, 4), 9, all);
  CHECK(diamond.points.size() == 4);
  CHECK(area(diamond) == doctest::Approx(8));
  const Polygon one = chamfer(rectangle(4, 4), 1, [](uint32_t e) { return e < 2; });
  CHECK(one.points.size() == 5);
  CHECK(area(one) == doctest::Approx(15.5));
  CHECK(chamfer(rectangle(4, 4), 0, all).points.size() == 4);
  RandomPolygons random(seed + 4);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const Polygon p = random.next();
    const Polygon cut = chamfer(p, random.between(0.01, 0.2), all);
    REQUIRE(well_formed(cut));
    REQUIRE(cut.points.size() >= p.points.size());
  }
}

TEST_CASE("the inner rectangle fits and is nearly the largest") {
  CHECK(area(inner_rectangle(rectangle(3, 2))) == doctest::Approx(6));
  Polygon l;
  for (const Vec2 q : {Vec2{0, 0}, {10, 0}, {10, 3}, {2, 3}, {2, 8}, {0, 8}}) l.add_point(q);
  l.close_ring();
  CHECK(area(inner_rectangle(l)) == doctest::Approx(30));
  Polygon triangle;
  for (const Vec2 q : {Vec2{0, 0}, {4, 0}, {1, 4}}) triangle.add_point(q);
  triangle.close_ring();
  CHECK(area(inner_rectangle(triangle)) >= 0.99 * 4);  // half of the triangle
  CHECK(area(inner_rectangle(triangle)) <= 4 + 1e-9);
  RandomPolygons random(seed + 5);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    const Polygon p = random.next();
    const Polygon r = inner_rectangle(p);
    REQUIRE(well_formed(r));
    REQUIRE(total_area(difference(r, p)) <= 1e-6);
  }
  CHECK(inner_rectangle({}).empty());
}

TEST_CASE("the inradius is that of the largest inscribed circle") {
  CHECK(inradius(rectangle(50, 10)) == doctest::Approx(5).epsilon(1e-3));
  CHECK(inradius(rectangle(3, 3)) == doctest::Approx(1.5).epsilon(1e-3));
  Polygon triangle;
  for (const Vec2 q : {Vec2{0, 0}, {4, 0}, {0, 3}}) triangle.add_point(q);
  triangle.close_ring();
  CHECK(inradius(triangle) == doctest::Approx(1).epsilon(1e-3));
  CHECK(inradius({}) == 0);
  // An inset just beyond the radius leaves nothing; just short of it, and without reflex corners
  // whose mitres reach further, it leaves something.
  RandomPolygons random(seed + 6);
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const Polygon p = random.next();
    const double r = inradius(p);
    REQUIRE(r > 0);
    REQUIRE(total_area(setback(p, [&](uint32_t) { return 1.01 * r + 1e-3; }).inside) < 1e-6);
    if (!is_convex(p)) continue;
    REQUIRE_FALSE(setback(p, [&](uint32_t) { return 0.99 * r; }).inside.empty());
  }
}

TEST_CASE("bad input neither crashes nor hangs") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Polygon bow;
  for (const Vec2 q : {Vec2{0, 0}, {4, 4}, {4, 0}, {0, 4}}) bow.add_point(q);
  bow.close_ring();
  Polygon flat;
  for (const Vec2 q : {Vec2{0, 0}, {4, 0}, {2, 0}, {1, 0}}) flat.add_point(q);
  flat.close_ring();
  Polygon repeated = rectangle(2, 2);
  repeated.points[1] = repeated.points[0];
  Polygon two;
  two.add_point({0, 0});
  two.add_point({1, 0});
  two.close_ring();
  Polygon unknown = rectangle(2, 2);
  unknown.points[2].x = nan;
  for (const Polygon& p : {bow, flat, repeated, two, Polygon{}, unknown}) {
    for (const double d : {0.0, 0.1, 1.0, 1e9, -1.0, nan}) {
      setback(p, [&](uint32_t) { return d; });
      outset(p, d);
      chamfer(p, d, [](uint32_t) { return true; });
      clip(p, {1, 0}, d);
      clip_strip(p, 0, d, 2);
    }
    inner_rectangle(p);
    inradius(p);
    triangulate(p);
    intersection(p, bow);
    difference(bow, p);
  }
}

}  // namespace
}  // namespace mansard
