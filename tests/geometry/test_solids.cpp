#include "geometry/solids.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>

#include "tests/geometry/random_polygons.hpp"
#include "tests/geometry/solid_checks.hpp"

namespace mansard {
namespace {

using std::numbers::pi;

void check_solid(const Mesh& mesh, Vec3 size) {
  CHECK(test::is_closed(mesh));
  CHECK(test::volume(mesh) > 0);
  CHECK(test::unevenness(mesh) < 1e-9);
  const Box3 box = bounds(mesh.points);
  CHECK(length(box.low) < 1e-9);
  CHECK(box.size().x <= size.x + 1e-9);
  CHECK(box.size().y == doctest::Approx(size.y));
  CHECK(box.size().z <= size.z + 1e-9);
  for (const Mesh::Face& face : mesh.faces) {
    std::vector<Vec3> loop;
    for (const uint32_t c : mesh.loop(face)) loop.push_back(mesh.points[c]);
    CHECK(length(newell(loop)) > 0);
  }
}

TEST_CASE("round solids fill their boxes") {
  const Vec3 size{2, 3, 4};
  for (const int sides : {4, 8, 24, 100}) {
    CAPTURE(sides);
    check_solid(cylinder(size, sides), size);
    check_solid(cone(size, sides), size);
    check_solid(sphere(size, sides), size);
  }
  CHECK(test::volume(cylinder(size, 1000)) == doctest::Approx(pi * 2 * 3).epsilon(1e-4));
  CHECK(test::volume(cone(size, 1000)) == doctest::Approx(pi * 2).epsilon(1e-4));
  CHECK(test::volume(sphere(size, 400)) == doctest::Approx(pi * 4).epsilon(1e-3));
}

TEST_CASE("solids without a size are empty") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vec3 size : {Vec3{0, 1, 1}, {1, 0, 1}, {1, 1, -1}, {nan, 1, 1}}) {
    CHECK(cylinder(size, 8).faces.empty());
    CHECK(cone(size, 8).faces.empty());
    CHECK(sphere(size, 8).faces.empty());
  }
  CHECK(prism(rectangle(1, 1), 1, 0).faces.empty());
  CHECK(prism({}, 1, 1).faces.empty());
  CHECK(test::is_closed(cylinder({1, 1, 1}, -5)));
}

TEST_CASE("prisms are closed, outward and as large as they should be") {
  test::RandomPolygons random(3);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const Polygon base = random.next();
    const double height = random.between(-3, 8);
    const Mesh mesh = prism(base, 5, height);
    REQUIRE(test::is_closed(mesh));
    REQUIRE(test::volume(mesh) == doctest::Approx(area(base) * std::abs(height)).epsilon(1e-9));
    for (std::size_t e = 0; e < base.points.size(); ++e) {
      REQUIRE(mesh.faces[e].tag.wall == base.tags[e].wall);
    }
  }
  // The front wall looks out of the ground frame, along z.
  const Mesh box = prism(rectangle(3, 2), 2, 1);
  std::vector<Vec3> front;
  for (const uint32_t c : box.loop(box.faces[0])) front.push_back(box.points[c]);
  CHECK(normalized(newell(front)) == Vec3{0, 0, 1});
  CHECK(front[0] == Vec3{0, 0, 2});
}

TEST_CASE("tapered shapes close with their base and have a third of the prism's volume") {
  test::RandomPolygons random(4);
  for (int i = 0; i < 500; ++i) {
    const Polygon base = random.next();
    const Mesh mesh = tapered(base, 6);
    REQUIRE(mesh.faces.size() == base.points.size());
    // The base adds nothing to the volume measured from a point in its plane.
    REQUIRE(test::volume(mesh) == doctest::Approx(area(base) * 2).epsilon(1e-9));
  }
}

TEST_CASE("figures fill their rectangle") {
  for (const char* name : {"circle", "arch", "segment"}) {
    for (const auto& [width, height] : {std::pair{2.0, 3.0}, {3.0, 1.0}, {2.0, 1.0}, {1.0, 9.0}}) {
      for (const int sides : {3, 5, 7, 24}) {
        CAPTURE(name);
        CAPTURE(width);
        CAPTURE(height);
        CAPTURE(sides);
        const Polygon p = figure(name, width, height, sides);
        REQUIRE(test::well_formed(p));
        CHECK(is_convex(p));
        const Box2 box = bounds(p.points);
        CHECK(length(box.low) < 1e-9);
        CHECK(box.high.x == doctest::Approx(width));
        if (sides % 4 == 0) CHECK(box.high.y == doctest::Approx(height));
        CHECK(box.high.y <= height + 1e-9);
      }
    }
  }
  CHECK(area(figure("circle", 2, 2, 1000)) == doctest::Approx(pi).epsilon(1e-4));
  CHECK(area(figure("arch", 2, 3, 1000)) == doctest::Approx(4 + pi / 2).epsilon(1e-4));
  CHECK(figure("heart", 1, 1).empty());
  CHECK(figure("arch", 0, 1).empty());
}

TEST_CASE("L, U and O keep their wings") {
  const Polygon l = shape_l(10, 8, 3, 2);
  CHECK(area(l) == doctest::Approx(10 * 3 + 2 * 5));
  CHECK(l.points.size() == 6);
  const Polygon u = shape_u(10, 8, 3, 2, 1);
  CHECK(area(u) == doctest::Approx(30 + 3 * 5));
  CHECK(u.points.size() == 8);
  const Polygon o = shape_o(10, 8, 1, 2, 3, 4);
  CHECK(area(o) == doctest::Approx(80 - 4 * 4));
  CHECK(o.rings() == 2);
  CHECK(contains(o, {3.9, 2}));
  CHECK_FALSE(contains(o, {4.1, 1.1}));
  CHECK_FALSE(contains(o, {7.9, 4.9}));
  for (const Polygon& p : {l, u, o}) CHECK(p.points[0] == Vec2{0, 0});
}

TEST_CASE("L, U and O with wings that are missing or too deep") {
  test::RandomPolygons random(5);
  for (int i = 0; i < 700; ++i) {
    CAPTURE(i);
    const auto wing = [&] { return random.below(3) == 0 ? 0.0 : random.between(-1, 9); };
    const double a = wing(), b = wing(), c = wing(), d = wing();
    for (const Polygon& p :
         {shape_l(10, 8, a, b), shape_u(10, 8, a, b, c), shape_o(10, 8, a, b, c, d)}) {
      if (p.empty()) continue;
      REQUIRE(test::well_formed(p));
      REQUIRE(area(p) <= 80 + 1e-9);
    }
  }
  CHECK(shape_l(10, 8, 9, 2).points.size() == 4);
  CHECK(area(shape_l(10, 8, 3, 0)) == doctest::Approx(30));
  CHECK(area(shape_u(10, 8, 3, 2, 0)) == doctest::Approx(40));
  CHECK(shape_l(10, 8, 0, 0).empty());
  CHECK(shape_o(10, 0, 1, 1, 1, 1).empty());
}

}  // namespace
}  // namespace mansard
