// Shapes that decide together, and alternatives that are tried and forgotten.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tests/laws/derive.hpp"

namespace {

using namespace mansard;
using namespace mansard::test;

std::string literal(double width, double depth) {
  return "rect:" + std::to_string(width) + "x" + std::to_string(depth);
}

}  // namespace

TEST_CASE("a building has one entrance, at the greatest score") {
  const Script script = Script::text(R"(style Houses {
    Mass   { FOOTPRINT -> extrude(6) comp { front : Side(2) | side : Side(1) | top : DECK }
             Side(worth) -> repeat("Y", 3) { FLOOR(worth) }
             FLOOR(worth) -> repeat("X", rand(1, 4)) { Site(worth) } }
    Ground { Site(worth) : group.best(worth + W) -> report("best", worth + W) ENTRANCE
             Site(worth) : else -> report("other", worth + W) Window }
    Window { Window : group.best(W, "FLOOR") -> WIDE   Window : else -> NARROW } })");
  std::mt19937 random(7);
  std::uniform_real_distribution<double> side(1, 60);
  for (uint64_t seed = 0; seed < 500; ++seed) {
    const Building b = script.derive(literal(side(random), side(random)), {.seed = seed});
    CAPTURE(seed);
    REQUIRE(b.terminals[script.symbol("ENTRANCE")] == 1);
    const auto other = b.report.find("other");
    if (other != b.report.end()) REQUIRE(b.report.at("best").sum >= other->second.most);
    // One window of each of the 8 floors is its widest, but where the entrance is all there is.
    const std::size_t wide = b.terminals[script.symbol("WIDE")];
    REQUIRE((wide == 8 || wide == 7));
  }
}

TEST_CASE("groups count as a loop over their shapes does") {
  const Script script = Script::text(R"(style Sums {
    Mass { FOOTPRINT -> subdiv("Z", 1r, 1r, 1r) { ROW | ROW | ROW }
           ROW -> repeat("X", rand(0.3, 3)) { Lot(rand()) }
           Lot(n) -> report("n", n) report("sum", group.sum(n)) report("max", group.max(n)) report("min", group.min(n))
                     report("many", group.count(n > 0.5)) report("any", if group.any(n > 0.9) then 1 else 0)
                     report("all", if group.all(n < 0.9) then 1 else 0) report("rank", group.rank(n))
                     report("row", group.rank(n, "ROW")) report("1", 1) report("large", if n > 0.5 then 1 else 0) LOT } })");
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const Building b = script.derive("rect:10x8", {.seed = seed});
    CAPTURE(seed);
    const auto of = [&](const char* key) { return b.report.at(key); };
    const double count = of("1").sum;
    CHECK(of("sum").most == doctest::Approx(of("n").sum).epsilon(1e-12));
    CHECK(of("sum").least == of("sum").most);
    CHECK(of("max").least == of("n").most);
    CHECK(of("min").most == of("n").least);
    CHECK(of("many").least == of("large").sum);
    CHECK(of("any").least == (of("n").most > 0.9));
    CHECK(of("all").most == (of("n").most < 0.9));
    CHECK(of("rank").sum == count * (count - 1) / 2);  // 0, 1, 2, ...
    CHECK(of("row").sum < of("rank").sum);
  }
}

namespace {

constexpr const char* alternatives = R"(
    Court { Court -> offset(3) { inside : LAWN | border : extrude(rand(4, 8)) Mass } }
    Tower { Tower -> s(6, 0, 6) color("#a0b0c0") extrude(rand(9, 20)) Mass }
    Slab  { Slab -> best(made("WINDOW") * -1) { extrude(6) Mass | extrude(9) Mass } }
    Mass  { Mass -> label("mass") Solid
            Solid -> [ t(1, 1, 0) s(2, 2, 2) box() BOX ] comp { side : FACADE | top : DECK }
            FACADE -> repeat("Y", 3) { repeat("X", rand(1.5, 3)) { Tile } } }
    Tile  { @per("FACADE") var Wide = rand(0.6, 1.2)
            Tile : Shape.occ("noparent") == "none" -> set(Tile.Wide, Wide + rand(0, 0.1)) Free
            Tile : else -> WALL
            Free : group.best(rand()) -> DOOR
            Free : else -> subdiv("X", 1r, Wide, 1r) { WALL | color("#" + choose("102030", "405060")) WINDOW | WALL } })";

}  // namespace

TEST_CASE("alternatives that are tried leave no trace") {
  const std::string named[] = {"Court", "Tower", "Slab"};
  for (std::size_t chosen = 0; chosen < 3; ++chosen) {
    const std::string scores[] = {R"(made("LAWN"))", R"(1 - made("LAWN") - made("BASE"))",
                                  R"(made("BASE"))"};
    const auto style = [&](const std::string& choice) {
      return "style Plots { Plot { FOOTPRINT -> [ t(1, 0, 1) s(2, 2, 2) box() SHED ] Choice\n"
             "@stage(1) Choice -> color(\"#808182\") " +
             choice + " }\n Parts { B -> [ t(0, 0, 0) s(1, 1, 1) BASE ] Slab }\n" +
             std::string(alternatives) + "}";
    };
    const std::string part = named[chosen] == "Slab" ? "B" : named[chosen];
    const Script best = Script::text(style("best(" + scores[chosen] + ") { Court | Tower | B }"));
    const Script plain = Script::text(style(part));
    REQUIRE_MESSAGE(best.good(), best.problems());
    REQUIRE_MESSAGE(plain.good(), plain.problems());
    for (uint64_t seed = 0; seed < 20; ++seed) {
      CAPTURE(chosen);
      CAPTURE(seed);
      const DeriveOptions options{.seed = seed, .keep_tree = seed % 2 == 0};
      const Building a = best.derive("rect:24x18", options);
      const Building b = plain.derive("rect:24x18", options);
      REQUIRE(a.surface.polygons() > 20);
      REQUIRE(by_symbol(best, a) == by_symbol(plain, b));
      REQUIRE(a.shapes == b.shapes);
      REQUIRE(a.tree.size() == b.tree.size());
      REQUIRE(a.materials.size() == b.materials.size());
      REQUIRE(a.unmatched == b.unmatched);
    }
  }
}

TEST_CASE("the same alternative is best at every level of detail") {
  const Script script = Script::text(
      R"(style Plots { Plot { FOOTPRINT -> best(made("WINDOW")) { extrude(3) Mass | [ extrude(9) Mass ] POND } } )" +
      std::string(alternatives) + "}");
  REQUIRE_MESSAGE(script.good(), script.problems());
  for (const int lod : {1, 2, 3}) {
    const Building b = script.derive("rect:24x18", {.lod = lod});
    CHECK(b.terminals[script.symbol("POND")] == 1);
  }
}
