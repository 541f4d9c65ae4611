// Stains below sills and ledges: where they lie, where they end.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/random.hpp"
#include "geometry/stain_atlas.hpp"
#include "geometry/streaks.hpp"

using namespace mansard;

namespace {

/// Walls that look along z, `z` metres before the plane through the origin.
struct Facade {
  Surface surface;

  void add(double left, double bottom, double right, double top, double z = 0) {
    polygon({{left, bottom}, {right, bottom}, {right, top}, {left, top}}, z);
  }
  void polygon(const std::vector<Vec2>& loop, double z = 0) {
    for (const Vec2 p : loop) surface.points.push_back({p.x, p.y, z});
    surface.uvs.resize(surface.points.size());
    surface.ends.push_back(static_cast<uint32_t>(surface.points.size()));
    surface.normals.push_back({0, 0, 1});
    surface.runs = {{0, 0, static_cast<uint32_t>(surface.polygons())}};
  }
};

Drip sill(double left, double right, double bottom, uint64_t seed = 1) {
  return {{left, bottom, 0}, {right, bottom, 0}, {0, 0, 1}, bottom + 0.1, 0.06, 0.5, seed};
}

struct Stain {
  Box3 box;
  double area;
};

std::vector<Stain> stains(Facade& facade, const std::vector<Drip>& drips) {
  const auto first = static_cast<uint32_t>(facade.surface.polygons());
  std::vector<uint32_t> walls(first);
  std::iota(walls.begin(), walls.end(), 0);
  const Surface before = facade.surface;
  add_streaks(facade.surface, drips, walls, 7, 9);
  const Surface& s = facade.surface;
  CHECK(s.uvs.size() == s.points.size());
  CHECK(s.normals.size() == s.polygons());
  CHECK(std::equal(before.points.begin(), before.points.end(), s.points.begin()));
  std::vector<Stain> found;
  for (uint32_t i = first; i < s.polygons(); ++i) {
    const Vec3 area = newell(s.loop(i)) * 0.5;
    CHECK(area.z > 0);  // seen from outside
    found.push_back({bounds(s.loop(i)), area.z});
  }
  if (!found.empty()) {
    REQUIRE(s.runs.size() == 2);
    CHECK(s.runs[1].symbol == 7);
    CHECK(s.runs[1].material == 9);
    CHECK(s.runs[1].end == s.polygons());
  }
  return found;
}

double area_of(const std::vector<Stain>& all) {
  double sum = 0;
  for (const Stain& s : all) sum += s.area;
  return sum;
}

}  // namespace

TEST_CASE("a stain hangs below its sill, a hair before the wall") {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    CAPTURE(seed);
    Facade facade;
    facade.add(-5, 0, 5, 6);
    const auto found = stains(facade, {sill(-0.5, 0.5, 4, seed)});
    REQUIRE(found.size() == 1);
    const Box3 box = found[0].box;
    CHECK(box.high.y == doctest::Approx(4));
    CHECK(box.low.y < 3.4);
    CHECK(box.low.y > 1);
    CHECK(box.low.x < -0.5);
    CHECK(box.low.x > -0.8);
    CHECK(box.high.x + box.low.x == doctest::Approx(0));
    CHECK(box.low.z == doctest::Approx(stain_gap));
    CHECK(box.high.z == doctest::Approx(stain_gap));
    // All of one cell of the atlas, the stain's upper side up.
    const Surface& s = facade.surface;
    double low_u = 9, high_u = -9, low_v = 9, high_v = -9;
    for (uint32_t i = s.begin(1); i < s.ends[1]; ++i) {
      low_u = std::min(low_u, s.uvs[i].x);
      high_u = std::max(high_u, s.uvs[i].x);
      low_v = std::min(low_v, s.uvs[i].y);
      high_v = std::max(high_v, s.uvs[i].y);
      const bool is_top = s.points[i].y > 3.9;
      CHECK((std::fmod(s.uvs[i].y * StainAtlas::strengths, 1) > 0.5) == is_top);
    }
    CHECK(std::floor(low_u * 4) == std::floor(high_u * 4));
    CHECK(std::floor(low_v * 4) == std::floor(high_v * 4));
    CHECK(high_u - low_u == doctest::Approx(127.0 / StainAtlas::width));
    CHECK(high_v - low_v == doctest::Approx(255.0 / StainAtlas::height));
  }
}

TEST_CASE("a stain ends where its wall ends") {
  Facade facade;
  facade.add(-5, 3.5, 5, 6);  // a window band below
  facade.add(-5, 0, 5, 2.5);
  const auto found = stains(facade, {sill(-0.5, 0.5, 4)});
  REQUIRE(found.size() == 1);
  CHECK(found[0].box.low.y == doctest::Approx(3.5));
}

TEST_CASE("a stain runs on over faces that splits left, around an opening") {
  Facade facade;
  facade.add(-5, 3.8, 5, 6);
  facade.add(-5, 2, -0.2, 3.8);  // a narrow opening in the middle
  facade.add(0.2, 2, 5, 3.8);
  const auto found = stains(facade, {sill(-0.5, 0.5, 4)});
  REQUIRE(found.size() == 3);
  CHECK(found[0].box.high.x == doctest::Approx(-0.2));
  CHECK(found[1].box.low.y == doctest::Approx(3.8));
  CHECK(found[1].box.low.x == doctest::Approx(-0.2));
  CHECK(found[1].box.high.x == doctest::Approx(0.2));
  CHECK(found[2].box.low.x == doctest::Approx(0.2));
  CHECK(found[0].box.low.y < 3.5);
}

