// Skeletons over shapes whose skeletons are known, and against oracles.
#include <doctest/doctest.h>

#include "geometry/clean.hpp"
#include "geometry/offset.hpp"
#include "tests/geometry/random_polygons.hpp"
#include "tests/geometry/skeleton_checks.hpp"

namespace mansard {
namespace {

using test::Named;

SkeletonOn skeleton_of(const Polygon& polygon) {
  const auto on = best_skeleton(polygon);
  REQUIRE(on);
  CHECK(test::broken_skeleton(on->mesh, on->polygon) == "");
  CHECK(test::broken_map(*on, polygon) == "");
  return *on;
}

Polygon of(const char* wkt) { return test::polygon_of_wkt(wkt); }

Polygon regular(int n, double radius) {
  Polygon polygon;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    polygon.add_point({radius * std::cos(angle), radius * std::sin(angle)});
  }
  polygon.close_ring();
  return polygon;
}

double highest(const SkeletonMesh& mesh) {
  double most = 0;
  for (const Vec3 p : mesh.nodes) most = std::max(most, p.z);
  return most;
}

TEST_CASE("courtyards have slopes of their own") {
  const char* ring = "POLYGON((0 0,20 0,20 20,0 20),(6 6,6 14,14 14,14 6))";
  const SkeletonOn on = skeleton_of(of(ring));
  CHECK(on.mesh.nodes.size() == 12);  // a ridge all round, at half the width of the wings
  CHECK(highest(on.mesh) == doctest::Approx(3));
  const char* two = "POLYGON((0 0,30 0,30 14,0 14),(4 5,4 9,10 9,10 5),(18 4,18 10,24 9))";
  CHECK(skeleton_of(of(two)).fallback == 1);
  const char* touching = "POLYGON((0 0,20 0,20 14,0 14),(0 5,6 8,6 4))";
  const SkeletonOn apart = skeleton_of(of(touching));
  CHECK(apart.fallback == 2);
  CHECK(apart.moved);
}

TEST_CASE("slopes of walls along one line are parted square to them") {
  for (int k = 0; k < 60; ++k) {
    const double a = 3 + 0.1 * k, turn = 0.1 * k;
    Polygon house;  // a T, whose wing stands on two walls along one line
    for (const Vec2 p : {Vec2{0, 0}, Vec2{a + 9, 0}, Vec2{a + 9, 9}, Vec2{a + 4, 9},
                         Vec2{a + 4, 15}, Vec2{a, 15}, Vec2{a, 9}, Vec2{0, 9}}) {
      house.add_point({p.x * std::cos(turn) - p.y * std::sin(turn),
                       p.x * std::sin(turn) + p.y * std::cos(turn)});
    }
    house.close_ring();
    const SkeletonMesh mesh = skeleton_of(house).mesh;
    const Vec3 wing = mesh.nodes[mesh.face(2)[2]], ridge = mesh.nodes[mesh.face(2)[3]];
    CAPTURE(k);
    CHECK(mesh.face(2).size() == 5);
    CHECK(std::abs(length(test::flat(wing) - test::flat(ridge)) - 2.5) < 1e-6);
  }
}

TEST_CASE("over near squares the ridge shrinks to a point and does not flicker") {
  for (const double turn : {0.0, 0.3, 0.7853981633974483}) {
    for (double more = 1; more > 1e-15; more /= 3) {
      Polygon square;
      for (const Vec2 p : {Vec2{0, 0}, Vec2{9 + more, 0}, Vec2{9 + more, 9}, Vec2{0, 9}}) {
        square.add_point({p.x * std::cos(turn) - p.y * std::sin(turn),
                          p.x * std::sin(turn) + p.y * std::cos(turn)});
      }
      square.close_ring();
      const SkeletonMesh mesh = skeleton_of(square).mesh;
      const double ridge = length(mesh.nodes[4] - mesh.nodes[5]);
      CAPTURE(more);
      CHECK(std::abs(ridge - more) < 1.1e-5);
      if (more < 1e-6) CHECK(ridge == 0);
    }
  }
}

TEST_CASE("regular polygons have one apex") {
  for (const int n : {3, 5, 6, 7, 8, 12, 24, 60, 500}) {
    for (const double radius : {0.01, 1.0, 10.0, 500.0}) {
      CAPTURE(n);
      CAPTURE(radius);
      const Polygon polygon = regular(n, radius);
      const SkeletonMesh mesh = skeleton_of(polygon).mesh;
      CHECK(highest(mesh) == doctest::Approx(radius * std::cos(std::numbers::pi / n)));
      if (radius > 0.1) CHECK(mesh.nodes.size() == polygon.points.size() + 1);
    }
  }
}

TEST_CASE("curves, slivers and millimetres are no trouble") {
  Polygon curve;  // of 500 points, thick as a wall
  for (int i = 0; i < 250; ++i) curve.add_point({i * 0.1, 3 * std::sin(i * 0.05)});
  for (int i = 250; i-- > 0;) curve.add_point({i * 0.1, 1 + 3 * std::sin(i * 0.05)});
  curve.close_ring();
  CHECK(skeleton_of(curve).fallback == 1);
  CHECK(skeleton_of(of("POLYGON((0 0,100 0.001,200 0,100 0.002))")).fallback == 1);
  CHECK(skeleton_of(of("POLYGON((0 0,100 0,100 0.0001,0 0.0002))")).fallback == 1);
  Polygon fine =
      of("POLYGON((0 0,8 0,8 0.001,8.001 0.001,8.001 5,8 5.001,0 5.001,-0.001 5,-0.001 0.001))");
  CHECK(skeleton_of(fine).polygon.points.size() == 9);
  Polygon steps;  // a diagonal of steps of a millimetre
  for (int i = 0; i < 400; ++i) {
    steps.add_point({i * 1e-3, -i * 1e-3});
    steps.add_point({(i + 1) * 1e-3, -i * 1e-3});
  }
  steps.add_point({3, 3});
  steps.close_ring();
  CHECK(skeleton_of(steps).polygon.points.size() == 801);
}

#if !defined(__SANITIZE_ADDRESS__) && defined(NDEBUG)
TEST_CASE("thousands of points take less than two seconds") {
  test::RandomPolygons random(1);
  Polygon star;
  for (int i = 0; i < 3900; ++i) {
    const double angle = 2 * std::numbers::pi * i / 3900, radius = random.between(20, 50);
    star.add_point({radius * std::cos(angle), radius * std::sin(angle)});
  }
  star.close_ring();
  Polygon line;  // all but two along one edge
  for (int i = 0; i < 8000; ++i) line.add_point({i * 0.01, 0});
  for (const Vec2 p : {Vec2{80, 9}, Vec2{0, 9}}) line.add_point(p);
  line.close_ring();
  Polygon tangle;
  for (int i = 0; i < 8000; ++i) tangle.add_point({random.between(0, 99), random.between(0, 99)});
  tangle.close_ring();
  for (const Polygon& polygon : {star, regular(19000, 50), line, tangle}) {
    const double begin = test::cpu_seconds();
    best_skeleton(polygon);
    CHECK(test::cpu_seconds() - begin < 2);
  }
  CHECK(skeleton_of(star).fallback == 1);
}
#endif

// Heights of convex roofs are the least distance to a wall.
TEST_CASE("skeletons over convex polygons are the nearest walls") {
  constexpr unsigned seed = 3;
  test::RandomPolygons random(seed);
  for (int i = 0; i < 300; ++i) {
    Polygon polygon;
    const int n = 3 + random.below(14);
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * (k + random.between(0, 0.9)) / n;
      polygon.add_point({7 * std::cos(angle), 4 * std::sin(angle)});
    }
    polygon.close_ring();
    const SkeletonMesh mesh = skeleton_of(polygon).mesh;
    for (int k = 0; k < 20; ++k) {
      const Vec2 p{random.between(-7, 7), random.between(-4, 4)};
      if (!contains(polygon, p)) continue;
      double nearest = 1e300;
      for_each_edge(polygon, [&](uint32_t, Vec2 a, Vec2 b) {
        nearest = std::min(nearest, test::inwards(a, b, p));
      });
      CHECK(std::abs(test::height_at(mesh, p) - nearest) < 1e-5);
    }
  }
}

