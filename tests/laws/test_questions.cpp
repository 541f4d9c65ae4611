// Shapes that ask about others: the answers depend on nothing but the building, and real terraces
// have windows on all of their free walls and on no others.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <random>
#include <set>

#include "formats/streets.hpp"
#include "tests/laws/derive.hpp"

namespace {

using namespace mansard;
using namespace mansard::test;

const std::vector<std::string> rules{
    R"(FOOTPRINT -> [ s(6, 0, 8) extrude(9) MASS ] [ t(6, 0, 0) s(4, 0, 5) extrude(6) MASS ]
                    [ t(2, 0, 7) s(2, 8, 2) cylinder(12) MASS ])",
    R"(MASS -> comp { side : FACADE | top : ROOF })",
    R"(ROOF -> roof("hip", 30) { slope : SLATE })",
    R"(FACADE -> [ t(1, 1, 0) s(2, 2, 0) SITE ] repeat("Y", 3) { repeat("X", 1.5) { TILE } })",
    R"(SITE : Shape.occ("noparent") == "none" && rand() < 0.5 -> extrude(rand(0.4, 1)) { BAY }
       SITE : else -> NIL)",
    R"(BAY -> comp { front : TILE | side : TILE | top : LEAD })",
    R"(@stage(2) TILE : Shape.occ("all") == "none" -> subdiv("X", 1r, rand(0.5, 0.9), 1r) { WALL | PANE | WALL }
       @stage(2) TILE : Shape.occ("all") == "part" -> WALL
       @stage(2) TILE : else -> NIL)",
    R"(PANE -> detrude(0.1) { GLASS | REVEAL })",
    R"(@stage(3) LEAD : touches("noparent") -> FLASHING   @stage(3) LEAD : else -> SHEET)"};

std::string style_of(const std::vector<std::string>& in_order) {
  std::string text = "style Shuffled {\n";
  for (std::size_t i = 0; i < in_order.size(); ++i) {
    text += "Block" + std::to_string(i) + " {\n" + in_order[i] + "\n}\n";
  }
  return text + "}\n";
}

}  // namespace

TEST_CASE("shuffling the rules changes no byte") {
  const Script plain = Script::text(style_of(rules));
  const Building expected = plain.derive("rect:10x8", {.seed = 3});
  CHECK(expected.surface.polygons() > 100);
  const auto points = by_symbol(plain, expected);
  for (const char* const symbol : {"GLASS", "SHEET", "SLATE", "WALL"}) {
    CAPTURE(symbol);
    CHECK(points.contains(symbol));
  }
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::string> shuffled = rules;
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    const Script script = Script::text(style_of(shuffled));
    const Building building = script.derive("rect:10x8", {.seed = 3});
    CHECK(building.surface.points == expected.surface.points);
    CHECK(building.surface.uvs == expected.surface.uvs);
    CHECK(by_symbol(script, building) == points);
  }
}

TEST_CASE("questions of a building before leave nothing behind") {
  const Script script = Script::text(style_of(rules));
  Derivation derivation(script.program(), script.meshes(), {});
  Building first, again, between;
  const Footprint on = footprint("rect:10x8");
  derivation.derive(on, first);
  derivation.derive(footprint("L:20x12x5x5"), between);
  derivation.derive(on, again);
  CHECK(first.surface.points == again.surface.points);
}

TEST_CASE("a row of houses covers its party walls as high as the neighbour is") {
  const Script script = Script::text(R"(style Row {
    Mass   { FOOTPRINT -> extrude(BUILDING_HEIGHT) comp { side : FACADE | top : DECK } }
    Facade { FACADE -> repeat("Y", 3) { TILE } }
    Tile   { TILE : Shape.occ("all") == "none" -> WINDOW   TILE : Shape.occ("all") == "full" -> HIDDEN   TILE : else -> WALL }
})");
  FootprintSet set = read_footprints(
      "WKT:MULTIPOLYGON(((0 0,5 0,5 8,0 8)),((5.04 0,10 0,10 8,5.04 8)),"
      "((9.97 0,15 0,15 10,9.97 10)))",
      {});
  REQUIRE(set.footprints.size() == 3);
  const double heights[] = {9, 6, 9};
  for (std::size_t i = 0; i < 3; ++i)
    set.footprints[i].properties.push_back({"height", heights[i]});
  mark_neighbours(set.footprints);
  // The last house is deeper than the one beside it: its party wall is divided where that ends.
  const std::size_t windows[] = {3 * 3 + 1, 2 * 2, 3 * 4 + 1};
  const std::size_t hidden[] = {2, 4, 2};
  for (std::size_t i = 0; i < 3; ++i) {
    CAPTURE(i);
    const Building building = script.derive(set.footprints[i]);
    CHECK(building.terminals[script.symbol("WINDOW")] == windows[i]);
    CHECK(building.terminals[script.symbol("HIDDEN")] == hidden[i]);
  }
}

