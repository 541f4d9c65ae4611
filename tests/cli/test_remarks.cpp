// What derive, render, vary and tree tell of what they derived.
#include <doctest/doctest.h>

#include <fstream>

#include "tests/cli/run.hpp"

namespace {

using mansard::test::Run;
using mansard::test::run;
using mansard::test::TemporaryFolder;
using Words = std::vector<std::string>;

/// A folder with a script, and commands in it.
class Desk {
 public:
  explicit Desk(const std::string& script) { std::ofstream(folder_ / "house.style") << script; }
  std::string said(const std::string& command, const Words& more = {},
                   const std::string& footprint = "rect:6x4") const {
    Words words{command, "house.style", footprint};
    if (command == "derive") words.insert(words.end(), {"-o", "house.obj"});
    if (command == "render" || command == "vary")
      words.insert(words.end(), {"--size", "32x24", "-o", "house.png"});
    words.insert(words.end(), more.begin(), more.end());
    const Run done = run(words, folder_.path());
    CHECK_MESSAGE(done.status == 0, done.err);
    return done.err;
  }

 private:
  TemporaryFolder folder_;
};

const char* const two_styles = R"(style House { Plot { FOOTPRINT -> extrude(3) { MASS } } }
style Mine : House { }
)";

const char* const tiles = R"(style House {
    Mass   { FOOTPRINT -> extrude(4) { comp { side : FACADE } } }
    Facade { FACADE -> repeat("X", 2) { TILE } }
    Tile   {
        var Width = 1
        TILE : fits -> subdiv("X", 0.5, Width, 0.5) { WALL | PANE | WALL }
        TILE : else -> WALL
    }
}
)";

bool has(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("the style that was taken is named where a script has several") {
  const Desk desk(two_styles);
  CHECK(desk.said("render") == "picture: house.png (style Mine, the last of 2)\n");
  CHECK(desk.said("render", {"--style", "House"}) == "picture: house.png\n");
  CHECK(has(desk.said("derive"), "kB: house.obj (style Mine, the last of 2)\n"));
  CHECK(desk.said("vary", {"--count", "1"}) ==
        "1 variation: house.png (style Mine, the last of 2)\n");
  CHECK(has(desk.said("vary", {"--styles", "House,Mine"}), "\n2 variations: house.png\n"));
  CHECK(Desk(tiles).said("render") == "picture: house.png\n");
}

TEST_CASE("a window that never fits is told by all that derive") {
  const std::string note = "note: 'TILE : fits' (house.style:6) held for none of 10 shapes\n";
  const Desk desk(tiles);
  for (const char* const command : {"derive", "render", "tree"}) {
    CHECK_FALSE(has(desk.said(command), "note: "));
    CHECK(has(desk.said(command, {"--set", "Tile.Width=1.5"}), note));
  }
  const std::string sheet = desk.said("vary", {"--sweep", "Tile.Width=1:1.6:0.2"});
  CHECK(has(sheet, "note: in the picture 'Tile.Width = 1.2' 'TILE : fits' (house.style:6) held "));
  CHECK_FALSE(has(sheet, "1.4"));  // once is enough
}

TEST_CASE("a design for smaller shapes that was taken instead is no misfit") {
  const Desk desk(R"(style House {
    Mass { FOOTPRINT -> extrude(4) { MASS } }
    Rest { MASS : fits -> subdiv("X", 9, 1r) { A | B }
           MASS : else W > 1 -> B
           MASS : else -> NIL }
}
)");
  CHECK_FALSE(has(desk.said("derive"), "note: "));
}

TEST_CASE("parts that were cut are told with the rules that cut them") {
  const Desk desk(R"(style House {
    Mass   { FOOTPRINT -> extrude(4) { comp { side : FACADE } } }
    Facade { FACADE -> subdiv("X", 3, 2, 1r) { A | B | FACE }
             FACE   -> subdiv("Y", 5, 1r) { C | D } }
}
)");
  const std::string note =
      "note: 4 parts of splits were cut for want of room: 2 in 'FACE' (house.style:4), 2 in "
      "'FACADE' (house.style:3)\n";
  for (const char* const command : {"derive", "render", "tree"}) {
    const std::string told = desk.said(command);
    CHECK_MESSAGE(has(told, note), told);
  }
}

TEST_CASE("render warns of what derive warns of") {
  const Desk desk(R"(style House {
    Mass { FOOTPRINT -> extrude(4) { MASS } }
    Rest { MASS : W > 99 -> A }
}
)");
  for (const char* const command : {"derive", "render", "tree"}) {
    CHECK(has(desk.said(command), "warning[W010]"));
  }
  CHECK(has(desk.said("vary", {"--count", "2"}), "warning[W010]"));
}

namespace {

/// A facade whose floors snap in X and Y, in a style with or without something to snap to.
std::string snapping(const std::string& mass, const std::string& shop) {
  return "style House {\n    Mass { FOOTPRINT -> " + mass +
         "   MASS -> comp { front : FACADE } }\n"
         "    Facade {\n"
         "        FACADE -> subdiv(\"YS\", 2, 1r) { " +
         shop +
         " | FLOOR }\n"
         "        FLOOR  -> repeat(\"XS\", 1) { TILE }\n    }\n}\n";
}

const std::string one_mass = "extrude(4) MASS";

}  // namespace

TEST_CASE("splits that snap and never meet a line are told of at the end, once each") {
  const std::string nothing =
      "note: \"YS\" in 'FACADE' (house.style:4) snapped to nothing: no plane was recorded, and no "
      "other mass meets its own\n"
      "note: \"XS\" in 'FLOOR' (house.style:5) snapped to nothing: no plane was recorded, and no "
      "other mass meets its own\n";
  CHECK(Desk(snapping(one_mass, "SHOP")).said("tree") == nothing);
  CHECK(Desk(snapping(one_mass, "SHOP")).said("tree", {}, "rect:1x1") == nothing);
  const std::string recorded = Desk(snapping(one_mass, "snap(\"YZ\") SHOP")).said("tree");
  CHECK(recorded ==
        "note: \"YS\" in 'FACADE' (house.style:4) snapped to nothing: planes were recorded, but "
        "not before its round; a later @stage of 'FACADE' sees them\n");
  const std::string across = Desk(snapping("[ snap(\"XY\") ] " + one_mass, "SHOP")).said("tree");
  CHECK(has(across,
            "\"XS\" in 'FLOOR' (house.style:5) snapped to nothing: no plane crosses its shape\n"));
  CHECK(Desk(snapping("[ extrude(4) MASS ] t(0, 0, 2) s(2, 0, 4) extrude(3) MASS",
                      "snap(\"YZ\") SHOP"))
            .said("tree")
            .empty());
}

TEST_CASE("a label that nothing bears in a run is told of") {
  const Desk desk(R"(style House {
    Mass { FOOTPRINT : W > 50 -> snap("XZ", "rare") FOOTPRINT   FOOTPRINT : else -> extrude(4) comp { front : FACADE } }
    Facade { FACADE -> repeat("YS", 1, to = "rare") { FLOOR } }
})");
  CHECK(desk.said("tree") ==
        "note: \"YS\" in 'FACADE' (house.style:3) snapped to nothing: no plane and no mass that "
        "meets its own has this label\n");
}
