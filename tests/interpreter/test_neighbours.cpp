// What footprints know about each other.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>

#include "interpreter/footprint.hpp"

namespace mansard {
namespace {

Footprint box(double x, double y, double width, double depth) {
  Footprint footprint;
  footprint.polygon = rectangle(width, depth);
  translate(footprint.polygon, {x, y});
  return footprint;
}

double length_with(const Footprint& footprint, EdgeTag::Flag flag) {
  double sum = 0;
  for_each_edge(footprint.polygon, [&](uint32_t i, Vec2 a, Vec2 b) {
    if (footprint.polygon.tags[i].has(flag)) sum += length(b - a);
  });
  return sum;
}

int edges_with(const Footprint& footprint, EdgeTag::Flag flag) {
  const auto& tags = footprint.polygon.tags;
  return static_cast<int>(
      std::count_if(tags.begin(), tags.end(), [&](EdgeTag t) { return t.has(flag); }));
}

void turn(std::vector<Footprint>& footprints, double angle, Vec2 by) {
  for (Footprint& footprint : footprints) {
    for (Vec2& p : footprint.polygon.points) {
      p = by + Vec2{p.x * std::cos(angle) - p.y * std::sin(angle),
                    p.x * std::sin(angle) + p.y * std::cos(angle)};
    }
  }
}

TEST_CASE("a detached house has streets all round, and its longest edge is the main one") {
  std::vector<Footprint> houses{box(0, 0, 8, 12), box(100, 0, 8, 12)};
  mark_neighbours(houses);
  CHECK(edges_with(houses[0], EdgeTag::street) == 4);
  CHECK(edges_with(houses[0], EdgeTag::party) == 0);
  CHECK(edges_with(houses[0], EdgeTag::main) == 1);
  CHECK(houses[0].polygon.tags[1].has(EdgeTag::main));
  CHECK(houses[0].polygon.tags[3].wall == 3);
}

TEST_CASE("walls that touch in part are divided where the neighbour ends, on both sides") {
  constexpr unsigned seed = 11;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<> unit(0, 1);
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    const double shift = 19 * unit(random) - 9.5, gap = 0.04 * unit(random);
    const double shared = 10 - std::abs(shift);
    std::vector<Footprint> houses{box(0, 0, 6, 10), box(6 + gap, shift, 7, 10)};
    turn(houses, 7 * unit(random), {1000 * unit(random), 500 * unit(random)});
    const double area_before = area(houses[0].polygon);
    mark_neighbours(houses);
    // Pieces shorter than half a metre go to what is beside them.
    for (const Footprint& house : houses) {
      CHECK(std::abs(length_with(house, EdgeTag::party) - shared) < 0.5 + 1e-6);
      if (std::abs(shift) > 0.5 && shared > 0.5) {
        CHECK(house.polygon.points.size() == 5);
        CHECK(edges_with(house, EdgeTag::party) == 1);
        CHECK(length_with(house, EdgeTag::party) == doctest::Approx(shared));
      }
      for_each_edge(house.polygon,
                    [&](uint32_t, Vec2 a, Vec2 b) { CHECK(length(b - a) > 0.5 - 1e-6); });
    }
    CHECK(area(houses[0].polygon) == doctest::Approx(area_before));
  }
}

TEST_CASE("a wall farther away than the tolerance is none of ours") {
  std::vector<Footprint> houses{box(0, 0, 6, 10), box(6.06, 0, 7, 10)};
  mark_neighbours(houses);
  CHECK(edges_with(houses[0], EdgeTag::party) == 0);
  CHECK(edges_with(houses[0], EdgeTag::street) == 3);  // not where the neighbour stands in front
}

TEST_CASE("an edge with neighbours in its middle and at its end gets both") {
  std::vector<Footprint> houses{box(0, 0, 30, 10), box(5, 10, 6, 10), box(20, 10, 10, 10)};
  mark_neighbours(houses);
  CHECK(length_with(houses[0], EdgeTag::party) == doctest::Approx(16));
  CHECK(houses[0].polygon.points.size() == 7);
}

TEST_CASE("in a terrace inner houses have two party walls, end houses one") {
  std::vector<Footprint> row;
  for (int i = 0; i < 12; ++i) row.push_back(box(6 * i, 0, 6, 10));
  turn(row, 0.3, {400, -80});
  mark_neighbours(row);
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool end = i == 0 || i + 1 == row.size();
    CHECK(row[i].polygon.points.size() == 4);
    CHECK(edges_with(row[i], EdgeTag::party) == (end ? 1 : 2));
    CHECK(edges_with(row[i], EdgeTag::street) == (end ? 3 : 2));
    CHECK(edges_with(row[i], EdgeTag::main) == 1);
  }
}

