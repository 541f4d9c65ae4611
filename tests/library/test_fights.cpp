// The checks themselves: they find what is wrong with small bodies, and nothing with whole ones.
#include <doctest/doctest.h>

#include "tests/laws/derive.hpp"
#include "tests/library/fights.hpp"
#include "tests/library/sights.hpp"

using namespace mansard;
using namespace mansard::test;

namespace {

Surface made(const std::string& rules) {
  return Script::text("style Test { Test { " + rules + " } }").derive("rect:10x8").surface;
}

const std::string box = "FOOTPRINT -> extrude(6) { comp { side : A | top : B } } ";

}  // namespace

TEST_CASE("a whole box has neither fights nor backs") {
  const Surface surface = made(box);
  CHECK(fights(surface).empty());
  CHECK(backs_seen(surface, 2000, 1).empty());
}

TEST_CASE("faces over each other fight, whichever way they look") {
  CHECK(fights(made(box + "A -> [ X ] subdiv(\"X\", 1r, 1r) { Y | NIL }")).size() == 4);
  CHECK(fights(made(box + "A -> [ r(0, 180, 0) X ] Y")).size() == 0);  // turned about its corner
  CHECK(fights(made("FOOTPRINT -> extrude(6) comp { all : A } A -> [ t(0, 0, -1) s(1, 1, 1) box() "
                    "{ B } ] A2"))
            .size() >= 4);
}

TEST_CASE("faces side by side, crossing or a millimetre apart do not fight") {
  CHECK(fights(made(box + "A -> subdiv(\"X\", 1r, 1r) { X | Y }")).empty());
  CHECK(fights(made(box + "A -> [ t(0, 0, 0.001) X ] Y")).empty());
  CHECK(fights(made("FOOTPRINT -> [ extrude(6) A ] t(1, 1, 1) extrude(6) B")).empty());
}

TEST_CASE("gutters meet at outer and inner corners of eaves") {
  const auto gutters = [](const std::string& corners) {
    return Script::text(
               "style A { Plot { FOOTPRINT -> roof(\"hip\", 40) { slope : SLATE | eave : "
               "align(\"axes\") t(0, -0.1, 0) s(W, 0.1, 0) quad() { extrude(0.12" +
               corners + ") { GUTTER } } } } }")
        .derive("L:12x9x5x4")
        .surface;
  };
  CHECK(!fights(gutters("")).empty());
  CHECK(fights(gutters(", corners = \"mitre\"")).empty());
  CHECK(bounds(gutters(", corners = \"mitre\"").points).low.x == doctest::Approx(-0.12));
}

TEST_CASE("a gap shows backs, and so does a flipped face") {
  CHECK(
      backs_seen(made(box + "A -> subdiv(\"X\", 1r, 0.05, 1r) { X | NIL | Y }"), 20000, 1).size() >
      3);
  CHECK(backs_seen(made("FOOTPRINT -> extrude(6) comp { side : A } "), 2000, 1).size() > 100);
}
