// The thesis's own buildings (styles/library/listings.style).
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "tests/laws/derive.hpp"

namespace {

using namespace mansard;
using namespace mansard::test;

Footprint five_metres_high() {
  Footprint on = footprint("rect:10x8");
  on.properties.push_back({"height", 5.0});
  return on;
}

/// One line a shape, with its ancestors' symbols and its scope; none below TILE.
std::multimap<std::string, int> above_tiles(const Script& script, const Building& building) {
  std::multimap<std::string, int> lines;
  std::vector<std::string> paths;
  std::vector<bool> below;
  for (const TreeNode& node : building.tree) {
    const bool root = node.parent == Shape::none;
    const auto symbol = std::string(script.program().symbols[node.shape.symbol]);
    below.push_back(!root && (below[node.parent] ||
                              script.program().symbols[building.tree[node.parent].shape.symbol] ==
                                  std::string_view("TILE")));
    paths.push_back((root ? "" : paths[node.parent] + "/") + symbol);
    if (below.back()) continue;
    std::ostringstream line;
    const Vec3 o = node.shape.scope.origin, s = node.shape.scope.size;
    line.precision(12);
    line << paths.back() << ' ' << o.x << ' ' << o.y << ' ' << o.z << ' ' << s.x << ' ' << s.y
         << ' ' << s.z;
    lines.emplace(line.str(), 0);
  }
  return lines;
}

}  // namespace

TEST_CASE("the two buildings differ only below TILE, by a ledge under every window") {
  const Script one = Script::file("styles/library/listings.style", {{}, "Building1"});
  const Script two = Script::file("styles/library/listings.style", {{}, "Building2"});
  const Building a = one.derive(five_metres_high(), {.keep_tree = true});
  const Building b = two.derive(five_metres_high(), {.keep_tree = true});
  CHECK(above_tiles(one, a) == above_tiles(two, b));
  const auto windows = a.terminals[one.symbol("WINDOW")];
  CHECK(windows > 100);
  CHECK(b.terminals[two.symbol("WINDOW")] == windows);
  CHECK(a.terminals[one.symbol("LEDGE")] == 0);
  CHECK(b.terminals[two.symbol("LEDGE")] == windows);
  // Every ledge lies right under a window of its width.
  std::vector<const Shape*> ledges, panes;
  for (const TreeNode& node : b.tree) {
    if (node.shape.symbol == two.symbol("LEDGE")) ledges.push_back(&node.shape);
    if (node.shape.symbol == two.symbol("WINDOW")) panes.push_back(&node.shape);
  }
  REQUIRE(ledges.size() == panes.size());
  for (std::size_t i = 0; i < ledges.size(); ++i) {
    const Scope &ledge = ledges[i]->scope, &pane = panes[i]->scope;
    CHECK(length(ledge.origin + ledge.y * ledge.size.y - pane.origin) < 1e-9);
    CHECK(std::abs(ledge.size.x - pane.size.x) < 1e-9);
    CHECK(std::abs(ledge.size.y - 0.075) < 1e-9);
    CHECK(std::abs(pane.size.y - 0.5) < 1e-9);
  }
}

TEST_CASE("ground floors come out 0.30, 0.40 and 0.30 over 10,000 seeds") {
  const Script script = Script::file("styles/library/listings.style", {{}, "Building1"});
  Footprint on = footprint("rect:10x8");
  on.properties.push_back({"height", 2.5});
  std::array<int, 3> drawn{};
  Building building;
  const uint32_t floor = script.symbol("FLOOR"), wall = script.symbol("WALL"),
                 ground = script.symbol("GROUND_FLOOR");
  for (uint64_t seed = 0; seed < 10'000; ++seed) {
    Derivation derivation(script.program(), script.meshes(), {.seed = seed, .keep_tree = true});
    derivation.derive(on, building);
    for (std::size_t i = 0; i < building.tree.size(); ++i) {
      if (building.tree[i].shape.symbol != ground) continue;
      // The first facade's: wall first is the third production, wall last the first.
      uint32_t first = 0, last = 0;
      for (std::size_t c = i + 1; c < building.tree.size(); ++c) {
        if (building.tree[c].parent != i) continue;
        if (first == 0) first = building.tree[c].shape.symbol;
        last = building.tree[c].shape.symbol;
      }
      ++drawn[first == wall ? 2 : last == wall ? 0 : 1];
      REQUIRE((first == floor || first == wall));
      break;
    }
  }
  CHECK(std::abs(drawn[0] / 10'000.0 - 0.30) < 0.015);
  CHECK(std::abs(drawn[1] / 10'000.0 - 0.40) < 0.015);
  CHECK(std::abs(drawn[2] / 10'000.0 - 0.30) < 0.015);
}
