// What every kind of roof and dormer must be.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>

#include "interpreter/roof_words.hpp"
#include "tests/laws/closed.hpp"
#include "tests/laws/derive.hpp"

namespace mansard::test {
namespace {

constexpr const char* all_parts =
    "slope : SLOPE | gable : GABLE | top : TOP | soffit : SOFFIT | fascia : FASCIA | parapet : "
    "PARAPET | lower : LOWER | upper : UPPER | ridge : report(\"ridge\", W) NIL | hip : "
    "report(\"hip\", W) NIL | valley : report(\"valley\", W) NIL | eave : report(\"eave\", W) NIL "
    "| "
    "rake : report(\"rake\", W) NIL";

std::string roofed(std::string_view kind, const std::string& options) {
  return "style A { Plot { FOOTPRINT -> extrude(4) comp { side : WALL | top : roof(\"" +
         std::string(kind) + "\"" + options + ") { " + all_parts + " } } } }";
}

/// "GABLE SLOPE eave rake ridge": the faces and lines that a building has.
std::string made(const Script& script, const Building& building) {
  std::string words;
  for (const char* const face :
       {"SLOPE", "LOWER", "UPPER", "GABLE", "TOP", "SOFFIT", "FASCIA", "PARAPET"}) {
    if (building.terminals[script.symbol(face)] > 0) words += std::string(face) + " ";
  }
  for (const auto& [line, entry] : building.report) words += line + " ";
  return words;
}

double reported(const Building& building, const std::string& key) {
  const auto entry = building.report.find(key);
  return entry == building.report.end() ? 0 : entry->second.sum;
}

}  // namespace

TEST_CASE("every kind of roof makes its faces and lines") {
  const std::map<std::string_view, std::string> expected{
      {"flat", "TOP "},
      {"hip", "SLOPE eave hip ridge "},
      {"gable", "SLOPE GABLE eave rake ridge "},
      {"half_hip", "SLOPE GABLE eave hip rake ridge "},
      {"dutch_hip", "SLOPE GABLE eave hip rake ridge "},
      {"pyramid", "SLOPE eave hip "},
      {"shed", "SLOPE GABLE eave rake "},
      {"mansard", "LOWER UPPER eave hip ridge "},
      {"gambrel", "LOWER UPPER GABLE eave rake ridge "},
      {"saltbox", "SLOPE GABLE eave rake ridge "},
      {"cross_gable", "SLOPE GABLE eave rake ridge valley "},
      {"sawtooth", "SLOPE GABLE eave rake valley "},
      {"barrel", "SLOPE GABLE eave rake ridge "},
  };
  for (const std::string_view kind : roof_kinds) {
    CAPTURE(kind);
    const Script script = Script::text(roofed(kind, ""));
    REQUIRE_MESSAGE(script.good(), script.problems());
    CHECK(made(script, script.derive("rect:14x8")) == expected.at(kind));
  }
  const Script slab = Script::text(roofed("flat", ", overhang = 0.3, parapet = 0.4"));
  CHECK(made(slab, slab.derive("rect:14x8")) == "TOP SOFFIT FASCIA PARAPET ");
  const Script wide = Script::text(roofed("gable", ", 40, 0.3, verge = 0.2"));
  CHECK(made(wide, wide.derive("L:12x9x5x4")) ==
        "SLOPE GABLE SOFFIT FASCIA eave hip rake ridge valley ");
}

TEST_CASE("buildings under every kind of roof are closed") {
  for (const std::string_view kind : roof_kinds) {
    for (const char* const options : {"", ", overhang = 0.35"}) {
      const Script script = Script::text(roofed(kind, options));
      for (const char* const literal : {"rect:12x9", "L:12x9x5x4", "T:14x10x4x6", "U:14x10x6x5",
                                        "ring:20x16x8x6", "WKT:POLYGON((0 0,9 1,11 7,4 9,-2 5))"}) {
        CAPTURE(kind);
        CAPTURE(options);
        CAPTURE(literal);
        const Building building = script.derive(literal);
        CHECK(open_length(building.surface, [](Vec3 p) { return p.y < 1e-6; }) < 1e-5);
        CHECK(volume_above(building.surface, 0) > 100);
      }
    }
  }
}

TEST_CASE("eaves run around roofs of slopes only") {
  for (const char* const kind : {"hip", "pyramid", "mansard"}) {
    const Script script = Script::text(roofed(kind, ""));
    for (const char* const literal : {"rect:12x9", "L:12x9x5x4", "T:14x10x4x6"}) {
      CAPTURE(kind);
      CAPTURE(literal);
      const double around = perimeter(footprint(literal).polygon);
      CHECK(reported(script.derive(literal), "eave") == doctest::Approx(around));
    }
  }
}

TEST_CASE("comp finds the lines that the roof itself names") {
  const std::string lines =
      "ridge : report(\"ridge\", W) NIL | hip : report(\"hip\", W) NIL | valley : "
      "report(\"valley\", W) NIL | eave : report(\"eave\", W) NIL | rake : report(\"rake\", W) NIL";
  for (const std::string_view kind : roof_kinds) {
    CAPTURE(kind);
    const Script whole =
        Script::text("style A { Plot { FOOTPRINT -> extrude(4) comp { top : roof(\"" +
                     std::string(kind) + "\") comp { " + lines + " } } } }");
    REQUIRE_MESSAGE(whole.good(), whole.problems());
    const Building one = whole.derive("L:12x9x5x4");
    const Building other = Script::text(roofed(kind, "")).derive("L:12x9x5x4");
    for (const char* const line : {"ridge", "hip", "valley", "eave", "rake"})
      CHECK(reported(one, line) == doctest::Approx(reported(other, line)));
  }
}

TEST_CASE("dormers that stay on their rectangle leave the roof closed") {
  for (const char* const dormer : {"\"flat\"", "\"shed\"", "\"shed\", 10", "\"eyebrow\""}) {
    CAPTURE(dormer);
    const Script script = Script::text(
        "style A { Plot { FOOTPRINT -> extrude(4) comp { side : WALL | top : roof(\"gable\", 45) { "
        "slope : SLOPE | gable : WALL } } SLOPE -> subdiv(\"Y\", 0.7, 2, 1r) { TILES | "
        "repeat(\"X\", 3) { subdiv(\"X\", 1r, 1.5, 1r) { TILES | DORMER | TILES } } | TILES } "
        "DORMER "
        "-> upright(" +
        std::string(dormer) + ") { front : A | cheek : B | top : C | slope : D } } }");
    REQUIRE_MESSAGE(script.good(), script.problems());
    for (const char* const literal : {"rect:12x9", "WKT:POLYGON((1 0,10 5,6 11,-3 6))"}) {
      CAPTURE(literal);
      const Building building = script.derive(literal);
      CHECK(open_length(building.surface, [](Vec3 p) { return p.y < 1e-6; }) < 1e-5);
    }
  }
}

}  // namespace mansard::test