namespace {

bool share_a_wall(const Footprint& a, const Footprint& b) {
  bool beside = false;
  for_each_edge(a.polygon, [&](uint32_t, Vec2 p, Vec2 q) {
    for_each_edge(b.polygon, [&](uint32_t, Vec2 from, Vec2 to) {
      const Vec2 along = normalized(to - from);
      const bool in_line =
          std::abs(cross(along, p - from)) < 0.02 && std::abs(cross(along, q - from)) < 0.02;
      const auto [low, high] = std::minmax({dot(p - from, along), dot(q - from, along)});
      beside = beside || (in_line && std::min(high, length(to - from)) - std::max(low, 0.0) > 1);
    });
  });
  return beside;
}

/// Houses of the longest terraces, whole rows of buildings that share walls, `count` in all.
std::vector<std::size_t> adjoining(const std::vector<Footprint>& all, std::size_t count) {
  std::vector<std::vector<std::size_t>> rows;
  std::set<std::size_t> taken;
  for (std::size_t start = 0; start < all.size(); ++start) {
    if (!taken.insert(start).second) continue;
    std::vector<std::size_t>& row = rows.emplace_back(1, start);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Box2 box = bounds(all[row[i]].polygon.points);
      for (std::size_t b = 0; b < all.size(); ++b) {
        const Box2 other = bounds(all[b].polygon.points);
        const bool near = box.low.x < other.high.x + 1 && other.low.x < box.high.x + 1 &&
                          box.low.y < other.high.y + 1 && other.low.y < box.high.y + 1;
        if (!near || taken.contains(b) || !share_a_wall(all[row[i]], all[b])) continue;
        taken.insert(b);
        row.push_back(b);
      }
    }
  }
  std::ranges::stable_sort(rows, std::greater(), &std::vector<std::size_t>::size);
  std::vector<std::size_t> houses;
  for (const auto& row : rows) houses.insert(houses.end(), row.begin(), row.end());
  houses.resize(std::min(houses.size(), count));
  return houses;
}

/// How much of a wall's tile has a neighbour within 5 cm before it: of a grid of samples.
double beside_neighbour(const std::vector<Footprint>& all, std::size_t own,
                        std::span<const Vec3> loop, Vec3 normal) {
  constexpr int n = 200;
  int covered = 0, samples = 0;
  for (int i = 0; i < n; ++i) {
    const Vec3 p = mix(loop[0], loop[1], (i + 0.5) / n) + normal * 0.001;
    const Vec3 q = p + normal * 0.05;
    bool in = false;
    for (std::size_t other = 0; other < all.size() && !in; ++other) {
      if (other == own) continue;
      in = contains(all[other].polygon, {p.x, -p.z}) || contains(all[other].polygon, {q.x, -q.z});
    }
    ++samples;
    covered += in;
  }
  return static_cast<double>(covered) / samples;
}

}  // namespace

