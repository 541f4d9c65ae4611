// Laws of roofs, over random and real footprints.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <sstream>
#include <tuple>

#include "geometry/clean.hpp"
#include "geometry/roof.hpp"
#include "tests/geometry/roof_input.hpp"

namespace mansard {
namespace {

using test::Named;

Vec3 area_vector(const std::vector<Vec3>& loop) {
  Vec3 sum;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    sum = sum + cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]) * 0.5;
  }
  return sum;
}

Vec3 area_vector(const RoofFace& face) {
  Vec3 sum = area_vector(face.loop);
  for (const auto& hole : face.holes) sum = sum + area_vector(hole);
  return sum;
}

double distance_to_outline(const Polygon& polygon, Vec2 p) {
  double nearest = 1e300;
  for_each_edge(polygon, [&](uint32_t, Vec2 a, Vec2 b) {
    const Vec2 d = b - a;
    const double t = std::clamp(dot(p - a, d) / std::max(dot(d, d), 1e-30), 0.0, 1.0);
    nearest = std::min(nearest, length(p - mix(a, b, t)));
  });
  return nearest;
}

// Faces are finite, planar, not empty, and look where they should.
std::string broken_face(const Roof& roof, double flatness) {
  for (const RoofFace& face : roof.faces) {
    for (const Vec3 p : face.loop) {
      if (!std::isfinite(p.x + p.y + p.z)) return "a point is not finite";
    }
    const Vec3 vector = area_vector(face), normal = normalized(vector);
    if (face.loop.size() < 3 || !(length(vector) > 1e-12)) return "a face without area";
    for (const Vec3 p : face.loop) {
      if (std::abs(dot(p - face.loop[0], normal)) > flatness) return "a face is not planar";
    }
    if (face.part == RoofPart::slope && normal.z <= 0) return "a slope looks down";
    if (face.part == RoofPart::soffit && normal.z >= 0) return "a soffit looks up";
    if (face.part == RoofPart::top && normal.z < 0.999) return "a top is not level";
    if (face.part == RoofPart::gable && std::abs(normal.z) > 1e-4) return "a gable is not upright";
    const bool level = normal.z > 1 - 1e-6;  // the upper side of a cornice
    if (face.part == RoofPart::fascia && std::abs(normal.z) > 1e-6 && !level) {
      return "a fascia is neither upright nor level";
    }
  }
  return {};
}

// Edges without an opposite one, which must be those that stand on the walls.
std::string open_edge(const Roof& roof, const Polygon& polygon, double tolerance) {
  using Key = std::tuple<double, double, double, double, double, double>;
  std::map<Key, int> count;
  const auto add = [&](const std::vector<Vec3>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 a = loop[i] + Vec3{}, b = loop[(i + 1) % loop.size()] + Vec3{};
      auto opposite = count.find({b.x, b.y, b.z, a.x, a.y, a.z});
      if (opposite == count.end()) {
        ++count[{a.x, a.y, a.z, b.x, b.y, b.z}];
      } else if (--opposite->second == 0) {
        count.erase(opposite);
      }
    }
  };
  for (const RoofFace& face : roof.faces) {
    add(face.loop);
    for (const auto& hole : face.holes) add(hole);
  }
  double around = 0;
  for (const auto& [key, n] : count) {
    const auto [ax, ay, az, bx, by, bz] = key;
    if (az != 0 || bz != 0 || n != 1) return "an edge is open above the walls";
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {
      if (distance_to_outline(polygon, mix(Vec2{ax, ay}, Vec2{bx, by}, t)) > tolerance) {
        return "an edge at the foot misses the walls";
      }
    }
    around += length(Vec2{bx - ax, by - ay});
  }
  const auto cleaned = clean(polygon, {});  // without spikes, which sloped roofs lose
  double error = std::abs(around - perimeter(polygon));
  if (cleaned && cleaned->moved) return {};  // rings may share edges
  if (cleaned) error = std::min(error, std::abs(around - perimeter(cleaned->polygon)));
  if (error > 10 * tolerance * static_cast<double>(polygon.points.size())) {
    return "the foot does not go around the walls";
  }
  return {};
}

