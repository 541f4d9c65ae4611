// Parts add up to the whole, over random sizes and shapes.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>
#include <sstream>

#include "interpreter/sizes.hpp"
#include "tests/laws/derive.hpp"

namespace {

using namespace mansard;
using namespace mansard::test;

std::string metres(double v) {
  std::ostringstream out;
  out.precision(17);
  out << v;
  return out.str();
}

/// A size as it is written, of any kind but don't-care.
std::string random_size(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  switch (random() % 4) {
    case 0:
      return metres(unit(random) * 3);
    case 1:
      return metres(unit(random) * 20) + "%";
    case 2:
      return metres(0.01 + unit(random) * 3) + "r";
    default:
      return "~" + metres(0.01 + unit(random) * 3);
  }
}

double extent(const TreeNode& node, char axis) {
  const Vec3 size = node.shape.scope.size;
  return axis == 'X' ? size.x : axis == 'Y' ? size.y : size.z;
}

}  // namespace

TEST_CASE("the parts of a subdiv add up to the scope") {
  std::mt19937 random(2006);
  for (int round = 0; round < 300; ++round) {
    CAPTURE(round);
    const double width = 0.5 + 30 * std::generate_canonical<double, 53>(random);
    std::string sizes = "1r", parts = "PART";
    for (std::size_t n = random() % 8; n > 0; --n) {
      sizes += ", " + random_size(random);
      parts += " | PART";
    }
    const char axis = "XYZ"[random() % 3];
    const std::string script = "style A { Plot { FOOTPRINT -> extrude(" + metres(width) +
                               ") subdiv(\"" + axis + "\", " + sizes + ") { " + parts + " } } }";
    CAPTURE(script);
    const Building building = Script::text(script).derive(
        "rect:" + metres(width) + "x" + metres(width), {.keep_tree = true});
    double sum = 0;
    for (const TreeNode& node : building.tree) sum += node.terminal ? extent(node, axis) : 0;
    CHECK(std::abs(sum - width) < 1e-9);
  }
}

TEST_CASE("shares are shares of what the others leave, floats fill or keep what they want") {
  using enum syntax::SizeKind;
  std::mt19937 random(2010);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 2000; ++round) {
    CAPTURE(round);
    const double whole = 0.5 + 20 * unit(random);
    std::vector<SizeValue> sizes;
    double fixed = 0, wanted = 0, shares = 0;
    for (std::size_t n = 1 + random() % 6; n > 0; --n) {
      const auto kind = std::array{absolute, percent, relative, floating}[random() % 4];
      sizes.push_back({kind, 0.01 + 3 * unit(random) * (kind == percent ? 10 : 1)});
      const double value = sizes.back().value;
      if (kind == absolute) fixed += value;
      if (kind == percent) fixed += value / 100 * whole;
      if (kind == floating) wanted += value;
      if (kind == relative) shares += value;
    }
    std::vector<double> lengths;
    const double left = solve_sizes(sizes, whole, lengths);
    REQUIRE(lengths.size() == sizes.size());
    double sum = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      sum += lengths[i];
      const double room = std::max(0.0, whole - fixed);
      const double expected = sizes[i].kind == absolute  ? sizes[i].value
                              : sizes[i].kind == percent ? sizes[i].value / 100 * whole
                              : sizes[i].kind == relative
                                  ? std::max(0.0, room - wanted) * sizes[i].value / shares
                              : shares > 0 && wanted <= room ? sizes[i].value
                                                             : sizes[i].value * room / wanted;
      CHECK(std::abs(lengths[i] - expected) < 1e-9);
    }
    CHECK(std::abs(sum + left - whole) < 1e-9);
  }
}

