// Splits that snap: lines are met exactly, by the boundaries that are nearest, and nothing else of
// a split changes; what they see depends on nothing but the building.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "interpreter/snap_lines.hpp"
#include "tests/laws/derive.hpp"

namespace {

using namespace mansard;
using namespace mansard::test;

double unit(std::mt19937& random) { return std::generate_canonical<double, 53>(random); }

/// Ascending, at least a millimetre apart, as a split gets them.
std::vector<SnapLine> random_lines(std::mt19937& random, double whole) {
  std::vector<double> at(random() % 9);
  for (double& line : at) line = unit(random) * whole;
  std::ranges::sort(at);
  std::vector<SnapLine> lines;
  for (const double line : at) {
    if (lines.empty() || line - lines.back().at > same_line) lines.push_back({line});
  }
  return lines;
}

/// Where parts end; those of no length end where the one before does.
std::vector<double> ends_of(const std::vector<double>& lengths) {
  std::vector<double> ends;
  double at = 0;
  for (const double length : lengths) ends.push_back(at += length);
  return ends;
}

/// The boundaries in their places, once each, and the ends of the whole.
std::vector<double> places_of(const std::vector<double>& ends, double whole) {
  std::set<double> places{0, whole};
  for (const double end : ends) {
    if (end > 1e-9 && end < whole - 1e-9) places.insert(end);
  }
  return {places.begin(), places.end()};
}

}  // namespace