std::string wrong_pitch(const Roof& roof, double pitch) {
  const double rise = std::tan(pitch * std::numbers::pi / 180);
  for (const RoofFace& face : roof.faces) {
    const bool ledge = normalized(area_vector(face)).z > 1 - 1e-9;
    if (face.part != RoofPart::slope || ledge) continue;
    const Vec3 a = face.loop[0], b = face.loop[1];
    const Vec2 inwards = left_of(normalized(Vec2{b.x - a.x, b.y - a.y}));
    for (const Vec3 p : face.loop) {
      const double t = dot(Vec2{p.x - a.x, p.y - a.y}, inwards);
      if (a.z == b.z && std::abs(p.z - a.z - rise * t) > 1e-3 * rise) return "a wrong pitch";
    }
  }
  return {};
}

double tolerance_of(const Roof& roof) {
  return std::array{1e-3, 0.06, 0.5}[static_cast<std::size_t>(std::min(roof.fallback, 3)) - 1];
}

bool one_pitch(RoofKind kind) {
  return kind == RoofKind::hip || kind == RoofKind::gable || kind == RoofKind::half_hip ||
         kind == RoofKind::dutch_hip;
}

// The first law that the roof breaks, or nothing.
std::string broken_law(const Polygon& polygon, const RoofOptions& options, double flatness) {
  const Roof made = roof(polygon, options);
  if (made.fallback >= 5 || !clean(polygon, {})) return {};
  const double tolerance = tolerance_of(made), whole = area(polygon);
  if (std::string why = broken_face(made, flatness); !why.empty()) return why;
  if (std::string why = open_edge(made, polygon, tolerance); !why.empty()) return why;
  if (one_pitch(options.kind) && options.height == 0) {
    if (std::string why = wrong_pitch(made, options.pitch); !why.empty()) return why;
  }
  Vec3 sum;
  for (const RoofFace& face : made.faces) sum = sum + area_vector(face);
  if (length(sum - Vec3{0, 0, whole}) > 1e-6 * whole + tolerance * perimeter(polygon)) {
    return "the roof does not cover the footprint";
  }
  return {};
}

constexpr std::array kinds{RoofKind::hip,      RoofKind::gable,       RoofKind::flat,
                           RoofKind::half_hip, RoofKind::dutch_hip,   RoofKind::pyramid,
                           RoofKind::shed,     RoofKind::mansard,     RoofKind::gambrel,
                           RoofKind::saltbox,  RoofKind::cross_gable, RoofKind::sawtooth,
                           RoofKind::barrel};

// Every kind without and with an overhang; some by height, some with verges of their own.
std::vector<RoofOptions> all_kinds() {
  std::vector<RoofOptions> all;
  for (const RoofKind kind : kinds) {
    for (const double overhang : {0.0, 0.4}) {
      RoofOptions options;
      options.kind = kind;
      options.overhang = overhang;
      if (one_pitch(kind)) options.pitch = 40;
      if (kind == RoofKind::flat && overhang > 0) options.parapet = 0.8;
      if (kind == RoofKind::gable && overhang == 0) options.height = 3;
      if (kind == RoofKind::half_hip) options.verge = 0.1;
      all.push_back(options);
    }
  }
  return all;
}

std::string text_of(const Polygon& polygon) {
  std::ostringstream out;
  out.precision(17);
  for (const Vec2 p : polygon.points) out << p.x << ' ' << p.y << ", ";
  return out.str();
}

TEST_CASE("roofs over random footprints obey every law") {
  constexpr unsigned seed = 7;
  CAPTURE(seed);
  test::RandomFootprints footprints(seed);
  for (int i = 0; i < 600; ++i) {
    const Polygon polygon = footprints.next();
    for (const RoofOptions& options : all_kinds()) {
      const std::string why = broken_law(polygon, options, 1e-7);
      if (!why.empty()) {
        CAPTURE(text_of(polygon));
        CAPTURE(static_cast<int>(options.kind));
        CAPTURE(options.overhang);
        FAIL_CHECK(why << " at number " << i);
      }
    }
    CHECK(roof(polygon, {}).fallback == 1);
  }
}

