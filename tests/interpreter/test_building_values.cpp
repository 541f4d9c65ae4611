// What variables are worth before there is a shape.
#include <doctest/doctest.h>

#include "interpreter/building_values.hpp"
#include "interpreter/derivation.hpp"
#include "tests/styles/memory_files.hpp"

using namespace mansard;

namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;
using Giver = VariableValue::Giver;

/// The last style of a script in memory, compiled.
struct Compiled {
  explicit Compiled(const std::string& text, Settings settings = {}) : files(text), library(files) {
    library.load("main.style", diagnostics);
    CompileOptions options;
    options.settings = std::move(settings);
    options.abstract_too = true;
    program = compile(library, meshes, options, diagnostics);
    REQUIRE_MESSAGE(program, (diagnostics.all().empty() ? "" : diagnostics.all()[0].text));
  }

  NoMeshes meshes;
  MemoryFiles files;
  Library library;
  Diagnostics diagnostics;
  std::unique_ptr<Program> program;
};

VariableValue value(const Compiled& compiled, std::string_view block, std::string_view name,
                    const Footprint& footprint = {}, uint64_t seed = 0) {
  BuildingValues values(*compiled.program, footprint, seed);
  const auto found = values.variable(block, name);
  REQUIRE(found);
  return *found;
}

std::string text(const VariableValue& value) { return value.value.value_or("unknown"); }

Footprint with(std::vector<Property> properties) {
  Footprint footprint;
  footprint.properties = std::move(properties);
  return footprint;
}

const std::string script = R"(
style Base {
  var Pitch = rand(30, 45)
  var Height = attr("height", 7.5)
  Tile {
    var Wide = 0.9   var Words = ["a", BRICK]   var Twice = share(Wide)   var Room = W - Wide
    var Risen = Room + 1
    @per("shape") var Gap = rand(0, 1)   var Own = Pitch
    def share(x) = x * 2
    TILE : W > 2 -> set(Tile.Wide, 2) BRICK : Wide + 0.1
    TILE : else -> WALL : W
    TILE : else -> WALL
  }
}
style Narrow : Base { Tile { var Wide = 0.5 } }
)";

}  // namespace

TEST_CASE("values of a style, as a script would write them") {
  const Compiled compiled(script);
  CHECK(text(value(compiled, "Tile", "Wide")) == "0.5");
  CHECK(value(compiled, "Tile", "Wide").settable);
  CHECK(text(value(compiled, "Tile", "Words")) == "[\"a\", BRICK]");
  CHECK(text(value(compiled, "Tile", "Twice")) == "1");
  CHECK(!value(compiled, "Tile", "Twice").settable);
  const Footprint nowhere;
  BuildingValues values(*compiled.program, nowhere, 0);
  CHECK(!values.variable("Tile", "Widht"));
  CHECK(!values.variable("", "Wide"));
}

TEST_CASE("what a value depends on") {
  const Compiled compiled(script);
  const auto depends = [&](std::string_view block, std::string_view name) {
    const Dependence d = value(compiled, block, name).dependence;
    return std::string(d.shape ? "shape " : "") + (d.random ? "random " : "") +
           (d.footprint ? "footprint" : "") + (d.set ? "set" : "");
  };
  CHECK(depends("Tile", "Words").empty());
  CHECK(depends("Tile", "Wide") == "set");
  CHECK(depends("Tile", "Twice") == "set");
  CHECK(depends("Tile", "Room") == "shape set");
  CHECK(depends("Tile", "Risen") == "shape set");
  CHECK(depends("", "Pitch") == "random ");
  CHECK(depends("Tile", "Own") == "random ");
  CHECK(depends("Tile", "Gap") == "shape random ");
  CHECK(depends("", "Height") == "footprint");
  CHECK(text(value(compiled, "Tile", "Room")) == "unknown");
}