TEST_CASE("a boundary goes to the nearest of the lines that it is nearest to, and no other moves") {
  std::mt19937 random(33);
  std::size_t met = 0, refused = 0;
  for (int round = 0; round < 20'000; ++round) {
    CAPTURE(round);
    const double whole = 1 + 12 * unit(random), tolerance = unit(random);
    std::vector<double> lengths(1 + random() % 7);
    double left = whole;  // lengths of binary fractions, so that ends are where they seem to be
    for (double& length : lengths) {
      const auto sixteenths = static_cast<double>(random() % 64);
      length = random() % 5 == 0 ? 0 : std::min(sixteenths / 16, std::floor(left * 16) / 16);
      left -= length;
    }
    if (random() % 4 != 0) lengths.push_back(left);  // or some room stays empty
    if (random() % 6 == 0) lengths.push_back(3);     // or there is too little
    const std::vector<double> before = ends_of(lengths);
    std::vector<SnapLine> lines = random_lines(random, whole);
    pull(lengths, whole, lines, tolerance);
    const std::vector<double> after = ends_of(lengths);
    CHECK(std::abs(after.back() - before.back()) <=
          (before.back() < whole - 1e-9 ? tolerance : 1e-9));

    const std::vector<double> places = places_of(before, whole);
    const auto nearest_place = [&](double at) {
      return *std::ranges::min_element(places, {}, [&](double p) { return std::abs(p - at); });
    };
    std::map<double, double> moved;  // from a place to the line that it goes to
    for (const SnapLine& line : lines) {
      const double place = nearest_place(line.at), far = std::abs(line.at - place);
      if (place == 0 || place == whole || far > tolerance) continue;
      const auto known = moved.find(place);
      if (known == moved.end() || far < std::abs(known->second - place)) moved[place] = line.at;
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto to = moved.find(before[i]);
      CHECK(std::abs(after[i] - (to == moved.end() ? before[i] : to->second)) < 1e-9);
      CHECK(lengths[i] >= -1e-9);
      if (i > 0 && before[i] - before[i - 1] > 1e-9 && before[i - 1] < whole - 1e-9)
        CHECK(after[i] - after[i - 1] > 1e-9);
    }
    for (const SnapLine& line : lines) {
      const bool taken = std::ranges::any_of(moved, [&](auto& m) { return m.second == line.at; });
      CHECK(line.used == taken);
      ++(taken ? met : refused);
    }
  }
  CHECK(met > 5'000);
  CHECK(refused > 5'000);
}

TEST_CASE("the lines of a repeat lie apart, and none is left out that could stay") {
  std::mt19937 random(34);
  for (int round = 0; round < 5'000; ++round) {
    CAPTURE(round);
    const double whole = 1 + 12 * unit(random), tolerance = 2 * unit(random);
    std::vector<SnapLine> lines = random_lines(random, whole);
    keep_apart(lines, whole, tolerance);
    double before = 0;
    for (const SnapLine& line : lines) {
      const bool near = line.at - before < tolerance || whole - line.at < tolerance;
      CHECK(line.used == !near);
      if (line.used) before = line.at;
    }
  }
}

namespace {

std::string metres(double v) {
  std::ostringstream out;
  out.precision(17);
  out << v;
  return out.str();
}

/// Coordinates of a symbol's shapes along the world's x or y: where they begin and end.
std::vector<double> bounds_along(const Script& script, const Building& building,
                                 std::string_view symbol, bool up) {
  std::vector<double> all;
  for (const TreeNode& node : building.tree) {
    if (node.shape.symbol != script.symbol(symbol)) continue;
    const Scope& s = node.shape.scope;
    const double low = up ? s.origin.y : s.origin.x;
    all.push_back(low);
    all.push_back(low + (up ? s.size.y : s.size.x));
  }
  return all;
}

bool meets(const std::vector<double>& all, double at) {
  return std::ranges::any_of(all, [&](double other) { return std::abs(other - at) < 1e-6; });
}

}  // namespace

TEST_CASE("tiles of any width stand above the shops of any width") {
  std::mt19937 random(35);
  for (int round = 0; round < 60; ++round) {
    const double width = 5 + 30 * unit(random), shop = 1 + 4 * unit(random);
    const double tile = 0.5 + 3 * unit(random);
    const Script script = Script::text(
        "style A { Mass {\n"
        "FOOTPRINT -> extrude(9) comp { front : FACADE }\n"
        "FACADE -> subdiv(\"Y\", 3, 1r) { repeat(\"X\", " +
        metres(shop) +
        ") { snap(\"YZ\") SHOP } | UPPER }\n"
        "UPPER -> repeat(\"XS\", " +
        metres(tile) + ", tolerance = 0) { TILE } } }");
    const Building building = script.derive("rect:" + metres(width) + "x7", {.keep_tree = true});
    CAPTURE(width);
    CAPTURE(shop);
    CAPTURE(tile);
    const auto tiles = bounds_along(script, building, "TILE", false);
    const auto shops = bounds_along(script, building, "SHOP", false);
    REQUIRE(shops.size() >= 2);
    for (const double line : shops) CHECK(meets(tiles, line));
  }
}

TEST_CASE("masses of any height share floor lines") {
  std::mt19937 random(36);
  for (int round = 0; round < 60; ++round) {
    const double high = 4 + 20 * unit(random), low = high * (0.2 + 0.7 * unit(random));
    const double floor = 2 + 2 * unit(random);
    const Script script = Script::text(
        "style A { Mass {\n"
        "FOOTPRINT -> subdiv(\"X\", 6, 1r) { extrude(" +
        metres(high) + ") HIGH | extrude(" + metres(low) +
        ") LOW }\n"
        "HIGH -> comp { front : HighFront }  HighFront -> repeat(\"YS\", " +
        metres(floor) +
        ") { FLOOR }\n"
        "LOW -> comp { front : LowFront }  LowFront -> repeat(\"YS\", " +
        metres(floor) + ") { STOREY }\n} }");
    const Building building = script.derive("rect:11x7", {.keep_tree = true});
    CAPTURE(high);
    CAPTURE(low);
    const auto floors = bounds_along(script, building, "FLOOR", true);
    const auto storeys = bounds_along(script, building, "STOREY", true);
    REQUIRE(storeys.size() >= 2);
    if (high - low < usual_tolerance || low < usual_tolerance) continue;
    for (const double line : storeys) CHECK(meets(floors, line));
  }
}

namespace {

const std::vector<std::string> rules{
    R"(FOOTPRINT -> [ s(7, 0, 8) extrude(9.3) MASS ] [ t(7, 0, 0) s(3, 0, 5) extrude(6.1) MASS ]
                    [ t(2, 0, 8) s(3, 0, 2) extrude(3.9) MASS ])",
    R"(MASS -> comp { side : FACADE | top : ROOF })",
    R"(FACADE -> subdiv("YS", 3.3, 1r, tolerance = 1) { GROUND | UPPER })",
    R"(GROUND -> repeat("X", rand(2, 3)) { SHOP })",
    R"(SHOP -> snap("YZ", "shop") subdiv("X", 0.3, 1r, 0.3) { PIER | GLASS | PIER })",
    R"(@stage(2) UPPER -> repeat("YS", 2.8) { snap("XZ") FLOOR })",
    R"(@stage(3) FLOOR -> repeat("XS", 1.4, to = "shop") { TILE })",
    R"(@stage(4) TILE -> split("XS", tolerance = 0.4) { ~0.5 : WALL | { 0.6 : WINDOW | ~0.3 : WALL }* })",
    R"(@stage(4) ROOF -> subdiv("XS", 1r, 1r, tolerance = 2) { LEFT | RIGHT })"};

std::string style_of(const std::vector<std::string>& in_order) {
  std::string text = "style Shuffled {\n";
  for (std::size_t i = 0; i < in_order.size(); ++i) {
    text += "Block" + std::to_string(i) + " {\n" + in_order[i] + "\n}\n";
  }
  return text + "}\n";
}

}  // namespace

TEST_CASE("lines do not depend on the order of the rules, nor on the building before") {
  const Script plain = Script::text(style_of(rules));
  const Building expected = plain.derive("rect:10x10", {.seed = 3});
  CHECK(expected.surface.polygons() > 250);
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::string> shuffled = rules;
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    const Building building = Script::text(style_of(shuffled)).derive("rect:10x10", {.seed = 3});
    CHECK(building.surface.points == expected.surface.points);
  }
  Derivation derivation(plain.program(), plain.meshes(), {.seed = 3});
  Building between, again;
  derivation.derive(footprint("L:20x12x5x5"), between);
  derivation.derive(footprint("rect:10x10"), again);
  CHECK(again.surface.points == expected.surface.points);
}

