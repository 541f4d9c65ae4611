#include <doctest/doctest.h>

#include "styles/standing.hpp"
#include "styles/story.hpp"
#include "tests/styles/memory_files.hpp"

using namespace mansard;

namespace {

/// The stories of the last style of a script in memory.
struct Told {
  explicit Told(const std::string& text) : files(text), library(files) {
    library.load("main.style", diagnostics);
    REQUIRE(library.default_style());
    style = link(library, *library.default_style(), diagnostics);
    REQUIRE(style);
    stories.emplace(*style);
  }

  const Story& symbol(std::string_view name) const {
    const Story* story = stories->find(MemberKind::symbol, {}, name);
    REQUIRE(story);
    return *story;
  }
  const Story& variable(std::string_view block, std::string_view name) const {
    const Story* story = stories->find(MemberKind::variable, block, name);
    REQUIRE(story);
    return *story;
  }
  /// "TILE reads, var Tile.Wide sets": who speaks of it.
  std::string uses(const Story& story) const {
    constexpr const char* kinds[] = {"reads", "sets", "calls", "emits", "names"};
    std::string text;
    for (const Use& use : story.uses) {
      text += (text.empty() ? "" : ", ") + stories->speaker(use).full_name() + " " +
              kinds[static_cast<int>(use.kind)] + " '" + std::string(use.at.text()) + "'";
    }
    return text;
  }
  const Story* at(std::string_view words) const {
    const Span& name = library.default_style()->name.at;
    const auto place = name.source->text().rfind(words);
    return stories->at(*name.source, static_cast<uint32_t>(place));
  }

  MemoryFiles files;
  Library library;
  Diagnostics diagnostics;
  std::optional<LinkedStyle> style;
  std::optional<Stories> stories;
};

/// "Derived in force, Base hidden".
std::string fates(const std::vector<Writing>& writings) {
  constexpr const char* names[] = {"in force", "by super", "hidden",
                                   "dropped",  "answered", "unanswered"};
  std::string text;
  for (const Writing& writing : writings) {
    text += (text.empty() ? "" : ", ") + std::string(writing.from.style->name.text) + " " +
            names[static_cast<int>(writing.fate)];
  }
  return text;
}

}  // namespace

TEST_CASE("a variable's writings, the most derived first") {
  const Told told(
      "style A { Tile { var Wide = 1 TILE -> WALL } }\n"
      "style B : A { Tile { var Wide = 2 } }\n"
      "style C : B { Tile { var Wide = 3 } }");
  const Story& wide = told.variable("Tile", "Wide");
  CHECK(fates(wide.writings) == "C in force, B hidden, A hidden");
  CHECK(wide.full_name() == "Tile.Wide");
  CHECK(wide.in_force()->from.style->name.text == "C");
  CHECK(from_the_base(wide.writings).front()->from.style->name.text == "A");
  CHECK(wide.in_force()->name().text() == "Wide");
  CHECK(wide.in_force()->at().text() == "var Wide = 3");
}

TEST_CASE("'super' reaches as far as each rule goes on") {
  const Told told(
      "style A { Tile { TILE -> WALL } }\n"
      "style B : A { Tile { TILE -> GLASS } }\n"
      "style C : B { Tile { TILE -> [ TRIM ] super } }\n"
      "style D : C { Tile { TILE -> [ SILL ] super } }");
  CHECK(fates(told.symbol("TILE").writings) == "D in force, C by super, B by super, A hidden");
  CHECK(told.symbol("GLASS").terminal());
  CHECK(!told.symbol("TILE").terminal());
}

TEST_CASE("'replace' drops writings and is remembered") {
  const Told told(
      "style A { Tile { var Wide = 1 TILE -> WALL } }\n"
      "style B : A { replace Tile { TILE -> GLASS } }");
  const Story& wide = told.variable("Tile", "Wide");
  CHECK(fates(wide.writings) == "A dropped");
  CHECK(!wide.in_force());
  CHECK(wide.writings[0].replaced_by.style->name.text == "B");
  CHECK(fates(told.symbol("TILE").writings) == "B in force, A dropped");
}

TEST_CASE("'abstract' is answered by a value, a rule or an element") {
  const Told told(
      "style A { abstract var Wide abstract TILE abstract DOOR abstract ROOF }\n"
      "style B : A { var Wide = 2 Tile { TILE -> WALL } Elements { DOOR : \"door.obj\" } }");
  CHECK(fates(told.variable("", "Wide").writings) == "B in force, A answered");
  CHECK(fates(told.symbol("TILE").writings) == "B in force, A answered");
  CHECK(fates(told.symbol("DOOR").writings) == "A answered");
  CHECK(fates(told.symbol("ROOF").writings) == "A unanswered");
}