TEST_CASE("a draw is the one that the derivation makes") {
  const Compiled compiled(
      "style A { var Pitch = rand(30, 45) Mass { FOOTPRINT -> report(\"pitch\", Pitch) "
      "set(Pitch, 1) WALL } }");
  Footprint footprint;
  footprint.id = "house 7";
  footprint.polygon.points = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  footprint.polygon.tags.resize(4);
  footprint.polygon.ring_ends = {4};
  DeriveOptions options;
  options.seed = 12;
  NoMeshes meshes;
  Derivation derivation(*compiled.program, meshes, options);
  Building building;
  derivation.derive(footprint, building);
  const VariableValue pitch = value(compiled, {}, "Pitch", footprint, 12);
  CHECK(std::stod(text(pitch)) == doctest::Approx(building.report.at("pitch").sum).epsilon(1e-5));
  CHECK(text(value(compiled, {}, "Pitch", footprint, 13)) != text(pitch));
}

TEST_CASE("the command line is stronger than a property, that than the style") {
  const Footprint named = with({{"Tile.Wide", 0.7}, {"height", std::string("12 m")}});
  const Compiled plain(script), set(script, {{"Tile.Wide", "1 + 0.3"}});
  const VariableValue property = value(plain, "Tile", "Wide", named);
  CHECK(property.giver == Giver::property);
  CHECK(property.property == "0.7");
  CHECK(!property.command_line);
  CHECK(text(property) == "0.7");
  const VariableValue line = value(set, "Tile", "Wide", named);
  CHECK(line.giver == Giver::command_line);
  CHECK(line.command_line == "1 + 0.3");
  CHECK(line.property == "0.7");
  CHECK(text(line) == "1.3");
  CHECK(text(value(plain, "", "Height", named)) == "12");
  CHECK(text(value(plain, "Tile", "Twice", named)) == "1.4");
}

TEST_CASE("a property that does not fit is not taken, and says so") {
  const Compiled compiled(script);
  const VariableValue wide =
      value(compiled, "Tile", "Wide", with({{"Tile.Wide", std::string("broad")}}));
  CHECK(wide.giver == Giver::style);
  CHECK(text(wide) == "0.5");
  CHECK(wide.property == "broad");
  CHECK(wide.problem.find("\"broad\"") != std::string::npos);
}

TEST_CASE("a property settles what else each shape would") {
  const Compiled compiled(script);
  const VariableValue room = value(compiled, "Tile", "Room", with({{"Tile.Room", 3.0}}));
  CHECK(room.giver == Giver::property);
  CHECK(text(room) == "3");
  CHECK(!room.dependence.shape);
  CHECK(!room.dependence.abstract);
  CHECK(room.dependence.footprint);
}

TEST_CASE("weights of rules follow the variables") {
  const Compiled compiled(script);
  const Footprint nowhere;
  BuildingValues values(*compiled.program, nowhere, 0);
  const LinkedStyle& style = *compiled.program->styles[compiled.program->main_style].linked;
  const auto& rules = style.find_symbol("TILE")->generations[0].productions;
  CHECK(values.weight(*rules[0]) == doctest::Approx(0.6));
  CHECK(!values.weight(*rules[1]));
  CHECK(values.weight(*rules[2]) == 1);
}

TEST_CASE("an abstract variable has no value") {
  const std::string text_of = "style A { abstract var Wide var Two = 2 var Twice = Two * Wide }";
  const Compiled compiled(text_of), given(text_of, {{"Wide", "3"}});
  CHECK(text(value(compiled, {}, "Wide")) == "unknown");
  CHECK(text(value(compiled, {}, "Two")) == "2");
  CHECK(text(value(compiled, {}, "Twice")) == "unknown");
  CHECK(value(compiled, {}, "Twice").dependence.abstract);
  CHECK(text(value(given, {}, "Twice")) == "6");
}

TEST_CASE("a value that can not be evaluated says why") {
  const Compiled compiled("style A { var None = attr(\"n\", 0) var Share = 1 / None }");
  const VariableValue share = value(compiled, {}, "Share");
  CHECK(text(share) == "unknown");
  CHECK(share.problem.find("division by zero") == 0);
}