TEST_CASE("sizes of all kinds fill the room: 100,000 random splits") {
  using enum syntax::SizeKind;
  std::mt19937 random(2013);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> lengths;
  for (int round = 0; round < 100'000; ++round) {
    CAPTURE(round);
    const double whole = 0.5 + 20 * unit(random);
    std::vector<SizeValue> sizes;
    for (std::size_t n = 1 + random() % 8; n > 0; --n) {
      const auto kind = std::array{absolute, percent, relative, floating, dont_care}[random() % 5];
      SizeValue size{kind, 0.01 + 3 * unit(random) * (kind == percent ? 10 : 1)};
      if (kind == dont_care) {
        size.minimum = size.value * std::array{0.0, 0.5, unit(random), 1.0}[random() % 4];
        if (random() % 2 == 0) size.maximum = size.value * (1 + (random() % 2) * unit(random));
      }
      sizes.push_back(size);
    }
    lengths.clear();
    const double left = solve_sizes(sizes, whole, lengths);
    REQUIRE(lengths.size() == sizes.size());
    double sum = 0, shrinking = -1;
    bool gives_way = false, at_minimum = true, grows = false, all_full = true;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const SizeValue& s = sizes[i];
      sum += lengths[i];
      REQUIRE(lengths[i] >= 0);
      gives_way = gives_way || (s.kind != dont_care && s.kind != absolute && s.kind != percent &&
                                lengths[i] > 1e-9);
      if (s.kind != dont_care) continue;
      REQUIRE(lengths[i] >= s.minimum - 1e-9);
      REQUIRE(lengths[i] <= s.maximum + 1e-9);
      at_minimum = at_minimum && lengths[i] < s.minimum + 1e-9;
      grows = grows || lengths[i] > s.value + 1e-9;
      all_full = all_full && lengths[i] > s.maximum - 1e-9;
      if (lengths[i] < s.value - 1e-6) {  // all in proportion
        const double part = (lengths[i] - s.minimum) / (s.value - s.minimum);
        if (shrinking >= 0) REQUIRE(std::abs(part - shrinking) < 1e-4);
        shrinking = part;
      }
    }
    REQUIRE(std::abs(sum + left - whole) < 1e-9);
    if (left < -1e-9) REQUIRE((at_minimum && !gives_way));  // only then are parts cut
    if (left > 1e-9) REQUIRE((all_full && !gives_way));     // only then is a gap left
    if (shrinking >= 0) REQUIRE((!gives_way && !grows));
    if (grows) REQUIRE(!gives_way);
  }
}

TEST_CASE("repeat makes round(L / w) equal parts, at least one") {
  std::mt19937 random(2010);
  for (int round = 0; round < 300; ++round) {
    CAPTURE(round);
    const double length = 0.1 + 40 * std::generate_canonical<double, 53>(random);
    const double size = 0.2 + 12 * std::generate_canonical<double, 53>(random);
    const Building building = Script::text("style A { Plot { FOOTPRINT -> repeat(\"X\", " +
                                           metres(size) + ") { PART } } }")
                                  .derive("rect:" + metres(length) + "x3", {.keep_tree = true});
    const double count = std::max(1.0, std::round(length / size));
    REQUIRE(static_cast<double>(building.tree.size() - 1) == count);
    double sum = 0;
    for (const TreeNode& node : building.tree) {
      if (!node.terminal) continue;
      sum += node.shape.scope.size.x;
      CHECK(std::abs(node.shape.scope.size.x - length / count) < 1e-9);
    }
    CHECK(std::abs(sum - length) < 1e-9);
  }
}

TEST_CASE("the areas of comp add up to the surface") {
  const char* const literals[] = {"rect:12x9",      "L:12x9x5x4",
                                  "T:14x10x4x6",    "U:14x10x6x5",
                                  "ring:20x16x8x6", "WKT:POLYGON((0 0,9 1,11 7,4 9,-2 5))"};
  const Script whole = Script::text(
      "style A { Plot { FOOTPRINT -> report(\"plan\", area) report(\"around\", perimeter) "
      "extrude(6) "
      "Mass  Mass -> report(\"surface\", area) comp { all : FACE } } }");
  const Script sides = Script::text(
      "style A { Plot { FOOTPRINT -> extrude(6) comp { top : FACE | bottom : FACE | court : FACE | "
      "main : FACE | side : FACE } } }");
  for (const char* const literal : literals) {
    CAPTURE(literal);
    const Building all = whole.derive(literal), each = sides.derive(literal);
    const double expected = 2 * all.report.at("plan").sum + 6 * all.report.at("around").sum;
    CHECK(all.report.at("surface").sum == doctest::Approx(expected).epsilon(1e-12));
    CHECK(area_of(all, whole.symbol("FACE")) == doctest::Approx(expected).epsilon(1e-12));
    CHECK(area_of(each, sides.symbol("FACE")) == doctest::Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("slices of any plan add up to its area") {
  const char* const literals[] = {"rect:12x9",      "L:12x9x5x4",
                                  "T:14x10x4x6",    "U:14x10x6x5",
                                  "ring:20x16x8x6", "WKT:POLYGON((0 0,9 1,11 7,4 9,-2 5))"};
  for (const char* const literal : literals) {
    for (const char* const axis : {"\"X\"", "\"Z\"", "30", "-77"}) {
      CAPTURE(literal);
      CAPTURE(axis);
      const Script script = Script::text(
          std::string(
              "style A { Plot { FOOTPRINT -> report(\"plan\", area) extrude(2) comp { top : "
              "repeat(") +
          (axis[1] == 'Z' ? "\"Y\"" : axis) + ", 1.7) { PART } } } }");
      const Building building = script.derive(literal);
      CHECK(area_of(building, script.symbol("PART")) ==
            doctest::Approx(building.report.at("plan").sum).epsilon(1e-9));
    }
  }
}
