#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "geometry/mesh.hpp"
#include "geometry/roof.hpp"
#include "geometry/roof_lines.hpp"

using namespace mansard;

namespace {

std::vector<RoofLine> lines_of(const Roof& roof) {
  std::vector<BorderEdge> edges;
  std::vector<Vec3> normals;
  for (const RoofFace& face : roof.faces) {
    const auto number = static_cast<uint32_t>(normals.size());
    normals.push_back(normalized(newell(face.loop)));
    const auto add = [&](const std::vector<Vec3>& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i)
        edges.push_back({ring[i], ring[(i + 1) % ring.size()], number});
    };
    add(face.loop);
    for (const auto& hole : face.holes) add(hole);
  }
  return roof_lines(edges, normals, {0, 0, 1});
}

/// "2 ridges of 4 m" as {kind: {count, total length}}.
std::map<std::string, std::pair<int, double>> summary(const std::vector<RoofLine>& lines) {
  std::map<std::string, std::pair<int, double>> sums;
  for (const RoofLine& line : lines) {
    auto& [count, total] = sums[std::string(roof_line_words[static_cast<std::size_t>(line.kind)])];
    ++count;
    total += length(line.to - line.from);
  }
  return sums;
}

std::vector<RoofLine> lines_of(RoofKind kind, const Polygon& plan, double overhang = 0) {
  RoofOptions options;
  options.kind = kind;
  options.pitch = 45;
  options.overhang = overhang;
  return lines_of(roof(plan, options));
}

Polygon l_shape() {
  Polygon plan;
  for (const Vec2 p : {Vec2{0, 0}, {12, 0}, {12, 5}, {6, 5}, {6, 10}, {0, 10}}) plan.add_point(p);
  plan.close_ring();
  return plan;
}

Vec3 turned(Vec3 p) { return {0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y, p.z}; }

}  // namespace

TEST_CASE("a hip roof has a ridge, hips and eaves") {
  const auto lines = summary(lines_of(RoofKind::hip, rectangle(10, 8)));
  CHECK(lines.size() == 3);
  CHECK(lines.at("ridge").first == 1);
  CHECK(lines.at("ridge").second == doctest::Approx(2));
  CHECK(lines.at("hip").first == 4);
  CHECK(lines.at("hip").second == doctest::Approx(4 * std::sqrt(48)));
  CHECK(lines.at("eave").first == 4);
  CHECK(lines.at("eave").second == doctest::Approx(36));
}

TEST_CASE("a gable roof has a ridge, eaves and rakes, with and without overhang") {
  const auto flush = summary(lines_of(RoofKind::gable, rectangle(10, 8)));
  CHECK(flush.size() == 3);
  CHECK(flush.at("ridge").second == doctest::Approx(10));
  CHECK(flush.at("eave").second == doctest::Approx(20));
  CHECK(flush.at("rake").first == 4);
  CHECK(flush.at("rake").second == doctest::Approx(4 * std::sqrt(32)));
  const auto wide = summary(lines_of(RoofKind::gable, rectangle(10, 8), 0.5));
  CHECK(wide.size() == 3);
  CHECK(wide.at("ridge").second == doctest::Approx(11));
  CHECK(wide.at("eave").second == doctest::Approx(22));
  CHECK(wide.at("rake").second == doctest::Approx(4 * std::sqrt(2) * 4.5));
}

TEST_CASE("an L has a valley at its inner corner") {
  const auto lines = summary(lines_of(RoofKind::hip, l_shape()));
  CHECK(lines.at("valley").first == 1);
  CHECK(lines.at("valley").second > 3);
}

TEST_CASE("inclined lines run upwards, eaves have their slope at the left, y leads away") {
  for (const RoofLine& line : lines_of(RoofKind::gable, l_shape(), 0.4)) {
    const Vec3 along = line.to - line.from;
    CHECK(along.z >= -1e-9);
    CHECK(length(line.away) == doctest::Approx(1));
    CHECK(std::abs(dot(line.away, along)) < 1e-9);
    CHECK(line.away.z > 0);
    if (line.kind == RoofLineKind::eave) {
      const Vec3 right = cross(along, Vec3{0, 0, 1});
      CHECK(dot(line.away, right) > 0);
    }
    if (line.kind == RoofLineKind::ridge) CHECK(line.away.z == doctest::Approx(1));
  }
}

TEST_CASE("the lines turn with the roof, and points a hair apart are one") {
  const Roof made = roof(l_shape(), {});
  Roof other = made;
  double hair = 0;
  for (RoofFace& face : other.faces) {
    hair = 3e-7 - hair;
    for (Vec3& p : face.loop) p = turned(p) + Vec3{hair, hair, 0};
  }
  const std::vector<RoofLine> before = lines_of(made), after = lines_of(other);
  REQUIRE(before.size() == after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    CHECK(before[i].kind == after[i].kind);
    CHECK(length(turned(before[i].from) - after[i].from) < 1e-5);
    CHECK(length(turned(before[i].away) - after[i].away) < 1e-5);
  }
}

TEST_CASE("breaks are no lines; a slope's foot at a wall is a valley") {
  // Across y: foot at a wall, a slope, a shallower one, and a level top, as wide as x = 0..1.
  const std::array<Vec2, 5> profile{Vec2{0, 2}, {0, 0}, {1, 1}, {3, 2}, {4, 2}};
  std::vector<BorderEdge> edges;
  std::vector<Vec3> normals;
  for (uint32_t i = 0; i + 1 < profile.size(); ++i) {
    const Vec2 a = profile[i], b = profile[i + 1];
    const std::vector<Vec3> loop{{0, a.x, a.y}, {1, a.x, a.y}, {1, b.x, b.y}, {0, b.x, b.y}};
    for (std::size_t k = 0; k < 4; ++k) edges.push_back({loop[k], loop[(k + 1) % 4], i});
    normals.push_back(normalized(newell(loop)));
  }
  const auto lines = summary(roof_lines(edges, normals, {0, 0, 1}));
  CHECK(lines.size() == 2);
  CHECK(lines.at("valley").first == 1);
  CHECK(lines.at("rake").first == 4);
}

TEST_CASE("the eave of a steep roof is the outer border of its cornice") {
  RoofOptions options;
  options.kind = RoofKind::mansard;
  options.pitch = 70;
  options.overhang = 0.5;
  const auto lines = lines_of(roof(rectangle(10, 8), options));
  CHECK(summary(lines).at("eave").first == 4);
  CHECK(summary(lines).at("eave").second == doctest::Approx(40));
  for (const RoofLine& line : lines) {
    if (line.kind != RoofLineKind::eave) continue;
    CHECK(dot(line.away, cross(line.to - line.from, Vec3{0, 0, 1})) > 0);
    CHECK(std::min(std::abs(line.from.x + 0.5), std::abs(line.from.x - 10.5)) < 1e-9);
  }
}

TEST_CASE("walls and level roofs have no lines") {
  RoofOptions options;
  options.kind = RoofKind::flat;
  options.parapet = 1;
  CHECK(lines_of(roof(rectangle(5, 4), options)).empty());
}
