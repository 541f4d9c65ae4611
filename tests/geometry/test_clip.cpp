// Laws of cutting and triangulating, over random and real polygons.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "geometry/clip.hpp"
#include "geometry/solids.hpp"
#include "tests/geometry/random_polygons.hpp"
#include "tests/geometry/solid_checks.hpp"

namespace mansard {
namespace {

using test::RandomPolygons;
using test::total_area;
using test::well_formed;

constexpr unsigned seed = 20240517;

bool same_line(Vec2 a, Vec2 b, Vec2 p) { return std::abs(cross(normalized(b - a), p - a)) <= 1e-6; }

/// Edges lie on the edge that their tag names, or on the cut.
bool tags_fit(const Polygon& whole, const Polygon& piece, Vec2 normal, double offset) {
  bool fit = true;
  std::vector<std::pair<Vec2, Vec2>> edges;
  for_each_edge(whole, [&](uint32_t, Vec2 a, Vec2 b) { edges.push_back({a, b}); });
  for_each_edge(piece, [&](uint32_t i, Vec2 a, Vec2 b) {
    const EdgeTag tag = piece.tags[i];
    if (tag.has(EdgeTag::cut)) {
      fit = fit && std::abs(dot(normal, a) - offset) <= 1e-6;
      fit = fit && std::abs(dot(normal, b) - offset) <= 1e-6;
    } else {
      const auto [from, to] = edges.at(tag.wall);
      fit = fit && same_line(from, to, a) && same_line(from, to, b);
    }
  });
  return fit;
}

void check_cut(const Polygon& p, Vec2 normal, double offset) {
  const auto below = clip(p, normal, offset), above = clip(p, normal * -1, -offset);
  REQUIRE(well_formed(below));
  REQUIRE(well_formed(above));
  REQUIRE(total_area(below) + total_area(above) == doctest::Approx(area(p)).epsilon(1e-9));
  for (const Polygon& piece : below) {
    for (const Vec2 q : piece.points) REQUIRE(dot(normal, q) - offset <= 1e-7);
    REQUIRE(tags_fit(p, piece, normal, offset));
    REQUIRE_FALSE(test::crosses_itself(piece));
  }
}

TEST_CASE("both sides of a cut add up to the whole") {
  RandomPolygons random(seed);
  for (int i = 0; i < 4000; ++i) {
    CAPTURE(seed);
    CAPTURE(i);
    const Polygon p = random.next();
    const Vec2 normal = random.direction();
    check_cut(p, normal, random.offset(p, normal));
  }
}

TEST_CASE("cuts through real footprints") {
  RandomPolygons random(seed);
  for (const test::Named& footprint : test::simple_footprints(23)) {
    CAPTURE(footprint.name);
    const Vec2 normal = random.direction();
    check_cut(footprint.polygon, normal, random.offset(footprint.polygon, normal));
  }
}

TEST_CASE("cutting along two lines gives the same in either order") {
  RandomPolygons random(seed + 1);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const Polygon p = random.next();
    const Vec2 m = random.direction(), n = random.direction();
    const double a = random.offset(p, m), b = random.offset(p, n);
    double first = 0, second = 0;
    for (const Polygon& q : clip(p, m, a)) first += total_area(clip(q, n, b));
    for (const Polygon& q : clip(p, n, b)) second += total_area(clip(q, m, a));
    REQUIRE(first == doctest::Approx(second).epsilon(1e-9));
  }
}

TEST_CASE("strips tile the polygon and share their corners exactly") {
  RandomPolygons random(seed + 2);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const Polygon p = random.next();
    const int axis = random.below(2);
    const Box2 box = bounds(p.points);
    const double low = axis == 0 ? box.low.x : box.low.y,
                 high = axis == 0 ? box.high.x : box.high.y;
    double a = random.between(low, high), b = random.between(low, high);
    if (a > b) std::swap(a, b);
    const double cuts[] = {low, a, b, high};
    double sum = 0;
    std::map<double, std::map<double, int>> on_cut;  // how often a point comes on each cut
    for (int s = 0; s < 3; ++s) {
      const auto strip = clip_strip(p, axis, cuts[s], cuts[s + 1]);
      REQUIRE(well_formed(strip));
      sum += total_area(strip);
      for (const Polygon& piece : strip) {
        for (const Vec2 q : piece.points) {
          const double at = axis == 0 ? q.x : q.y;
          REQUIRE(at >= cuts[s]);
          REQUIRE(at <= cuts[s + 1]);
          if (s == 0 && at == a) ++on_cut[a][axis == 0 ? q.y : q.x];
          if (s == 1 && at == a) --on_cut[a][axis == 0 ? q.y : q.x];
          if (s == 1 && at == b) ++on_cut[b][axis == 0 ? q.y : q.x];
          if (s == 2 && at == b) --on_cut[b][axis == 0 ? q.y : q.x];
        }
      }
    }
    REQUIRE(sum == doctest::Approx(area(p)).epsilon(1e-9));
    for (const auto& [cut, points] : on_cut) {
      for (const auto& [place, balance] : points) {
        // A corner that touches the cut from one side only is no corner of the other side.
        const Vec2 point = axis == 0 ? Vec2{cut, place} : Vec2{place, cut};
        const bool corner = std::any_of(p.points.begin(), p.points.end(),
                                        [&](Vec2 q) { return length(q - point) < 1e-8; });
        REQUIRE((balance == 0 || corner));
      }
    }
  }
}

