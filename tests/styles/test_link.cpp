#include <doctest/doctest.h>

#include "styles/style.hpp"
#include "tests/styles/dump.hpp"
#include "tests/styles/memory_files.hpp"

using namespace mansard;

namespace {

/// A script in memory, linked for its last style.
struct Linked {
  explicit Linked(const std::string& text) : files(text), library(files) {
    library.load("main.style", diagnostics);
    REQUIRE(library.default_style());
    style = link(library, *library.default_style(), diagnostics);
  }
  std::string complaints() {
    std::string text;
    diagnostics.sort();
    for (const Diagnostic& diagnostic : diagnostics.all()) {
      text += std::string(diagnostic.code) + (diagnostic.code.empty() ? "" : " ") +
              diagnostic.text + "\n";
    }
    return text;
  }

  MemoryFiles files;
  Library library;
  Diagnostics diagnostics;
  std::optional<LinkedStyle> style;
};

}  // namespace

TEST_CASE("the look-ups of a linked style") {
  Linked linked(
      "style A { var Wide = 1 def twice(x) = 2 * x  Tile { var Wide = 2 TILE -> WALL } }");
  REQUIRE(linked.style);
  const LinkedStyle& style = *linked.style;
  CHECK(linked.complaints() == "");
  REQUIRE(style.find_symbol("TILE"));
  CHECK(!style.find_symbol("WALL"));
  CHECK(style.find_variable("", "Wide")->block.empty());
  CHECK(style.find_variable("Tile", "Wide")->from.block->name.text == "Tile");
  CHECK(!style.find_variable("Floor", "Wide"));
  CHECK(style.find_function("", "twice"));
  CHECK(!style.find_function("Tile", "twice"));
  CHECK(style.has_block("Tile"));
  CHECK(!style.has_block("Floor"));
  CHECK(style.start == "FOOTPRINT");
  CHECK(!style.start_at);
}

TEST_CASE("'replace' takes away what earlier mixins give in that block, too") {
  Linked linked(
      "style Base { Tile { var A = 1 TILE -> WALL } }\n"
      "style Left : Base { replace Tile { TILE -> GLASS } }\n"
      "style Right : Base { Tile { var B = 2 } }\n"
      "style Both : Left, Right { }");
  REQUIRE(linked.style);
  CHECK(linked.complaints() == "");
  CHECK(!linked.style->find_variable("Tile", "A"));
  CHECK(!linked.style->find_variable("Tile", "B"));
  CHECK(linked.style->find_symbol("TILE")->generations.size() == 1);
}

TEST_CASE("two unrelated parents are named once, where they meet") {
  const std::string parents =
      "style A { X { FOO -> a } }\nstyle B { Y { FOO -> b } }\n"
      "style Both : A, B { }\n";
  CHECK(Linked(parents).complaints() == "W003 'FOO' comes from both 'A' and 'B', and 'A' wins\n");
  Linked heir(parents + "style Heir : Both { }");
  CHECK(heir.complaints() == "W003 'FOO' comes from both 'A' and 'B', and 'A' wins\n");
  CHECK(heir.diagnostics.all().front().at.text() == "Both");
  CHECK(Linked(parents + "style Heir : Both { X { FOO -> c } }").complaints() == "");
  CHECK(Linked(parents + "style Heir : Both { X { FOO -> [ c ] super } }").complaints() == "");
}

TEST_CASE("override and super settle two unrelated parents") {
  const auto complaints = [](const std::string& in_a) {
    return Linked("style Base { X { FOO -> x } }\nstyle A : Base { X { " + in_a +
                  " } }\nstyle B : Base { X { FOO -> b } }\nstyle Both : A, B { }")
        .complaints();
  };
  CHECK(complaints("FOO -> a") != "");
  CHECK(complaints("override FOO -> a") == "");
  CHECK(complaints("FOO -> super") == "");
  CHECK(complaints("FOO -> extrude(1) { a | [ super ] }") == "");
  CHECK(complaints("FOO -> if W > 1 { a } else { super }") == "");
}

TEST_CASE("super goes through a mixin to the two that disagree") {
  CHECK(Linked("style A { X { FOO -> a } }\nstyle B { X { FOO -> b } }\n"
               "style M { X { FOO -> [ m ] super } }\nstyle All : M, A, B { }")
            .complaints() == "W003 'FOO' comes from both 'A' and 'B', and 'A' wins\n");
}

TEST_CASE("an ancestor's mistake is told once, however many heirs are linked") {
  Linked linked(
      "style Base { Tile { var Wide = 1 var Wide = 2 override FOO -> x } }\n"
      "style A : Base { Elements { WINDOW - \"a.obj\" } }\n"
      "style B : A { }");
  const std::size_t errors = linked.diagnostics.errors();
  CHECK(errors == 3);
  for (const syntax::Style* style : linked.library.styles()) {
    link(linked.library, *style, linked.diagnostics);
  }
  CHECK(linked.diagnostics.errors() == errors);
}

TEST_CASE("a mesh that another parent replaced is not the taker's mistake") {
  Linked linked(
      "style Base { Elements { WINDOW : \"a.obj\" \"b.obj\" } }\n"
      "style Take : Base { Elements { WINDOW - \"a.obj\" } }\n"
      "style Set : Base { Elements { WINDOW : \"c.obj\" } }\n"
      "style Both : Take, Set { }");
  CHECK(linked.complaints() == "");
  CHECK(linked.style->elements.size() == 1);
}

TEST_CASE("a mixin given a value answers an abstract of another parent") {
  const std::string parents =
      "style Asks { abstract var Wide Tile { abstract TILE abstract DOOR } }\n"
      "style Gives { var Wide = 1 Tile { TILE -> WALL } Elements { DOOR : \"d.obj\" } }\n";
  CHECK(Linked(parents + "style Both : Asks, Gives { }").style->missing.empty());
  CHECK(Linked(parents + "style One : Asks { }").style->missing.size() == 3);
}

TEST_CASE("hostile sizes link in reasonable time") {
  std::string text = "style Base { Tile {\n";
  for (int i = 0; i < 3000; ++i) {
    const std::string n = std::to_string(i);
    text += "var V" + n + " = " + n + " override R" + n + " -> A TILE : " + n + " -> B\n";
  }
  text += "} }\nstyle Heir : Base { Floor { TILE -> WALL override TILF -> WALL } }";
  Linked linked(text);
  CHECK(linked.diagnostics.errors() == 3001);
}