double highest(const Roof& roof) {
  double up = 0;
  for (const RoofFace& face : roof.faces) {
    for (const Vec3 p : face.loop) up = std::max(up, p.z);
  }
  return up;
}

int count(const Roof& roof, RoofPart part) {
  return static_cast<int>(std::count_if(roof.faces.begin(), roof.faces.end(),
                                        [&](const RoofFace& f) { return f.part == part; }));
}

TEST_CASE("a gable roof's ridge is as high over a rectangle as half its width says") {
  const Polygon house = rectangle(8, 12);
  RoofOptions options;
  options.kind = RoofKind::gable;
  options.pitch = 45;
  const Roof made = roof(house, options);
  CHECK(count(made, RoofPart::gable) == 2);
  CHECK(count(made, RoofPart::slope) == 2);
  CHECK(made.faces[0].part == RoofPart::gable);  // in the order of the edges
  CHECK(made.faces[1].part == RoofPart::slope);
  CHECK(highest(made) == doctest::Approx(4));
  options.height = 2.5;
  CHECK(highest(roof(house, options)) == doctest::Approx(2.5));
}

TEST_CASE("gables stand only where they may") {
  Polygon house = rectangle(8, 12);
  RoofOptions options;
  options.kind = RoofKind::gable;
  options.pitch = 45;
  options.gables = {0, 0, 1, 0};
  CHECK(count(roof(house, options), RoofPart::gable) == 1);
  CHECK(count(roof(house, options), RoofPart::slope) == 3);
  options.gables = {0, 1, 0, 1};  // the long sides: the ridge turns
  CHECK(highest(roof(house, options)) == doctest::Approx(6));
  options.gables = {0, 0, 0, 0};
  CHECK(count(roof(house, options), RoofPart::slope) == 4);
}

TEST_CASE("a square and the wings of a T get gables") {
  RoofOptions options;
  options.kind = RoofKind::gable;
  CHECK(count(roof(rectangle(9, 9), options), RoofPart::gable) == 2);
  Polygon t;
  for (const Vec2 p : {Vec2{0, 0}, Vec2{15, 0}, Vec2{15, 6}, Vec2{10, 6}, Vec2{10, 12}, Vec2{5, 12},
                       Vec2{5, 6}, Vec2{0, 6}}) {
    t.add_point(p);
  }
  t.close_ring();
  CHECK(count(roof(t, options), RoofPart::gable) == 3);
}

TEST_CASE("a gable over a party wall ends flush with it") {
  Polygon house = rectangle(8, 12);
  house.tags[2].flags = EdgeTag::party;
  RoofOptions options;
  options.kind = RoofKind::gable;
  options.overhang = 0.5;
  Vec3 sum;
  double depth = 0;
  for (const RoofFace& face : roof(house, options).faces) {
    sum = sum + area_vector(face);
    for (const Vec3 p : face.loop) depth = std::max(depth, p.y);
  }
  CHECK(depth == doctest::Approx(12));
  CHECK(length(sum - Vec3{0, 0, 96}) < 1e-9);  // closed but for the footprint
}

TEST_CASE("what has no inside gets a flat roof or none, and no crash") {
  Polygon crossing;
  for (const Vec2 p : {Vec2{0, 0}, Vec2{10, 10}, Vec2{10, 0}, Vec2{0, 9}}) crossing.add_point(p);
  crossing.close_ring();
  CHECK(roof(crossing, {}).fallback == 6);
  CHECK(roof(Polygon{}, {}).faces.empty());
  Polygon point;
  point.add_point({1, 1});
  point.close_ring();
  CHECK(roof(point, {}).faces.empty());
  Polygon nan = rectangle(3, 4);
  nan.points[2].x = std::nan("");
  CHECK(roof(nan, {}).faces.empty());
  Polygon huge = rectangle(1e9, 1e9);
  CHECK(roof(huge, {}).faces.size() == 4);
}