TEST_CASE("an entry is in force while an alternative of it is") {
  const Told told(
      "style A { Elements { DOOR : \"a.obj\" \"b.obj\" WINDOW : \"w.obj\" LEDGE : \"l.obj\" } }\n"
      "style B : A { Elements { DOOR + \"c.obj\" WINDOW : \"v.obj\" remove LEDGE } }\n"
      "style C : B { Elements { DOOR - \"c.obj\" } Materials { WALL : color(\"red\") } }");
  CHECK(fates(told.symbol("DOOR").elements) == "C in force, B hidden, A in force");
  CHECK(fates(told.symbol("WINDOW").elements) == "B in force, A hidden");
  CHECK(fates(told.symbol("LEDGE").elements) == "B in force, A hidden");
  CHECK(fates(told.symbol("WALL").materials) == "C in force");
  CHECK(told.style->ended_elements.size() == 3);
  for (const auto& [alternative, ending] : told.style->ended_elements) {
    const bool taken = alternative->at.text() == "\"c.obj\"";
    CHECK(ending.from.style->name.text == (taken ? "C" : "B"));
    const bool removed = alternative->at.text() == "\"l.obj\"";
    using enum syntax::EntryKind;
    CHECK(ending.how == (taken ? take : removed ? remove : set));
  }
}

TEST_CASE("taking away is over where a more derived style begins anew") {
  const Told told(
      "style A { Elements { DOOR : \"a.obj\" | \"b.obj\" } }\n"
      "style B : A { Elements { DOOR - \"a.obj\" } }\n"
      "style C : B { Elements { DOOR : \"c.obj\" } }");
  CHECK(fates(told.symbol("DOOR").elements) == "C in force, B hidden, A hidden");
}

TEST_CASE("who speaks of a member, under the names that the style gives them") {
  const Told told(
      "style A {\n"
      "  var Wide = 1  var Infill = BRICK\n"
      "  def share(x) = x * Wide\n"
      "  Tile { var Wide = 2  TILE(n) : W > Wide -> subdiv(\"X\", n, Wide) { Infill | PANE[n] } }\n"
      "  Floor { FLOOR[i] -> set(Tile.Wide, share(i)) split(\"X\") { Wide : TILE(Tile.Wide) } }\n"
      "  Roof { ROOF[Infill] -> t(Infill, Roof.Wide, 0) SLATE }\n"
      "  Grid { GRID(cell) -> comp { Wide : cell | top : inner(PANE) } inner(c) -> c } }");
  CHECK(told.uses(told.variable("Tile", "Wide")) ==
        "TILE reads 'Wide', TILE reads 'Wide', FLOOR sets 'Tile.Wide', FLOOR reads 'Tile.Wide'");
  CHECK(told.uses(told.variable("", "Wide")) == "share reads 'Wide', FLOOR reads 'Wide'");
  CHECK(told.uses(told.variable("", "Infill")) == "TILE reads 'Infill'");
  CHECK(told.uses(told.symbol("BRICK")) == "Infill names 'BRICK'");
  CHECK(told.uses(told.symbol("TILE")) == "FLOOR emits 'TILE'");
  CHECK(told.uses(told.symbol("PANE")) == "TILE emits 'PANE', GRID names 'PANE'");
  CHECK(told.uses(told.symbol("inner")) == "GRID emits 'inner'");
  const Story* share = told.stories->find(MemberKind::function, {}, "share");
  REQUIRE(share);
  CHECK(told.uses(*share) == "FLOOR calls 'share'");
  CHECK(!told.stories->find(MemberKind::symbol, {}, "n"));
  CHECK(!told.stories->find(MemberKind::symbol, {}, "subdiv"));
}

TEST_CASE("a name is found in every block, and at its place in the text") {
  const Told told(
      "style A { Tile { var Wide = 1 TILE -> WALL } Door { var Wide = 2 } }\n"
      "style B : A { Tile { TILE -> s(Wide, Door.Wide, 1) PANE } }");
  CHECK(told.stories->named("Wide").size() == 2);
  REQUIRE(told.stories->named("Door.Wide").size() == 1);
  CHECK(told.stories->named("Door.Wide")[0]->block == "Door");
  CHECK(told.stories->named("TILE").size() == 1);
  CHECK(told.stories->named("Tile.TILE").size() == 1);
  CHECK(told.stories->named("Roof.Wide").empty());
  CHECK(told.stories->named("Widht").empty());
  CHECK(told.at("Wide, Door") == &told.variable("Tile", "Wide"));
  CHECK(told.at("oor.Wide") == &told.variable("Door", "Wide"));
  CHECK(told.at("PANE") == &told.symbol("PANE"));
  CHECK(told.at(" PANE") == nullptr);
  CHECK(told.at("style B") == nullptr);
}

TEST_CASE("why styles stand where they do") {
  const Told told(
      "style House { }\n"
      "style Narrow : House { }\n"
      "style Shutters : House { }\n"
      "style Both : Narrow, Shutters, House { }");
  const auto all = standings(*told.style);
  REQUIRE(all.size() == 4);
  CHECK(!all[1].chooser);
  REQUIRE(all[2].chooser);
  CHECK(all[2].chooser->name.text == "Both");
  CHECK(all[2].first->name.text == "Narrow");
  CHECK(all[2].second->name.text == "Shutters");
  CHECK(!all[3].chooser);
  CHECK(all[0].parents == std::vector<uint32_t>{1, 2, 3});
  CHECK(all[3].heirs == std::vector<uint32_t>{0, 1, 2});
}

TEST_CASE("a parent named behind another is not its reason to come first") {
  const Told told("style P { } style Y : P { } style B { } style S : Y, B, P { }");
  const auto all = standings(*told.style);
  REQUIRE(all.size() == 4);
  CHECK(all[3].style->name.text == "P");
  REQUIRE(all[3].chooser);
  CHECK(all[3].first->name.text == "B");
  CHECK(all[3].second->name.text == "P");
}