TEST_CASE("a cut along an edge, through a hole's edge and past a touching corner") {
  Polygon p = rectangle(6, 6);
  for (const Vec2 q : {Vec2{2, 2}, {2, 4}, {4, 4}, {4, 2}}) p.add_point(q);
  p.close_ring();
  // Through the lower side of the hole: one rectangle.
  const auto below = clip(p, {0, 1}, 2);
  REQUIRE(below.size() == 1);
  CHECK(below[0].rings() == 1);
  CHECK(area(below[0]) == doctest::Approx(12));
  // Through its upper side: a U.
  const auto lower = clip(p, {0, 1}, 4);
  REQUIRE(lower.size() == 1);
  CHECK(lower[0].rings() == 1);
  CHECK(lower[0].points.size() == 8);
  // Through the middle: two pieces on the sides of the hole join below it.
  CHECK(clip(p, {0, 1}, 3).size() == 1);
  CHECK(clip(p, {1, 0}, 6).size() == 1);
  CHECK(clip(p, {1, 0}, 0).empty());
  CHECK(clip(p, {1, 0}, -1).empty());
  CHECK(clip(p, {1, 0}, 6)[0].points == p.points);

  Polygon diamond_hole = rectangle(6, 6);
  for (const Vec2 q : {Vec2{3, 1}, {1, 3}, {3, 5}, {5, 3}}) diamond_hole.add_point(q);
  diamond_hole.close_ring();
  const auto touched = clip(diamond_hole, {0, 1}, 5);
  REQUIRE(touched.size() == 1);
  CHECK(touched[0].rings() == 2);
  CHECK(area(touched[0]) == doctest::Approx(22));
  CHECK(clip(diamond_hole, {0, 1}, 3).size() == 1);
  CHECK(clip(diamond_hole, {0, 1}, 1).size() == 1);
}

TEST_CASE("the edge on a cut keeps its tag") {
  Polygon p;  // an L whose step lies on v = 2
  for (const Vec2 q : {Vec2{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}) {
    p.add_point(q, {0, static_cast<uint16_t>(p.points.size())});
  }
  p.close_ring();
  const auto below = clip(p, {0, 1}, 2);
  REQUIRE(below.size() == 1);
  std::map<uint16_t, double> lengths;
  for_each_edge(below[0], [&](uint32_t i, Vec2 a, Vec2 b) {
    lengths[below[0].tags[i].wall] += length(b - a);
  });
  CHECK(lengths[2] == doctest::Approx(2));
  CHECK(lengths[EdgeTag::no_wall] == doctest::Approx(2));
}

TEST_CASE("intersection and difference add up") {
  RandomPolygons random(seed + 3);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const Polygon a = random.next();
    Polygon b = random.next();
    const Box2 box = bounds(a.points), other = bounds(b.points);
    translate(b, box.low - other.low + Vec2{double(random.below(4)), random.between(0, 3)});
    const auto common = intersection(a, b), rest = difference(a, b);
    REQUIRE(well_formed(common));
    REQUIRE(well_formed(rest));
    REQUIRE(total_area(common) + total_area(rest) == doctest::Approx(area(a)).epsilon(1e-7));
    for (const Polygon& piece : rest) {
      for_each_edge(piece, [&](uint32_t e, Vec2 from, Vec2 to) {
        const EdgeTag tag = piece.tags[e];
        REQUIRE(tag.wall != EdgeTag::no_wall);
        const Polygon& source = tag.has(EdgeTag::cut) ? b : a;
        for_each_edge(source, [&](uint32_t s, Vec2 p, Vec2 q) {
          if (s == tag.wall) REQUIRE((same_line(p, q, from) && same_line(p, q, to)));
        });
      });
    }
  }
}

void check_triangles(const Polygon& p) {
  const auto triangles = triangulate(p);
  REQUIRE(triangles.size() % 3 == 0);
  double sum = 0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const Vec2 a = p.points.at(triangles[i]), b = p.points.at(triangles[i + 1]);
    const Vec2 c = p.points.at(triangles[i + 2]);
    const double twice = cross(b - a, c - a);
    REQUIRE(twice > 0);
    sum += twice / 2;
  }
  REQUIRE(sum == doctest::Approx(area(p)).epsilon(1e-9));
}

