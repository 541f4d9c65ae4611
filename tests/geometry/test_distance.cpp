// How far triangles are from each other, and what of a line a solid fills, against sampling.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "geometry/clip.hpp"
#include "geometry/occlusion.hpp"
#include "geometry/solid_mesh.hpp"
#include "geometry/solids.hpp"

namespace {

using namespace mansard;

class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  Vec3 point(double far) { return {(*this)(-far, far), (*this)(-far, far), (*this)(-far, far)}; }
  Triangle triangle(double far) {
    const Vec3 at = point(far);
    return {at, at + point(1), at + point(1)};
  }

 private:
  std::mt19937 engine_;
};

/// The least distance of points on a grid over each.
double sampled(const Triangle& a, const Triangle& b) {
  constexpr int n = 12;
  std::vector<Vec3> on_a, on_b;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      const double u = double(i) / n, v = double(j) / n;
      on_a.push_back(a[0] + (a[1] - a[0]) * u + (a[2] - a[0]) * v);
      on_b.push_back(b[0] + (b[1] - b[0]) * u + (b[2] - b[0]) * v);
    }
  }
  double least = 1e9;
  for (const Vec3 p : on_a)
    for (const Vec3 q : on_b) least = std::min(least, length(q - p));
  return least;
}

Prism random_prism(Random& random) {
  const double turn = random(0, 6.3);
  const Vec3 a{std::cos(turn), 0, std::sin(turn)}, up{0, 1, 0};
  const double w = random(1, 5), d = random(1, 5);
  const Polygon base = random(0, 1) < 0.5
                           ? rectangle(w, d)
                           : shape_l(w, d, random(0.2, 0.7) * d, random(0.2, 0.7) * w);
  return {random.point(3), a, -cross(a, up), up, base, random(1, 5)};
}

bool is_in(const Prism& prism, Vec3 p) {
  const Vec3 d = p - prism.origin;
  const double along = dot(d, prism.axis);
  return along > 0 && along < prism.height &&
         contains(prism.base, {dot(d, prism.a), dot(d, prism.b)});
}

}  // namespace

TEST_CASE("triangles are as far from each other as sampling says") {
  Random random(3);
  int crossing = 0;
  for (int round = 0; round < 2000; ++round) {
    CAPTURE(round);
    const Triangle a = random.triangle(1), b = random.triangle(1);
    const Nearest3 pair = nearest_pair(a, b);
    const double about = sampled(a, b);
    CHECK(pair.distance <= about + 1e-9);
    CHECK(about - pair.distance < 0.25);
    CHECK(length(pair.second - pair.first) == doctest::Approx(pair.distance));
    crossing += pair.distance == 0;
    const Nearest3 back = nearest_pair(b, a);
    CHECK(back.distance == doctest::Approx(pair.distance));
  }
  CHECK(crossing > 50);
}

TEST_CASE("triangles that are lines or points have distances too") {
  const Triangle flat{{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}}};
  const auto point = [](Vec3 p) { return Triangle{p, p, p}; };
  CHECK(nearest_pair(flat, point({1, 3, 1})).distance == doctest::Approx(3));
  CHECK(nearest_pair(point({-2, 0, 1}), flat).distance == doctest::Approx(2));
  CHECK(nearest_pair(flat, {{{1, -1, 1}, {1, 1, 1}, {1, 1, 1}}}).distance == 0);
  CHECK(nearest_pair(Vec2{0, 0}, Vec2{4, 0}, Vec2{2, 3}, Vec2{2, 3}).distance ==
        doctest::Approx(3));
  CHECK(nearest_pair(Vec2{0, 0}, Vec2{4, 0}, Vec2{2, 3}, Vec2{2, -3}).distance == 0);
}

