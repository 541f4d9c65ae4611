// How far faces are covered, against sampling: 10,000 random faces and solids.
#include <doctest/doctest.h>

#include <random>

#include "geometry/box_index.hpp"
#include "geometry/close_holes.hpp"
#include "geometry/occlusion.hpp"
#include "geometry/solids.hpp"

namespace {

using namespace mansard;

class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }

 private:
  std::mt19937 engine_;
};

/// A frame turned about the vertical or, now and then, any way.
Scope random_frame(Random& random, double far) {
  Scope frame;
  const double turn = random(0, 6.3);
  frame.x = {std::cos(turn), 0, std::sin(turn)};
  frame.z = cross(frame.x, frame.y);
  if (random(0, 1) < 0.3) {  // leans
    const double lean = random(-1, 1);
    const Vec3 y = frame.y;
    frame.y = y * std::cos(lean) + frame.z * std::sin(lean);
    frame.z = cross(frame.x, frame.y);
  }
  frame.origin = {random(-far, far), random(-far, far), random(-far, far)};
  return frame;
}

Polygon random_base(Random& random) {
  const double w = random(1, 5), d = random(1, 5);
  if (random(0, 1) < 0.4) return rectangle(w, d);
  if (random(0, 1) < 0.5) return shape_l(w, d, random(0.2, 0.7) * d, random(0.2, 0.7) * w);
  return shape_o(w, d, 0.2 * d, 0.2 * w, 0.2 * d, 0.2 * w);
}

Prism random_prism(Random& random) {
  const Scope frame = random_frame(random, 3);
  return {frame.origin, frame.x, -frame.z, frame.y, random_base(random), random(1, 5)};
}

bool is_in(const Prism& prism, Vec3 p) {
  const Vec3 d = p - prism.origin;
  const double along = dot(d, prism.axis);
  return along > 0 && along < prism.height &&
         contains(prism.base, {dot(d, prism.a), dot(d, prism.b)});
}

/// Which points of a grid over the face lie in a solid, 1 mm before the face.
struct Samples {
  static constexpr int n = 30;
  std::array<std::array<bool, n>, n> in{};

  /// Some point and all its neighbours are as `covered` says: no sliver.
  bool has_patch(bool covered) const {
    for (int i = 1; i + 1 < n; ++i) {
      for (int j = 1; j + 1 < n; ++j) {
        bool all = true;
        for (int a = i - 1; a <= i + 1; ++a)
          for (int b = j - 1; b <= j + 1; ++b) all = all && in[a][b] == covered;
        if (all) return true;
      }
    }
    return false;
  }
};

Samples sampled(const Scope& face, Vec2 size, const std::vector<Prism>& solids) {
  Samples samples;
  for (int i = 0; i < Samples::n; ++i) {
    for (int j = 0; j < Samples::n; ++j) {
      const Vec3 p =
          face.at({size.x * (i + 0.5) / Samples::n, size.y * (j + 0.5) / Samples::n, 0.001});
      for (const Prism& solid : solids) samples.in[i][j] = samples.in[i][j] || is_in(solid, p);
    }
  }
  return samples;
}

struct Tally {
  std::size_t answers[3] = {0, 0, 0}, wrong = 0;

  void compare(Cover answer, const Samples& samples) {
    ++answers[static_cast<std::size_t>(answer)];
    if (answer == Cover::nothing && samples.has_patch(true)) ++wrong;
    if (answer == Cover::full && samples.has_patch(false)) ++wrong;
  }
};

/// The part that the pieces cover, by areas, where the answer says part.
double share(const Samples& samples) {
  double sum = 0;
  for (const auto& row : samples.in)
    for (const bool in : row) sum += in;
  return sum / (Samples::n * Samples::n);
}

}  // namespace

TEST_CASE("faces are covered as sampling says") {
  Random random(11);
  Tally prisms, meshes;
  std::size_t doubtful = 0;
  for (int round = 0; round < 10000; ++round) {
    const Scope face = random_frame(random, 2);
    const Vec2 size{random(0.3, 3), random(0.3, 3)};
    const Polygon outline = rectangle(size.x, size.y);
    std::vector<Prism> solids;
    for (double count = random(1, 4); count > 0; --count) solids.push_back(random_prism(random));
    std::vector<Polygon> pieces, of_meshes;
    for (const Prism& solid : solids) {
      for (Polygon& piece : section(solid, face, 0.001)) pieces.push_back(std::move(piece));
      if (round % 4 > 0) continue;
      for (Polygon& piece : section(to_mesh(solid), face, 0.001))
        of_meshes.push_back(std::move(piece));
    }
    CAPTURE(round);
    const Cover answer = covered(outline, pieces, 0.01);
    const Samples samples = sampled(face, size, solids);
    prisms.compare(answer, samples);
    const double covered_share = share(samples);
    if (answer == Cover::part && (covered_share == 0 || covered_share == 1)) ++doubtful;
    if (round % 4 == 0) {
      meshes.compare(covered(outline, of_meshes, 0.01), samples);
      CHECK(covered(outline, of_meshes, 0.01) == answer);
    }
  }
  CHECK(prisms.wrong == 0);
  CHECK(meshes.wrong == 0);
  CHECK(doubtful < 100);  // less than a sample's width is covered, or free
  for (const std::size_t count : prisms.answers) CHECK(count > 200);
}

