// Which walls look at a street.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/distance.hpp"
#include "interpreter/footprint.hpp"
#include "interpreter/surroundings.hpp"

namespace mansard {
namespace {

Footprint box(double x, double y, double width, double depth) {
  Footprint footprint;
  footprint.polygon = rectangle(width, depth);
  translate(footprint.polygon, {x, y});
  return footprint;
}

/// Edges with the flag, as "0 2 ".
std::string edges(const Footprint& footprint, EdgeTag::Flag flag) {
  std::string text;
  for (std::size_t i = 0; i < footprint.polygon.tags.size(); ++i)
    if (footprint.polygon.tags[i].has(flag)) text += std::to_string(i) + " ";
  return text;
}

Vec2 turned(Vec2 p, double angle) {
  return {p.x * std::cos(angle) - p.y * std::sin(angle),
          p.x * std::sin(angle) + p.y * std::cos(angle)};
}

// Edge 0 of a box looks south, 1 east, 2 north, 3 west.

TEST_CASE("the wall that looks at the street is the street wall, and main") {
  std::vector<Footprint> houses{box(0, 0, 10, 8)};
  mark_neighbours(houses, {{{-50, 15}, {50, 15}}});
  CHECK(edges(houses[0], EdgeTag::street) == "2 ");
  CHECK(edges(houses[0], EdgeTag::main) == "2 ");
  CHECK(edges(houses[0], EdgeTag::corner) == "");
  mark_neighbours(houses, {{{-50, -15}, {50, -15}}});  // marks anew
  CHECK(edges(houses[0], EdgeTag::street) == "0 ");
}

TEST_CASE("at a corner of streets two walls look at one, and meet in a corner") {
  // In one line, in two that meet, and in two that cross.
  const std::vector<std::vector<StreetLine>> corners{
      {{{-50, -5}, {14, -5}, {14, 50}}},
      {{{-50, -5}, {14, -5}}, {{14, 50}, {14, -5}}},
      {{{-50, -5}, {14, -5}, {50, -5}}, {{14, 50}, {14, -5}, {14, -50}}}};
  for (const auto& streets : corners) {
    std::vector<Footprint> houses{box(0, 0, 10, 12)};
    mark_neighbours(houses, streets);
    CHECK(edges(houses[0], EdgeTag::street) == "0 1 ");
    CHECK(edges(houses[0], EdgeTag::main) == "1 ");
    CHECK(edges(houses[0], EdgeTag::corner) == "0 1 ");
  }
}

TEST_CASE("a street that is much farther than the nearest one does not count") {
  std::vector<Footprint> houses{box(0, 0, 10, 8)};
  mark_neighbours(houses, {{{-50, -4}, {50, -4}}, {{-50, 21}, {50, 21}}});
  CHECK(edges(houses[0], EdgeTag::street) == "0 2 ");  // 4 m, and 13 m
  mark_neighbours(houses, {{{-50, -4}, {50, -4}}, {{-50, 23}, {50, 23}}});
  CHECK(edges(houses[0], EdgeTag::street) == "0 ");
}

TEST_CASE("a house behind another does not look through it") {
  std::vector<Footprint> houses{box(0, 0, 10, 8), box(-2, 14, 14, 8)};
  mark_neighbours(houses, {{{-50, -4}, {50, -4}}, {{16, -4}, {16, 60}}});
  CHECK(edges(houses[1], EdgeTag::street) == "1 ");  // 4 m; the other one is behind the first
  CHECK(edges(houses[0], EdgeTag::street) == "0 1 ");
}

TEST_CASE("the wall at the end of a street looks at it, a wall along it does not") {
  std::vector<Footprint> houses{box(0, 0, 10, 8)};
  mark_neighbours(houses, {{{5, -60}, {5, -10}}});
  CHECK(edges(houses[0], EdgeTag::street) == "0 ");
  mark_neighbours(houses, {{{16, -60}, {16, -20}}});  // ends before it, to the side
  CHECK(edges(houses[0], EdgeTag::street) == "0 ");
}

TEST_CASE("where no street comes within 100 m, walls with room before them are street walls") {
  std::vector<Footprint> houses{box(0, 0, 10, 8), box(13, 0, 10, 8)};
  std::vector<Footprint> without = houses;
  mark_neighbours(without);
  CHECK(edges(without[0], EdgeTag::street) == "0 2 3 ");
  CHECK(edges(without[0], EdgeTag::corner) == "0 2 3 ");
  mark_neighbours(houses, {{{-50, -130}, {50, -130}}});
  for (const auto flag : {EdgeTag::street, EdgeTag::main, EdgeTag::corner})
    CHECK(edges(houses[0], flag) == edges(without[0], flag));
}

TEST_CASE("party walls and walls of courts are no street walls") {
  std::vector<Footprint> houses{box(0, 0, 10, 30), box(10, 0, 10, 30)};
  Footprint court = box(40, 0, 30, 30);
  for (const Vec2 p : {Vec2{50, 10}, Vec2{50, 20}, Vec2{60, 20}, Vec2{60, 10}})
    court.polygon.add_point(p);
  court.polygon.close_ring();
  houses.push_back(court);
  mark_neighbours(houses, {{{10, -3}, {10, 40}}, {{55, 5}, {55, 25}}, {{40, 33}, {70, 33}}});
  CHECK(edges(houses[0], EdgeTag::street).find(edges(houses[0], EdgeTag::party)) ==
        std::string::npos);
  CHECK(edges(houses[2], EdgeTag::court) == "4 5 6 7 ");
  CHECK(edges(houses[2], EdgeTag::street) == "2 ");
}

TEST_CASE("turned and moved, in another order, the same walls are street walls") {
  std::mt19937 random(5);
  std::uniform_real_distribution<> unit(0, 1);
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    std::vector<Footprint> houses;
    for (int i = 0; i < 8; ++i)
      houses.push_back(
          box(40 * unit(random), 40 * unit(random), 3 + 9 * unit(random), 3 + 9 * unit(random)));
    std::vector<StreetLine> streets;
    for (int i = 0; i < 3; ++i) {
      StreetLine line;
      for (int k = 0; k < 4; ++k) line.push_back({60 * unit(random) - 10, 60 * unit(random) - 10});
      streets.push_back(line);
    }
    std::vector<Footprint> moved = houses;
    std::vector<StreetLine> moved_streets = streets;
    const double angle = 6 * unit(random);
    for (Footprint& house : moved)
      for (Vec2& p : house.polygon.points) p = turned(p, angle) + Vec2{70, -30};
    for (StreetLine& line : moved_streets) {
      for (Vec2& p : line) p = turned(p, angle) + Vec2{70, -30};
      std::reverse(line.begin(), line.end());
    }
    std::reverse(moved.begin(), moved.end());
    std::reverse(moved_streets.begin(), moved_streets.end());
    mark_neighbours(houses, streets);
    mark_neighbours(moved, moved_streets);
    for (std::size_t i = 0; i < houses.size(); ++i) {
      const Footprint& other = moved[houses.size() - 1 - i];
      CHECK(edges(houses[i], EdgeTag::street) == edges(other, EdgeTag::street));
      CHECK(edges(houses[i], EdgeTag::corner) == edges(other, EdgeTag::corner));
    }
  }
}

TEST_CASE("the nearest street is found as by looking at all") {
  std::mt19937 random(9);
  std::uniform_real_distribution<> at(-100, 100);
  std::vector<StreetLine> lines;
  for (int i = 0; i < 200; ++i) {
    const Vec2 from{at(random), at(random)};
    lines.push_back({from, from + Vec2{at(random) / 10, at(random) / 10}});
  }
  const Streets streets(lines);
  for (int round = 0; round < 300; ++round) {
    const Vec2 a{at(random), at(random)}, b = a + Vec2{at(random) / 20, at(random) / 20};
    double least = 1e9;
    for (const StreetLine& line : lines)
      least = std::min(least, nearest_pair(line[0], line[1], a, b).distance);
    const auto near = streets.nearest(a, b, 1e9);
    REQUIRE(near.has_value());
    CHECK(near->distance == doctest::Approx(least));
    CHECK(!streets.nearest(a, b, least * 0.99).has_value());
  }
  CHECK(!Streets({}).nearest({0, 0}, {0, 0}, 1e9).has_value());
}

}  // namespace
}  // namespace mansard
