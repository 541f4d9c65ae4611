// Sizes ':' are what the parts turn out to need: what is drawn while measuring is what is derived.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "tests/laws/derive.hpp"

namespace {

using namespace mansard;
using namespace mansard::test;

/// Groups of windows whose kinds, widths and spacings are all drawn, in every way in which sizes
/// and parts can be put together. Sized(w) reports by how much it misses the width that it was
/// given.
const char* const groups = R"(style Groups { Front {
    var Pier = 0.2
    FOOTPRINT -> extrude(12) comp { front : repeat("Y", 3) { Row } }
    Row -> subdiv("X", 1r, :, ~0.2, :, 5%, :, rand(0.1, 0.5), 1r)
           { WALL | Group | WALL | Win | WALL | Pair | WALL | WALL }
    Row -> split("X") { 1r : WALL | : : Group | 0.1 : WALL | { : : Win | ~0.6 : WALL }* | 1r : WALL }
    Row -> split("X") { { : : Pair | ~0.4 : WALL | : : Win }* | 1r : WALL }
    Row -> subdiv("X", 1r, :, 1r) { WALL | set(Front.Pier, rand(0.1, 0.4)) Pair | WALL }
    Group -> subdiv("X", 0.3, :, rand(0.2, 0.6), :, 0.3) { WALL | Win | WALL | Win[2] | WALL }
    Pair -> subdiv("X", Pier, :, :, Pier) { WALL | Column(rand(0.3, 0.9)) | Win[split.index] | WALL }
    Column(w) : fits -> subdiv("Y", 0.5, 1.4, 1r) { WALL | Sized(w) | WALL }
    Column(w) : else -> FAILED
    Win    -> Sized(rand(0.4, 1.5)) : 0.6
    Win    -> subdiv("Y", 1r, 1.4, 1r) { WALL | Wide | WALL } : 0.4
    Win[2] -> Sized(Drawn)
    @per("shape") var Drawn = rand(0.2, 2)
    Wide   -> Sized(1.6) : rand()
    Wide   -> Sized(2.1) : 0.5
    Sized(w) -> report("missing", abs(W - w)) subdiv("X", w) { WINDOW }
} })";

/// How far the children leave gaps or overlap, along x or y, at most; of those that fill it.
double unevenness(const Building& building, const Script& script) {
  std::map<uint32_t, std::vector<const TreeNode*>> children;
  for (const TreeNode& node : building.tree) {
    if (node.parent != Shape::none) children[node.parent].push_back(&node);
  }
  double worst = 0;
  for (auto& [parent, parts] : children) {
    const Shape& whole = building.tree[parent].shape;
    if (whole.form != Form::rectangle || whole.symbol == script.symbol("Sized")) continue;
    const bool beside = parts[0]->shape.scope.size.x < whole.scope.size.x - 1e-9;
    const auto from = [&](const Shape& s) {
      return dot(s.scope.origin, beside ? whole.scope.x : whole.scope.y);
    };
    const auto size = [&](const Shape& s) { return beside ? s.scope.size.x : s.scope.size.y; };
    std::ranges::sort(parts, {}, [&](const TreeNode* part) { return from(part->shape); });
    double at = from(whole);
    for (const TreeNode* part : parts) {
      worst = std::max(worst, std::abs(from(part->shape) - at));
      at = from(part->shape) + size(part->shape);
    }
    worst = std::max(worst, std::abs(from(whole) + size(whole) - at));
  }
  return worst;
}

}  // namespace

TEST_CASE("groups of any elements fill the wall: no gaps, no overlaps, each as wide as it needs") {
  const Script script = Script::text(groups);
  REQUIRE(script.good());
  std::size_t windows = 0;
  for (uint64_t seed = 0; seed < 1500; ++seed) {
    CAPTURE(seed);
    const Building building = script.derive("rect:60x4", {.seed = seed, .keep_tree = true});
    REQUIRE(unevenness(building, script) < 1e-9);
    REQUIRE(building.terminals[script.symbol("FAILED")] == 0);
    REQUIRE(building.parts_cut == 0);
    const ReportEntry& missing = building.report.at("missing");
    REQUIRE(missing.most < 1e-9);
    windows += missing.count;
  }
  CHECK(windows > 30'000);
}

TEST_CASE("groups in too little room are cut at the end, and leave no gap either") {
  const Script script = Script::text(groups);
  REQUIRE(script.good());
  for (uint64_t seed = 0; seed < 1500; ++seed) {
    CAPTURE(seed);
    const std::string width = std::to_string(0.3 + 0.004 * static_cast<double>(seed));
    const Building building =
        script.derive("rect:" + width + "x4", {.seed = seed, .keep_tree = true});
    REQUIRE(unevenness(building, script) < 1e-9);
  }
}

TEST_CASE("what is derived is the same whether its building comes first or last") {
  const Script script = Script::text(groups);
  Derivation derivation(script.program(), script.meshes(), {.seed = 7});
  Building first, again, other;
  Footprint plot = footprint("rect:30x4"), next = footprint("rect:21x4");
  next.id = "next";
  derivation.derive(plot, first);
  derivation.derive(next, other);
  derivation.derive(plot, again);
  CHECK(first.surface.points == again.surface.points);
  CHECK(first.surface.points != other.surface.points);
}