TEST_CASE("what only touches a face's plane does not cover it") {
  Scope wall;
  wall.origin = {0, 0, 0};  // looks along z
  const Polygon outline = rectangle(4, 3);
  const auto box = [](Vec3 at, Vec3 size) {
    return Prism{{at.x, at.y, at.z + size.z}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0},
                 rectangle(size.x, size.z),   size.y};
  };
  const auto cover = [&](const Prism& solid) {
    const Cover answer = covered(outline, section(solid, wall, 0.001), 0.01);
    CHECK(covered(outline, section(to_mesh(solid), wall, 0.001), 0.01) == answer);
    return answer;
  };
  CHECK(cover(box({0, 0, -5}, {4, 3, 5})) == Cover::nothing);   // its own mass
  CHECK(cover(box({0, 0, 0}, {4, 3, 5})) == Cover::full);       // built against it
  CHECK(cover(box({4, 0, -5}, {4, 3, 10})) == Cover::nothing);  // a wing beside it
  CHECK(cover(box({3, 0, -5}, {4, 3, 10})) == Cover::part);
  CHECK(cover(box({3.995, 0, -5}, {4, 3, 10})) == Cover::nothing);  // by less than a centimetre
  CHECK(cover(box({0, 0, 0.5}, {4, 3, 5})) == Cover::nothing);      // stands before it
  CHECK(cover(box({-1, -1, -1}, {6, 6, 2})) == Cover::full);
}

TEST_CASE("what several cover together is covered") {
  const Polygon face = rectangle(4, 3);
  const auto at = [](double x, double y, double w, double h) {
    Polygon piece = rectangle(w, h);
    translate(piece, {x, y});
    return piece;
  };
  std::vector<Polygon> halves{at(-1, -1, 3, 5), at(2, -1, 3, 5)};
  CHECK(covered(face, halves, 0.01) == Cover::full);
  halves[1] = at(2.005, -1, 3, 5);  // a crack
  CHECK(covered(face, halves, 0.01) == Cover::full);
  halves[1] = at(2.1, -1, 3, 5);
  CHECK(covered(face, halves, 0.01) == Cover::part);
  Polygon triangle;
  for (const Vec2 p : {Vec2{-5, -1}, Vec2{9, -1}, Vec2{2, 20}}) triangle.add_point(p);
  triangle.close_ring();
  CHECK(covered(face, std::vector{triangle}, 0.01) == Cover::full);
  CHECK(covered(rectangle(0.005, 3), halves, 0.01) == Cover::full);  // thinner than what counts
}

TEST_CASE("a spire without its base is closed") {
  Mesh spire = tapered(rectangle(4, 4), 6);
  Scope wall;
  wall.origin = {0, 0, 2};
  CHECK(section(spire, wall, 0).empty());
  close_holes(spire);
  const std::vector<Polygon> pieces = section(spire, wall, 0);
  REQUIRE(pieces.size() == 1);
  CHECK(area(pieces[0]) == doctest::Approx(12));
}

TEST_CASE("the shadow of what stands before a face") {
  const Mesh box = to_mesh({{1, 0, 3}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}, rectangle(2, 1), 5});
  Scope wall;  // the box stands from 2 to 3 m before it
  CHECK(shadow(box, wall, 0.001, 1.9, 0).empty());
  const auto seen = shadow(box, wall, 0.001, 2.5, 0);
  REQUIRE(seen.size() == 1);
  CHECK(area(seen[0]) == doctest::Approx(10));
  const auto grown = shadow(box, wall, 0.001, 2.5, 0.5);
  REQUIRE(grown.size() == 1);
  CHECK(area(grown[0]) == doctest::Approx(18));
}

TEST_CASE("boxes are found as by looking at all") {
  Random random(5);
  BoxIndex index;
  std::vector<uint32_t> found;
  for (const std::size_t count : {0u, 1u, 4u, 5u, 37u, 1000u}) {
    std::vector<Box3> boxes;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 low{random(0, 50), random(0, 50), random(0, 5)};
      boxes.push_back({low, low + Vec3{random(0, 4), random(0, 4), random(0, 4)}});
    }
    index.build(boxes);
    for (int i = 0; i < 100; ++i) {
      const Vec3 low{random(0, 50), random(0, 50), random(0, 5)};
      const Box3 asked{low, low + Vec3{random(0, 9), random(0, 9), random(0, 9)}};
      std::vector<uint32_t> all;
      for (uint32_t b = 0; b < boxes.size(); ++b) {
        if (meet(boxes[b], asked)) all.push_back(b);
      }
      index.near(asked, found);
      CHECK(found == all);
    }
  }
}
