// P(rule | index): an index that a shape carries down makes what is drawn apart agree.
#include <doctest/doctest.h>

#include <algorithm>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "tests/laws/derive.hpp"

namespace {

using namespace mansard;
using namespace mansard::test;

constexpr int derivations = 100'000;

/// How often each combination of terminals came, one bay a derivation.
std::map<std::string, int> combinations(const Script& script) {
  std::map<std::string, int> counts;
  const Footprint plot = footprint("rect:2x2");
  for (uint64_t seed = 0; seed < derivations; ++seed) {
    const Building building = script.derive(plot, {.seed = seed});
    std::string found;
    for (uint32_t symbol = 0; symbol < building.terminals.size(); ++symbol) {
      if (building.terminals[symbol] > 0)
        found += " " + std::string(script.program().symbols[symbol]);
    }
    ++counts[found];
  }
  return counts;
}

/// Of those with all the words of `given`, the share that has all those of `asked`, too.
double probability(const std::map<std::string, int>& counts, const std::vector<std::string>& asked,
                   const std::vector<std::string>& given = {}) {
  double of = 0, have = 0;
  const auto has = [](const std::string& found, const std::vector<std::string>& words) {
    return std::ranges::all_of(words, [&](const std::string& word) {
      return (found + " ").find(" " + word + " ") != std::string::npos;
    });
  };
  for (const auto& [found, count] : counts) {
    if (!has(found, given)) continue;
    of += count;
    have += has(found, asked) ? count : 0;
  }
  REQUIRE(of > 0);
  return have / of;
}

}  // namespace

TEST_CASE("a sill is only ever under a window: P(Win | WSill) = 1") {
  const Script script = Script::text(R"(style Bays { Bay {
      FOOTPRINT -> extrude(3) comp { front : Bay }
      Bay  -> Tile[2] : 0.25
      Bay  -> Tile[1] : 0.25
      Bay  -> Tile[0] : 0.5
      Tile -> subdiv("Y", 1r, 0.1, 1.4, 1r) { PLASTER | Below | Middle | PLASTER }
      Below[2] -> WSILL
      Below    -> PLASTER
      Middle[0] -> PANEL
      Middle    -> WIN
  } })");
  const auto counts = combinations(script);
  CHECK(std::abs(probability(counts, {"WIN"}) - 0.5) < 0.01);
  CHECK(std::abs(probability(counts, {"WSILL"}) - 0.25) < 0.01);
  CHECK(std::abs(probability(counts, {"WSILL"}, {"WIN"}) - 0.5) < 0.01);
  CHECK(probability(counts, {"WIN"}, {"WSILL"}) == 1);
}

TEST_CASE("the probabilities of indexed productions are those under their index") {
  const Script script = Script::text(R"(style Bays { Bay {
      FOOTPRINT -> extrude(3) comp { front : Bay }
      Bay  -> Tile[1] : 0.3
      Bay  -> Tile[2] : 0.7
      Tile -> subdiv("Y", 1r, 1r) { Below | Above }
      Above    -> GREEN
      Below[1] -> BROWN : 3
      Below[1] -> WHITE : 1
      Below[2] -> BROWN : 0.1
      Below[2] -> WHITE : 0.9
      Below    -> NEVER
      Above[1] -> GREEN
      Above[2] -> GREY : 0.4
      Above[2] -> RED  : 0.4
  } })");
  const auto counts = combinations(script);
  CHECK(std::abs(probability(counts, {"GREEN"}) - 0.3) < 0.01);
  CHECK(std::abs(probability(counts, {"BROWN"}, {"GREEN"}) - 0.75) < 0.01);
  CHECK(std::abs(probability(counts, {"BROWN"}, {"GREY"}) - 0.1) < 0.01);
  CHECK(std::abs(probability(counts, {"RED"}) - 0.35) < 0.01);
  CHECK(std::abs(probability(counts, {"BROWN", "RED"}) - 0.035) < 0.01);
  CHECK(probability(counts, {"NEVER"}) == 0);
}