// Heights by brute force: how many small steps of mitred insets leave a point inside. Each step is
// made by cutting away swept rectangles, which knows nothing of events; so it is right but for what
// happens within a step.
double height_by_steps(const Polygon& polygon, Vec2 p, double step) {
  std::vector<Polygon> left{polygon};
  for (double height = 0;; height += step) {
    std::vector<Polygon> next;
    for (const Polygon& part : left) {
      if (!contains(part, p)) continue;
      for (Polygon& inner : setback(part, [&](uint32_t) { return step; }).inside) {
        next.push_back(std::move(inner));
      }
    }
    if (next.empty()) return height;
    left = std::move(next);
  }
}

TEST_CASE("skeletons are what small insets leave") {
  constexpr unsigned seed = 21;
  test::RandomPolygons random(seed);
  for (int i = 0; i < 60; ++i) {
    const Polygon polygon = random.next();
    const SkeletonOn on = skeleton_of(polygon);
    const double step = highest(on.mesh) / 25;
    const Box2 box = bounds(polygon.points);
    for (int k = 0; k < 6; ++k) {
      const Vec2 p{random.between(box.low.x, box.high.x), random.between(box.low.y, box.high.y)};
      if (!contains(polygon, p)) continue;
      CAPTURE(i);
      CAPTURE(p.x);
      CAPTURE(p.y);
      CHECK(std::abs(test::height_at(on.mesh, p) - height_by_steps(on.polygon, p, step)) <
            2 * step);
    }
  }
}

TEST_CASE("the wavefront's skeletons are CGAL's") {
  std::vector<Named> all = test::real_footprints(test::long_run ? 1 : 8);
  if (all.empty()) MESSAGE("no real footprints beside the project; only random ones");
  test::RandomPolygons random(17);
  for (int i = 0; i < 1000; ++i) all.push_back({"random " + std::to_string(i), random.next()});
  int compared = 0, alone = 0;
  for (const Named& named : all) {
    const auto cleaned = clean(named.polygon, {});
    if (!cleaned || cleaned->polygon.points.size() > 200) continue;
    const auto ours =
        checked_skeleton(cleaned->polygon, {SkeletonMaker::wavefront, 1e-8, 1e-5, 1e-7});
    const auto cgals = checked_skeleton(cleaned->polygon, {SkeletonMaker::cgal, 1e-6, 1e-6, 0});
    if (!ours || !cgals) {
      ++alone;
      continue;
    }
    ++compared;
    const double off = test::difference(*ours, *cgals);
    CAPTURE(named.name);
    CHECK(off < 1e-4);
  }
  MESSAGE(compared << " compared; " << alone << " with a skeleton by one of them only");
  CHECK(alone * 200 < compared);
}

}  // namespace
}  // namespace mansard