TEST_CASE("rings that touch are moved apart, and what pinches itself too") {
  for (const char* wkt : {
           "POLYGON((0 0,20 0,20 14,0 14),(0 5,6 8,6 4))",                  // on an edge
           "POLYGON((0 0,20 0,20 14,0 14),(20 14,14 8,16 6))",              // at a corner
           "POLYGON((0 0,20 0,20 14,0 14),(4 4,4 8,9 6),(9 6,14 9,13 4))",  // two holes
           "POLYGON((0 0,10 0,10 6,20 0,20 12,10 6,10 12,0 12))",           // from outside
       }) {
    CAPTURE(wkt);
    const Polygon polygon = test::polygon_of_wkt(wkt);
    RoofOptions options;
    options.pitch = 40;
    CHECK(roof(polygon, options).fallback <= 3);
    CHECK(broken_law(polygon, options, 1e-6) == "");
  }
}

TEST_CASE("a parapet stands flush with the facade and inside it") {
  RoofOptions options;
  options.kind = RoofKind::flat;
  options.parapet = 1;
  const Roof made = roof(rectangle(8, 12), options);
  CHECK(count(made, RoofPart::parapet) == 12);
  double caps = 0;
  for (const RoofFace& face : made.faces) {
    for (const Vec3 p : face.loop) CHECK((p.x >= 0 && p.x <= 8 && p.y >= 0 && p.y <= 12));
    if (face.part == RoofPart::parapet) caps += area_vector(face).z;
    if (face.part == RoofPart::top) CHECK(area_vector(face).z == doctest::Approx(7.5 * 11.5));
  }
  CHECK(caps == doctest::Approx(8 * 12 - 7.5 * 11.5));
}

TEST_CASE("every edge has its face in a skeleton, but those that were merged") {
  Polygon house = rectangle(8, 4);
  house.points.insert(house.points.begin() + 1, {3, 0});
  house.tags.emplace_back();
  house.ring_ends[0] = 5;
  const auto skeleton = straight_skeleton(house);
  REQUIRE(skeleton);
  CHECK(skeleton->faces[0].empty());
  CHECK(skeleton->faces[1].size() == 4);  // 5 m of 8
  CHECK(skeleton->faces[2].size() == 3);
}

TEST_CASE("roofs over real footprints obey every law") {
  const bool all = std::getenv("MANSARD_LONG_TESTS") != nullptr;
  const std::vector<Named> footprints = test::real_footprints(all ? 1 : 150);
  if (footprints.empty()) MESSAGE("no real footprints beside the project: skipped");
  std::map<std::string, int> broken;
  std::map<int, int> fallbacks;
  double slowest = 0;
  const auto clock = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const double begin = clock();
  for (const Named& named : footprints) {
    for (const RoofOptions& options : all_kinds()) {
      const std::string why = broken_law(named.polygon, options, 1e-3);
      const std::string which = why + ", kind " + std::to_string(static_cast<int>(options.kind));
      if (!why.empty() && ++broken[which] < 4) {
        MESSAGE(named.name << " kind " << static_cast<int>(options.kind) << " overhang "
                           << options.overhang << ": " << why);
      }
    }
    const double before = clock();
    const int fallback = roof(named.polygon, {}).fallback;
    slowest = std::max(slowest, clock() - before);
    if (++fallbacks[fallback]; fallback > 2 && fallbacks[fallback] < 6) {
      MESSAGE(named.name << " took rung " << fallback);
    }
  }
  if (all) {
    for (const auto& [rung, n] : fallbacks) MESSAGE("rung " << rung << ": " << n);
    MESSAGE("all " << footprints.size() << " in " << clock() - begin << " s, slowest hip roof "
                   << slowest << " s");
  }
  for (const auto& [why, n] : broken) FAIL_CHECK(why << ": " << n);
}

}  // namespace
}  // namespace mansard
