#include <doctest/doctest.h>

#include <limits>

#include "render/camera.hpp"

namespace mansard {
namespace {

/// A triangle in every corner of a box that stands on y = `floor`.
Scene corners(Vec3 size, Vec3 at = {}) {
  Scene scene;
  for (int k = 0; k < 8; ++k) {
    const Vec3 p =
        at + Vec3{(k & 1) != 0 ? size.x : 0, (k & 2) != 0 ? size.y : 0, (k & 4) != 0 ? size.z : 0};
    const double inward = (k & 1) != 0 ? -0.01 : 0.01;
    for (const Vec3 q : {p, p + Vec3{inward, 0, 0}, p + Vec3{0, (k & 2) != 0 ? -0.01 : 0.01, 0}}) {
      for (const double c : {q.x, q.y, q.z}) scene.points.push_back(static_cast<float>(c));
    }
  }
  return scene;
}

/// The place of a point on the film: x and y are within -1..1 when it is in the picture.
Vec2 seen_at(const Lens& lens, Float3 point) {
  const Float3 axis = normalized(cross(lens.up, lens.right));
  const Float3 from = point - lens.eye;
  const Float3 on_film = from * (dot(lens.forward, axis) / dot(from, axis)) - lens.forward;
  return {dot(on_film, lens.right) / dot(lens.right, lens.right),
          dot(on_film, lens.up) / dot(lens.up, lens.up)};
}

Lens aimed(const RayScene& world, Camera::View view) {
  const Tracer tracer(world);
  PictureOptions options;
  options.camera.view = view;
  return aim(world, tracer, options);
}

}  // namespace

TEST_CASE("a camera is read from text") {
  CHECK(parse_camera("iso")->view == Camera::View::iso);
  CHECK(parse_camera("street")->view == Camera::View::street);
  const auto free = parse_camera("1,2.5,-3, 4e1 ,0,6");
  REQUIRE(free);
  CHECK(free->view == Camera::View::free);
  CHECK(free->eye == Vec3{1, 2.5, -3});
  CHECK(free->target == Vec3{40, 0, 6});
}

TEST_CASE("other text is no camera") {
  for (const char* text :
       {"", "isometric", " iso", "1,2,3", "1,2,3,4,5", "1,2,3,4,5,6,7", "1,2,3,4,5,", ",1,2,3,4,5",
        "1,2,3,4,5,x", "1,2,3,4,5,6m", "1 2 3 4 5 6", "nan,2,3,4,5,6", "1,2,3,4,5,inf",
        "1,2,3,1,2,3", "1,2,3,4,5,1e999", ",,,,,"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_camera(text));
  }
}

TEST_CASE("iso and street show the whole scene, and it fills the picture") {
  const Vec3 sizes[] = {{10, 8, 8}, {3, 40, 3}, {60, 6, 12}, {8, 5, 70}, {1, 1, 1}, {150, 4, 0.02}};
  for (const Camera::View view : {Camera::View::iso, Camera::View::street}) {
    for (const Vec3 size : sizes) {
      CAPTURE(static_cast<int>(view));
      CAPTURE(size.x);
      CAPTURE(size.y);
      CAPTURE(size.z);
      const RayScene world(corners(size, {100, 7, -30}));
      const Lens lens = aimed(world, view);
      double across = 0, up = 0;
      for (const Float3 p : world.corners) {
        const Vec2 at = seen_at(lens, p);
        across = std::max(across, std::abs(at.x));
        up = std::max(up, std::abs(at.y));
        CHECK(dot(p - lens.eye, lens.forward) > 0);
      }
      CHECK(across < 0.99);
      CHECK(up < 0.99);
      CHECK(std::max(across, up) > 0.85);
    }
  }
}

TEST_CASE("from the street uprights stay upright and the eye is 1.7 m above the ground") {
  const RayScene world(corners({20, 12, 9}));
  const Lens lens = aimed(world, Camera::View::street);
  CHECK(lens.eye.y == doctest::Approx(1.7));
  CHECK(lens.right.y == doctest::Approx(0));
  CHECK(std::abs(lens.up.x) + std::abs(lens.up.z) == doctest::Approx(0));
}

TEST_CASE("in a large scene the street is found") {
  // Two rows of long blocks 12 m apart, 400 m long: the eye must stand between them and look along.
  Scene scene;
  const auto wall = [&](Vec3 a, Vec3 b) {
    const Vec3 c{b.x, 10, b.z}, d{a.x, 10, a.z};
    for (const Vec3 p : {a, b, c, a, c, d}) {
      for (const double q : {p.x, p.y, p.z}) scene.points.push_back(static_cast<float>(q));
    }
  };
  for (const double z : {-106.0, -6.0, 6.0, 106.0}) wall({-200, 0, z}, {200, 0, z});
  const Vec3 p[] = {{-200, 10, -106}, {200, 10, -106}, {200, 10, -6},  {-200, 10, -106},
                    {200, 10, -6},    {-200, 10, -6},  {-200, 10, 6},  {200, 10, 6},
                    {200, 10, 106},   {-200, 10, 6},   {200, 10, 106}, {-200, 10, 106}};
  for (const Vec3 q : p) {
    for (const double c : {q.x, q.y, q.z}) scene.points.push_back(static_cast<float>(c));
  }
  const RayScene world(scene);
  const Stand stand = find_street(world, Tracer(world));
  CHECK(std::abs(stand.eye.z) < 6);
  CHECK(std::abs(stand.direction.x) > 0.95);
}

TEST_CASE("a camera that makes no sense still gives rays") {
  const RayScene world(corners({5, 5, 5}));
  const Tracer tracer(world);
  PictureOptions options;
  options.camera.view = Camera::View::free;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vec3 eye : {Vec3{nan, 0, 0}, Vec3{1, 1, 1}, Vec3{1, 50, 1}, Vec3{1e300, 0, 0}}) {
    options.camera.eye = eye;
    options.camera.target = {1, 1, 1};
    options.camera.field_of_view = eye.x == 1 ? nan : 900;
    const Lens lens = aim(world, tracer, options);
    CHECK(is_finite(lens.eye));
    CHECK(length(lens.ray(0.5F, 0.5F)) > 0);
    CHECK(is_finite(lens.ray(0.5F, 0.5F)));
  }
}

}  // namespace mansard
