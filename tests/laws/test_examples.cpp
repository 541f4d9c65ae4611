// Every row's example does what the manual promises: it derives.
#include <doctest/doctest.h>

#include <cmath>

#include "interpreter/function.hpp"
#include "interpreter/operation.hpp"
#include "tests/laws/derive.hpp"

using namespace mansard;
using namespace mansard::test;

TEST_CASE("every operation's example derives") {
  std::size_t examples = 0;
  for (const Operation& operation : operations()) {
    CAPTURE(operation.name);
    CHECK_FALSE(operation.summary.empty());
    CHECK(operation.summary.ends_with('.'));
    if (operation.example.empty()) continue;
    ++examples;
    const Script script =
        Script::text("style Manual { Test { var Height = 3   FOOTPRINT -> " +
                     std::string(operation.example) + " } Materials { BRICK : color(\"tan\") } }");
    REQUIRE(script.good());
    const Building building = script.derive("rect:10x8", {.strict = true});
    CHECK(building.warnings.empty());
    CHECK(building.surface.polygons() > 0);
    for (const Vec3 p : building.surface.points) CHECK(std::isfinite(p.x + p.y + p.z));
  }
  CHECK(examples >= operations().size() - 3);  // insert and texture need a file, fail fails
}

TEST_CASE("every function's example has a value") {
  for (const Function& function : functions()) {
    CAPTURE(function.name);
    CHECK(function.summary.ends_with('.'));
    const std::string example(function.example);
    const bool scores = function.asks == Asks::outcome;  // of alternatives only
    const Script script = Script::text(
        "style Manual { Test { FOOTPRINT -> extrude(6) " +
        (scores ? "best(" + example + ") { report(\"floor area\", area) MASS | LAWN }" +
                      " report(\"value\", 1) } }"
                : "report(\"value\", " + example + ") MASS } }"));
    REQUIRE(script.good());
    const Building building = script.derive("rect:10x8");
    const ReportEntry& entry = building.report.at("value");
    CHECK(entry.count == 1);
    CHECK(std::isfinite(entry.sum));
  }
}