TEST_CASE("triangles cover the polygon") {
  RandomPolygons random(seed + 4);
  for (int i = 0; i < 4000; ++i) {
    CAPTURE(i);
    check_triangles(random.next());
  }
}

TEST_CASE("triangles cover real footprints") {
  for (const test::Named& footprint : test::simple_footprints(11)) {
    CAPTURE(footprint.name);
    check_triangles(footprint.polygon);
  }
}

TEST_CASE("a star of a thousand corners is triangulated") {
  Polygon p;
  std::mt19937 random(seed);
  for (int i = 0; i < 1000; ++i) {
    const double angle = i * 2 * std::numbers::pi / 1000;
    const double radius = 5 + static_cast<double>(random() % 1000) / 100;
    p.add_point({radius * std::cos(angle), radius * std::sin(angle)});
  }
  p.close_ring();
  check_triangles(p);
}

TEST_CASE("loops in space are triangulated in their own plane") {
  RandomPolygons random(seed + 5);
  for (int i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const Polygon p = random.next();
    const Vec3 x = normalized({random.between(-1, 1), random.between(-1, 1), 0.3});
    const Vec3 y = normalized(cross(Vec3{random.between(-1, 1), 1, 0.1}, x));
    std::vector<Vec3> loop;
    for (const Vec2 q : p.ring(0)) loop.push_back(x * q.x + y * q.y);
    const auto triangles = triangulate(loop);
    const Vec3 normal = normalized(newell(loop));
    double sum = 0;
    for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
      const Vec3 a = loop[triangles[t]], b = loop[triangles[t + 1]], c = loop[triangles[t + 2]];
      const double twice = dot(cross(b - a, c - a), normal);
      REQUIRE(twice > 0);
      sum += twice / 2;
    }
    REQUIRE(sum == doctest::Approx(area(p.ring(0))).epsilon(1e-9));
  }
  const Vec3 dart[] = {{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}};
  CHECK(triangulate(dart) == std::vector<uint32_t>{0, 1, 2, 0, 2, 3});
  const Vec3 turned_dart[] = {{2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}, {0, 0, 0}};
  CHECK(triangulate(turned_dart) == std::vector<uint32_t>{0, 1, 3, 1, 2, 3});
}

TEST_CASE("both parts of a cut solid are closed and add up") {
  RandomPolygons random(seed + 6);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const Polygon base = random.next();
    const Mesh solid = prism(base, 7, 5);
    REQUIRE(test::is_closed(solid));
    Vec3 normal = normalized({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
    if (random.below(2) == 0) {
      const Vec2 flat = random.direction();
      normal = random.below(3) == 0 ? Vec3{0, 1, 0} : Vec3{flat.x, 0, flat.y};
    }
    const Vec3 through = solid.points[random.below(static_cast<int>(solid.points.size()))];
    const double offset = dot(normal, through + Vec3{0, random.below(2) * 2.0, 0});
    const Mesh below = clip(solid, normal, offset), above = clip(solid, -normal, -offset);
    REQUIRE(test::is_closed(below));
    REQUIRE(test::is_closed(above));
    REQUIRE(test::volume(below) + test::volume(above) ==
            doctest::Approx(area(base) * 5).epsilon(1e-9));
    REQUIRE(test::volume(below) >= 0);
  }
}

TEST_CASE("a cut keeps uvs, tags and materials, and leaves open solids open") {
  Mesh box = prism(rectangle(2, 2), 2, 2);
  for (const Mesh::Face& face : box.faces) {
    for (const uint32_t c : box.loop(face)) {
      box.uvs.push_back({box.points[c].y * 10, static_cast<double>(face.material)});
    }
  }
  box.materials.resize(1);
  const Mesh half = clip(box, {0, 1, 0}, 0.5);
  REQUIRE(half.uvs.size() == half.corners.size());
  CHECK(half.materials.size() == 1);
  int caps = 0;
  for (const Mesh::Face& face : half.faces) {
    caps += face.tag.has(EdgeTag::cut);
    for (uint32_t c = face.begin; c < face.end && !face.tag.has(EdgeTag::cut); ++c) {
      CHECK(half.uvs[c].x == doctest::Approx(half.points[half.corners[c]].y * 10));
    }
  }
  CHECK(caps == 1);

  const Mesh tent = tapered(rectangle(2, 2), 2);
  CHECK_FALSE(test::is_closed(tent));
  const Mesh lower = clip(tent, {0, 1, 0}, 1);
  caps = 0;
  for (const Mesh::Face& face : lower.faces) caps += face.tag.has(EdgeTag::cut);
  CHECK(caps == 1);  // the top; the base stays open
  CHECK(lower.faces.size() == 5);
  const Mesh side = clip(tent, {1, 0, 0}, 1);
  for (const Mesh::Face& face : side.faces) CHECK_FALSE(face.tag.has(EdgeTag::cut));
  CHECK(clip(tent, {0, 1, 0}, -1).faces.empty());
}

}  // namespace
}  // namespace mansard