TEST_CASE("fifty adjoining houses have windows on their free walls only") {
  const std::string path = MANSARD_ROOT "/../shared/data/baltimore.osm.pbf";
  if (!std::filesystem::exists(path)) {
    MESSAGE(path, " is missing: not tested");
    return;
  }
  FootprintSet set = read_footprints(path, {});
  std::vector<Footprint> houses;
  for (const std::size_t i : adjoining(set.footprints, 50)) {
    Footprint house = set.footprints[i];
    house.properties.clear();  // all as high: what is beside is covered from top to bottom
    houses.push_back(std::move(house));
  }
  REQUIRE(houses.size() == 50);
  mark_neighbours(houses);
  const Script script = Script::text(R"(style Terrace {
    Mass   { FOOTPRINT -> extrude(BUILDING_HEIGHT) comp { side : FACADE | top : DECK } }
    Facade { FACADE -> repeat("X", 2) { TILE } }
    Tile   { TILE : Shape.occ("all") == "none" -> WINDOW   TILE : Shape.occ("all") == "full" -> HIDDEN   TILE : else -> WALL }
})");
  double area_by[3] = {0, 0, 0};
  std::size_t wrong = 0;
  for (std::size_t own = 0; own < houses.size(); ++own) {
    const Building building = script.derive(houses[own]);
    for_each_polygon(building.surface, [&](std::size_t polygon, uint32_t symbol) {
      const std::string_view name = script.program().symbols[symbol];
      if (name == "DECK") return;
      const auto loop = building.surface.loop(polygon);
      const double share = beside_neighbour(houses, own, loop, building.surface.normals[polygon]);
      const double wide = length(loop[1] - loop[0]);
      const std::size_t answer = name == "WINDOW" ? 0 : name == "HIDDEN" ? 2 : 1;
      area_by[answer] += area(building.surface, polygon);
      // Less than 6 cm do not count, at either end.
      const double doubt = 0.13 / wide + 0.02;
      const bool right = answer == 0   ? share <= doubt
                         : answer == 2 ? share >= 1 - doubt
                                       : share > 0;
      if (!right && ++wrong <= 5)
        MESSAGE(houses[own].id, ": ", name, " with ", share, " of ", wide, " m beside a neighbour");
    });
  }
  const double whole = area_by[0] + area_by[1] + area_by[2];
  MESSAGE("of ", whole, " m2 of facades ", 100 * area_by[2] / whole, " % are saved, ",
          100 * area_by[1] / whole, " % are beside a neighbour in part");
  CHECK(wrong == 0);
  CHECK(area_by[0] > 0.2 * whole);
  CHECK(area_by[2] > 0.1 * whole);
}

namespace {

/// A style that asks much, of walls and tiles.
const char* const curious = R"(style Curious {
    Mass   { FOOTPRINT -> extrude(BUILDING_HEIGHT) comp { main : FACADE | corner : FACADE | side : FACADE | top : DECK } }
    Facade { FACADE -> repeat("Y", 3) { repeat("X", 2) { TILE } } }
    Tile {
        TILE : Shape.occ("all") == "full"                  -> NIL
        TILE : else !Shape.visible("street")               -> WALL
        TILE : else corner.left < 150                      -> QUOIN
        TILE : else nearest("street") < rand(5, 15)        -> [ t(0, 0, 0.01) extrude(0.3) BAY ] SHOP
        TILE : else nearest("neighbours") > rand(2, 8)     -> WINDOW
        TILE : else -> WALL
        @stage(2) BAY : touches("noparent") -> SIGN   @stage(2) BAY : else -> AWNING
    }
})";

}  // namespace

TEST_CASE("shuffling real footprints and streets changes no byte of a building") {
  const std::string path = MANSARD_ROOT "/../shared/data/monaco.osm.pbf";
  if (!std::filesystem::exists(path)) {
    MESSAGE(path, " is missing: not tested");
    return;
  }
  const FootprintSet set = read_footprints(path, {});
  std::vector<StreetLine> streets = read_streets(path, {}, set).lines;
  std::vector<Footprint> houses = set.footprints;
  houses.resize(400);
  std::vector<Footprint> shuffled = houses;
  mark_neighbours(houses, streets);
  std::mt19937 random(2);
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  std::shuffle(streets.begin(), streets.end(), random);
  for (StreetLine& line : streets) std::reverse(line.begin(), line.end());
  mark_neighbours(shuffled, streets);
  const Script script = Script::text(curious);
  REQUIRE_MESSAGE(script.good(), script.problems());
  std::map<std::string, Building> buildings;
  Derivation derivation(script.program(), script.meshes(), {});
  for (const Footprint& house : houses) derivation.derive(house, buildings[house.id]);
  std::size_t changed = 0;
  std::map<std::string, std::size_t> terminals;
  for (const Footprint& house : shuffled) {
    Building building;
    derivation.derive(house, building);
    const Building& before = buildings[house.id];
    changed += building.surface.points != before.surface.points ||
               building.surface.ends != before.surface.ends ||
               building.terminals != before.terminals;
    for (const char* const name : {"WALL", "QUOIN", "SHOP", "WINDOW", "SIGN", "AWNING"})
      terminals[name] += building.terminals[script.symbol(name)];
  }
  CHECK(changed == 0);
  for (const auto& [name, count] : terminals) {
    CAPTURE(name);
    CHECK(count > 20);
  }
}