TEST_CASE("the parts of a line inside a solid") {
  Random random(8);
  std::size_t wrong = 0, inside = 0;
  for (int round = 0; round < 2000; ++round) {
    const Prism prism = random_prism(random);
    SolidMesh solid(to_mesh(prism));
    const Vec3 from = random.point(6), to = random.point(6);
    const auto parts = solid.inside(from, to);
    for (int i = 0; i < 50; ++i) {
      const double at = (i + 0.5) / 50;
      const bool in = std::ranges::any_of(
          parts, [&](const auto& part) { return at > part.first && at < part.second; });
      inside += in;
      wrong += in != is_in(prism, mix(from, to, at));
    }
    wrong += solid.contains(from) != is_in(prism, from);
  }
  CHECK(wrong == 0);
  CHECK(inside > 1000);
}

TEST_CASE("a large mesh is asked through its index as if all of it were looked at") {
  Random random(4);
  const Mesh ball = sphere({4, 4, 4}, 40);
  SolidMesh solid(ball);
  REQUIRE(solid.is_large());
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    Scope frame;
    const double turn = random(0, 6.3);
    frame.x = {std::cos(turn), 0, std::sin(turn)};
    frame.z = cross(frame.x, frame.y);
    frame.origin = random.point(4) + Vec3{2, 2, 2};
    frame.size = {1, 1, 0};
    const double at = dot(frame.z, frame.origin) + 0.001;
    const Mesh part = solid.across(frame.z, at, nullptr);
    CHECK(part.faces.size() < ball.faces.size() / 3);
    const auto all = section(ball, frame, 0.001), some = section(part, frame, 0.001);
    double area_all = 0, area_some = 0;
    for (const Polygon& p : all) area_all += area(p);
    for (const Polygon& p : some) area_some += area(p);
    CHECK(area_some == doctest::Approx(area_all));
    const Triangle t = random.triangle(6);
    double least = 1e9;
    for (const Mesh::Face& face : ball.faces) {
      const auto loop = ball.loop(face);
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        const Triangle one{ball.points[loop[0]], ball.points[loop[i]], ball.points[loop[i + 1]]};
        least = std::min(least, nearest_pair(t, one).distance);
      }
    }
    const auto nearest = solid.nearest(t, 1e9);
    REQUIRE(nearest.has_value());
    CHECK(nearest->distance == doctest::Approx(least));
    CHECK(!solid.nearest(t, least / 2 - 1e-6).has_value());
  }
}

TEST_CASE("boxes along a line and across a plane are found as by looking at all") {
  Random random(6);
  std::vector<Box3> boxes;
  for (int i = 0; i < 500; ++i) {
    const Vec3 low = random.point(20);
    boxes.push_back({low, low + Vec3{random(0, 4), random(0, 4), random(0, 4)}});
  }
  BoxIndex index;
  index.build(boxes);
  std::vector<uint32_t> found;
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    const Vec3 from = random.point(25),
               to = round % 5 == 0 ? from + Vec3{0, 9, 0} : random.point(25);
    index.along(from, to, found);
    std::vector<bool> is_found(boxes.size(), false);
    for (const uint32_t i : found) is_found[i] = true;
    for (int s = 0; s <= 200; ++s) {
      const Vec3 p = mix(from, to, s / 200.0);
      for (std::size_t i = 0; i < boxes.size(); ++i)
        if (meet(boxes[i], {p, p})) CHECK(is_found[i]);
    }
    const Vec3 normal = normalized(random.point(1));
    const double at = random(-15, 15);
    index.across(normal, at, found);
    std::vector<uint32_t> all;
    for (uint32_t i = 0; i < boxes.size(); ++i) {
      bool above = false, below = false;
      for (int c = 0; c < 8; ++c) {
        const Box3& b = boxes[i];
        const Vec3 p{c & 1 ? b.high.x : b.low.x, c & 2 ? b.high.y : b.low.y,
                     c & 4 ? b.high.z : b.low.z};
        (dot(normal, p) > at ? above : below) = true;
      }
      if (above && below) all.push_back(i);
    }
    CHECK(found == all);
    const Vec3 p = random.point(30);
    double least = 1e9;
    for (const Box3& box : boxes) least = std::min(least, distance(box, {p, p}));
    const double nearest = index.nearest({p, p}, 1e9, [&](uint32_t i) {
      return distance(boxes[i], {p, p});
    });
    CHECK(nearest == least);
  }
}