TEST_CASE("alternatives that were tried leave no planes behind") {
  const auto style = [](const std::string& facade) {
    return Script::text(R"(style Tried {
    Mass   { FOOTPRINT -> [ s(6, 0, 8) extrude(9) MASS ] t(6, 0, 0) s(4, 0, 8) extrude(5) MASS   MASS -> comp { side : FACADE } }
    Facade { FACADE -> )" +
                        facade + R"(
             @stage(2) ROW -> repeat("XS", 1.7) { TILE } }
})")
        .derive("rect:10x8")
        .surface.points;
  };
  const std::string right = R"(repeat("YS", 2.6) { [ extrude(1) SILL ] snap("XZ") ROW })";
  const std::string wrong =
      R"(subdiv("YS", 2.1, 1.4, 1r) { snap("XZ") ROW | [ t(0.4, 0, 0) snap("YZ") ] ROW | ROW })";
  const auto expected = style(right);
  CHECK(expected.size() > 100);
  CHECK(style(wrong) != expected);
  CHECK(style("best(made(\"SILL\")) { " + right + " | " + wrong + " }") == expected);
  CHECK(style("best(made(\"SILL\")) { " + wrong + " | " + right + " }") == expected);
}

TEST_CASE("a turned building, far from the origin, snaps to the same lines") {
  const Script script = Script::text(style_of(rules));
  const auto sizes = [&](double degrees, Vec2 origin) {
    Footprint on = footprint("rect:10x10");
    const double c = std::cos(degrees * 3.14159265358979323846 / 180);
    const double s = std::sin(degrees * 3.14159265358979323846 / 180);
    for (Vec2& p : on.polygon.points) p = origin + Vec2{p.x * c - p.y * s, p.x * s + p.y * c};
    std::vector<double> all;
    for (const TreeNode& node : script.derive(on, {.seed = 3, .keep_tree = true}).tree) {
      all.push_back(node.shape.scope.size.x);
      all.push_back(node.shape.scope.size.y);
    }
    return all;
  };
  const std::vector<double> plain = sizes(0, {});
  for (const double degrees : {17.0, 45.0, 90.0, 135.5, 270.0}) {
    CAPTURE(degrees);
    const std::vector<double> turned = sizes(degrees, {degrees * 4000, -degrees * 900});
    REQUIRE(turned.size() == plain.size());
    double worst = 0;
    for (std::size_t i = 0; i < plain.size(); ++i)
      worst = std::max(worst, std::abs(turned[i] - plain[i]));
    CHECK(worst < 1e-6);
  }
}