TEST_CASE("edges of holes face a court and no street") {
  Footprint block = box(0, 0, 30, 30);
  for (const Vec2 p : {Vec2{10, 10}, Vec2{10, 20}, Vec2{20, 20}, Vec2{20, 10}}) {
    block.polygon.add_point(p);
  }
  block.polygon.close_ring();
  std::vector<Footprint> houses{block, box(15, 10, 5, 4)};  // one stands in the court
  mark_neighbours(houses);
  CHECK(length_with(houses[0], EdgeTag::court) == doctest::Approx(40));
  CHECK(length_with(houses[0], EdgeTag::street) == doctest::Approx(120));
  CHECK(length_with(houses[0], EdgeTag::party) == doctest::Approx(9));
  CHECK(edges_with(houses[1], EdgeTag::main) == 1);
}

TEST_CASE("houses close all round keep their free edges as streets") {
  std::vector<Footprint> houses{box(0, 0, 8, 8), box(9, -5, 8, 18), box(-9, -5, 8, 18),
                                box(0, 9, 8, 8), box(0, -9, 8, 8)};
  mark_neighbours(houses);
  CHECK(edges_with(houses[0], EdgeTag::street) == 4);
}

TEST_CASE("marking again changes nothing, and the order of footprints does not matter") {
  std::mt19937 random(5);
  std::vector<Footprint> houses;
  for (int i = 0; i < 200; ++i) {
    houses.push_back(box(6.0 * (i % 20), 10.0 * (i / 20), 6, 4 + static_cast<int>(random() % 7)));
  }
  std::vector<Footprint> turned(houses.rbegin(), houses.rend());
  mark_neighbours(houses);
  mark_neighbours(turned);
  std::vector<Footprint> again = houses;
  mark_neighbours(again);
  for (std::size_t i = 0; i < houses.size(); ++i) {
    CHECK(houses[i].polygon.tags == again[i].polygon.tags);
    CHECK(houses[i].polygon.points == again[i].polygon.points);
    CHECK(houses[i].polygon.tags == turned[turned.size() - 1 - i].polygon.tags);
  }
}

TEST_CASE("broken footprints are passed over") {
  std::vector<Footprint> houses{box(0, 0, 6, 10), Footprint{}, box(0, 0, 6, 10), box(6, 0, 6, 10)};
  houses[2].polygon.points[1].x = std::nan("");
  houses.push_back(box(1e15, 0, 1e12, 5));
  houses.push_back(box(3, 3, 0, 0));
  mark_neighbours(houses);
  CHECK(length_with(houses[0], EdgeTag::party) == doctest::Approx(10));
}

TEST_CASE("a country's footprints are marked in a moment") {
  std::mt19937 random(3);
  std::vector<Footprint> houses;
  for (int i = 0; i < 9000; ++i) {
    const double x = 7.0 * (i % 100) + 40 * (i % 100 / 8), y = 30.0 * (i / 100);
    houses.push_back(box(x, y, 7, 8 + static_cast<int>(random() % 6)));
  }
  turn(houses, 0.4, {20000, 10000});
  const std::clock_t begin = std::clock();
  mark_neighbours(houses);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  MESSAGE("9000 footprints in " << seconds << " s");
  CHECK(seconds < 2);
  CHECK(edges_with(houses[1], EdgeTag::party) == 2);
}

}  // namespace
}  // namespace mansard
