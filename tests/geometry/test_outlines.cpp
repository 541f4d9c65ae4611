// Solids cut by outlines: nothing sticks out, nothing is lost, and what was closed is closed.
#include <doctest/doctest.h>

#include <algorithm>

#include "geometry/clip_outline.hpp"
#include "geometry/solids.hpp"
#include "tests/geometry/random_polygons.hpp"
#include "tests/geometry/solid_checks.hpp"

using namespace mansard;
using namespace mansard::test;

namespace {

/// A box around the polygon, from z = 0.
Mesh block_over(const Polygon& outline, double depth) {
  const Box2 box = bounds(outline.points);
  const Vec2 size = box.size();
  Mesh block = prism(rectangle(size.x + 2, size.y + 2), size.y + 2, depth);
  for (Vec3& p : block.points) p = {p.x + box.low.x - 1, size.y + 1 - p.z + box.low.y, p.y};
  return block;
}

/// In the outline or nearer to it than `tolerance`.
bool is_within(const Polygon& outline, Vec2 p, double tolerance) {
  bool near = contains(outline, p);
  for_each_edge(outline, [&](uint32_t, Vec2 a, Vec2 b) {
    const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    near = near || length(p - mix(a, b, t)) <= tolerance;
  });
  return near;
}

}  // namespace

TEST_CASE("what is cut by an outline stays inside and has its volume") {
  RandomPolygons polygons(29);
  for (int i = 0; i < 200; ++i) {
    const Polygon outline = polygons.next();
    CAPTURE(i);
    const Mesh block = block_over(outline, 0.7);
    REQUIRE(is_closed(block));
    const Mesh cut = clip_by_outline(block, outline);
    CHECK(volume(cut) == doctest::Approx(area(outline) * 0.7).epsilon(1e-6));
    for (const Vec3 p : cut.points) CHECK(is_within(outline, {p.x, p.y}, 1e-6));
  }
}

TEST_CASE("a closed solid is closed after it was cut by a gable") {
  Polygon gable;
  for (const Vec2 p : {Vec2{0, 0}, {4, 0}, {4, 1}, {2, 3}, {0, 1}}) gable.add_point(p);
  gable.close_ring();
  Mesh ball = sphere({4, 3, 1}, 24);
  CHECK(is_closed(clip_by_outline(ball, gable)));
  CHECK(volume(clip_by_outline(ball, gable)) < volume(ball));
  for (Vec3& p : ball.points) p = {p.x + 9, p.y, p.z};
  CHECK(clip_by_outline(ball, gable).faces.empty());
}

TEST_CASE("a solid inside the outline stays as it is") {
  const Mesh ball = sphere({1, 1, 1}, 12);
  Polygon around = rectangle(3, 3);
  for (Vec2& p : around.points) p = p - Vec2{1, 1};
  CHECK(clip_by_outline(ball, around).points == ball.points);
}

TEST_CASE("an open cut leaves out the lid alone") {
  const Mesh ball = sphere({2, 2, 2}, 16);
  const Mesh open = clip_open(ball, {1, 0, 0}, 1.3);
  CHECK(!is_closed(open));
  CHECK(open.points == clip(ball, {1, 0, 0}, 1.3).points);
  CHECK(clip_open(ball, {1, 0, 0}, -1).faces.empty());
}