TEST_CASE("the same stain whether the wall is whole or split") {
  for (uint64_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    Facade whole, split;
    whole.add(-6, 0, 6, 7);
    for (int x = -6; x < 6; x += 1) {
      for (int y = 0; y < 7; ++y) split.add(x, y, x + 1, y + 1);
    }
    const std::vector<Drip> drips{sill(-5, 5, 5, seed), sill(-0.7, 0.3, 3, seed + 100)};
    const auto one = stains(whole, drips), many = stains(split, drips);
    CHECK(one.size() == many.size());
    CHECK(area_of(one) == doctest::Approx(area_of(many)));
  }
}

TEST_CASE("stains stay inside faces of any outline") {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    auto draw = [seed, n = uint64_t{0}](double low, double high) mutable {
      return low + (high - low) * unit_interval(mix(seed, n++));
    };
    std::vector<Vec2> loop;  // a star about (0, 3)
    for (int i = 0; i < 9; ++i) {
      const double angle = 2 * 3.14159265358979 * i / 9, radius = draw(0.6, 2.5);
      loop.push_back({radius * std::cos(angle), 3 + radius * std::sin(angle)});
    }
    Facade facade;
    facade.polygon(loop);
    const auto found = stains(facade, {sill(-1.5, 1.5, 3, seed)});
    CHECK_FALSE(found.empty());
    const Surface& s = facade.surface;
    for (uint32_t i = s.ends[0]; i < s.points.size(); ++i) {
      const Vec2 p{s.points[i].x, s.points[i].y};
      bool inside = false;
      double nearest = 9;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2 a = loop[k], b = loop[(k + 1) % loop.size()], along = b - a;
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + along.x * (p.y - a.y) / along.y)
          inside = !inside;
        const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
        nearest = std::min(nearest, length(p - mix(a, b, t)));
      }
      CHECK((inside || nearest < 1e-6));
    }
  }
}

TEST_CASE("a ledge below ends a stain, and has its own") {
  Facade facade;
  facade.add(-5, 0, 5, 6);
  const auto found = stains(facade, {sill(-0.5, 0.5, 4), sill(-5, 5, 3.2)});
  REQUIRE(found.size() > 4);  // a long ledge has several side by side
  CHECK(found[0].box.low.y == doctest::Approx(3.3));
  double at = -5;
  for (std::size_t i = 1; i < found.size(); ++i) {
    CHECK(found[i].box.high.y == doctest::Approx(3.2));
    CHECK(found[i].box.low.x == doctest::Approx(at));
    at = found[i].box.high.x;
  }
  CHECK(at == doctest::Approx(5));
}

TEST_CASE("only walls just behind the front of a ledge are stained, whichever way they look") {
  for (const double angle : {0.0, 0.5, 2.1}) {
    const auto turned = [&](Vec3 v) {
      return Vec3{std::cos(angle) * v.x + std::sin(angle) * v.z, v.y,
                  std::cos(angle) * v.z - std::sin(angle) * v.x};
    };
    const auto stained_at = [&](double z) {
      Facade facade;
      facade.add(-5, 0, 5, 6, z);
      for (Vec3& p : facade.surface.points) p = turned(p);
      facade.surface.normals[0] = turned({0, 0, 1});
      Drip drip = sill(-0.5, 0.5, 4);
      drip.from = turned(drip.from);
      drip.to = turned(drip.to);
      drip.out = turned(drip.out);
      add_streaks(facade.surface, std::array{drip}, std::array{0u}, 7, 9);
      return facade.surface.polygons() == 2;
    };
    CAPTURE(angle);
    CHECK(stained_at(0));
    CHECK(stained_at(0.06));  // a sill that begins behind its wall
    CHECK(stained_at(-0.3));  // a cornice
    CHECK_FALSE(stained_at(-0.5));
    CHECK_FALSE(stained_at(0.2));
  }
}

TEST_CASE("where nothing hangs below a drip nothing is drawn") {
  Facade facade;
  facade.add(-5, 4.5, 5, 6);
  facade.add(-5, 0, 5, 3.5);
  CHECK(stains(facade, {sill(-0.5, 0.5, 4), sill(-0.05, 0.05, 2), sill(-20, -10, 2)}).empty());
  Drip off = sill(-0.5, 0.5, 2);
  off.rate = 0;
  Drip back = sill(-0.5, 0.5, 2);
  back.out = {0, 0, -1};
  CHECK(stains(facade, {off, back}).empty());
  CHECK(stains(facade, {}).empty());
}

TEST_CASE("a higher rate stains darker and further") {
  double area = 0, row = -1;
  for (const double rate : {0.1, 0.4, 0.7, 1.0}) {
    double areas = 0, rows = 0;
    for (uint64_t seed = 0; seed < 60; ++seed) {
      Facade facade;
      facade.add(-5, 0, 5, 9);
      Drip drip = sill(-0.5, 0.5, 8, seed);
      drip.rate = rate;
      areas += area_of(stains(facade, {drip}));
      rows += std::floor((1 - facade.surface.uvs.back().y) * StainAtlas::strengths);
    }
    CHECK(areas > area);
    CHECK(rows > row);
    area = areas;
    row = rows;
  }
  CHECK(row > 2.8 * 60);
}
