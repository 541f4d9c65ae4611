// What is said of command lines that people write who have not read the manual.
#include <doctest/doctest.h>

#include <fstream>

#include "tests/cli/run.hpp"

namespace {

using mansard::test::Run;
using mansard::test::run;
using mansard::test::TemporaryFolder;
using Words = std::vector<std::string>;

const char* const script = R"(style House {
    Mass  { FOOTPRINT -> extrude(6) { comp { side : FACADE } } }
    Tile  { var Width = 1.1   FACADE -> subdiv("X", 1r, Width, 1r) { WALL | DOOR | WALL } }
    Entry { var Width = 1.2   DOOR -> subdiv("X", 1r, Width, 1r) { WALL | LEAF | WALL } }
}
style Tall : House { Mass { FOOTPRINT -> extrude(9) { comp { side : FACADE } } } }
style Street { Plot { FOOTPRINT -> Tall::FOOTPRINT } }
)";

class Desk {
 public:
  Desk() {
    std::ofstream(folder_ / "house.style") << script;
    std::ofstream(folder_ / "street.geojson") << "{}";
  }
  /// Standard error, of a command that must fail with this status.
  std::string refused(int status, const Words& words) const {
    const Run done = run(words, folder_.path());
    CHECK_MESSAGE(done.status == status, done.err);
    return done.err;
  }
  std::string vary(int status, const Words& flags) const {
    Words words{"vary", "house.style", "rect:6x4", "-o", "x.png", "--size", "32x24"};
    words.insert(words.end(), flags.begin(), flags.end());
    return refused(status, words);
  }

 private:
  TemporaryFolder folder_;
};

bool has(const std::string& text, const std::string& words) {
  const bool found = text.find(words) != std::string::npos;
  CHECK_MESSAGE(found, text);
  return found;
}

}  // namespace

TEST_CASE("a variable that several blocks have") {
  const Desk desk;
  CHECK(has(desk.refused(1, {"tree", "house.style", "rect:6x4", "--set", "Width=2"}),
            "help: it belongs to blocks: --set Tile.Width or --set Entry.Width\n"));
  CHECK(has(desk.vary(1, {"--style", "House", "--sweep", "Width=1:2:1"}),
            "help: it belongs to blocks: --sweep Tile.Width or --sweep Entry.Width\n"));
}

TEST_CASE("a variable that other styles have") {
  const Desk desk;
  CHECK(has(desk.vary(1, {"--sweep", "Tile.Width=1:2:1"}),
            "help: styles 'House' and 'Tall' have it: add --style House\n"));
}

TEST_CASE("values that are no numbers, for a variable that is one") {
  const Desk desk;
  const auto set = [&](const std::string& value) {
    return desk.refused(1, {"tree", "house.style", "rect:6x4", "--set", "Tile.Width=" + value});
  };
  CHECK(has(set("1.2m"), "error: --set Tile.Width=1.2m: 'Tile.Width' is a number\n"));
  CHECK(has(set("1.2m"), "help: write 1.2: lengths are in metres and angles in degrees, without"));
  CHECK(has(set("1,2"), "help: one number, whose decimals have a point: 1.2\n"));
  CHECK(has(set("1:2:1"), "help: a range belongs to mansard vary: --sweep NAME=from:to:step\n"));
  CHECK(has(set("wide"), "help: write a number: 1.2\n"));
  const auto sweep = [&](int status, const std::string& values) {
    return desk.vary(status, {"--style", "House", "--sweep", "Tile.Width" + values});
  };
  CHECK(has(sweep(1, "=0.8..1.6"), "help: write a range as from:to:step\n"));
  CHECK(has(sweep(1, "=0,8:1,6:0,2"), "is a number, '8:1' is none"));
  CHECK(has(sweep(2, "=0.8-1.6"), "write a range as from:to:step, with ':' between them\n"));
  CHECK(has(sweep(1, ":0.8:1.6:0.2"), "help: write --sweep Tile.Width=0.8:1.6:0.2\n"));
  CHECK(has(sweep(1, "=1,wide"), "is a number, 'wide' is none"));
}

TEST_CASE("flags and lists") {
  const Desk desk;
  CHECK(has(desk.vary(2, {"--seeds", "6"}), "unknown flag '--seeds'; --count N draws N seeds"));
  CHECK(has(desk.vary(2, {"--styles", "House,", "Tall"}),
            "a space ends the list: write --styles House,Tall\n"));
  CHECK(has(desk.vary(2, {"--styles", "House", "--styles", "Tall"}),
            "'--styles' is given twice: write the names in one, A,B,C\n"));
  CHECK(has(desk.vary(1, {"--style", "House,Tall"}),
            "help: several styles are given by --styles A,B,C\n"));
  CHECK(has(desk.refused(2, {"render", "house.style", "rect:6x4", "-o", "x.jpg"}),
            "'x.jpg' has no ending that this version draws: it draws .png\n"));
}

TEST_CASE("what to build on, and files that are nearly there") {
  const Desk desk;
  CHECK(has(desk.refused(2, {"house.style"}),
            "a command stands first: mansard render house.style rect:10x8 -o picture.png\n"));
  CHECK(has(desk.refused(2, {"render", "house.style", "-o", "x.png"}),
            "say what to build on: mansard render house.style rect:10x8 -o x.png\n"));
  CHECK(has(desk.refused(1, {"render", "house.style", "9x8", "-o", "x.png"}),
            "help: a rectangle is written rect:9x8\n"));
  CHECK(has(desk.refused(1, {"render", "hosue.style", "rect:9x8", "-o", "x.png"}),
            "help: did you mean 'house.style'?\n"));
  CHECK(has(desk.refused(1, {"check", "house"}), "help: did you mean 'house.style'?\n"));
  CHECK(has(desk.refused(1, {"tree", "house.style", "stret.geojson"}),
            "help: did you mean 'street.geojson'?\n"));
}

TEST_CASE("imports and styles as other languages write them") {
  const TemporaryFolder folder;
  std::ofstream(folder / "house.style") << script;
  const auto said = [&](const std::string& text) {
    std::ofstream(folder / "mine.style") << text;
    const Run done = run({"check", "mine.style"}, folder.path());
    CHECK(done.status == 1);
    return done.err;
  };
  const std::string import = "help: another script is read by: import \"house.style\"\n";
  CHECK(has(said("import house\n"),
            "help: the name of a file stands in quotes: import \"house.style\"\n"));
  CHECK(has(said("include \"house.style\"\n"), import));
  CHECK(has(said("use \"house.style\"\n"), import));
  CHECK(has(said("#include \"house.style\"\n"), import));
  CHECK(has(said("import \"hosue.style\"\n"), "help: did you mean 'house.style'?\n"));
  CHECK(has(said("import \"house\"\n"), "help: did you mean 'house.style'?\n"));
  CHECK(has(said("style Mine : House { }\n"), "help: write at the top: import \"house.style\"\n"));
  const std::string parent = "help: a parent stands behind a ':': style Mine : House { … }\n";
  CHECK(has(said("style Mine(House) { }\n"), parent));
  CHECK(has(said("style Mine < House { }\n"), parent));
  CHECK(has(said("style Mine : House & Cornice { }\n"), "help: several parents are separated by"));
  CHECK(has(said("style \"Mine\" : House { }\n"), "help: a name bears no quotes\n"));
  CHECK(has(said(".mine { }\n"), "help: a style begins with its word: style mine { … }\n"));
  CHECK(has(said("mine : House { }\n"), "help: a style begins with its word: style mine …\n"));
}

TEST_CASE("a property that differs only in case from one that is read") {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.style")
      << "style A { var Tall = attr(\"height\", 3) Mass { FOOTPRINT -> extrude(Tall) { MASS } } }";
  const Run done = run({"tree", "a.style", "rect:6x4", "--attr", "HEIGHT=9"}, folder.path());
  CHECK(done.status == 0);
  CHECK(has(done.err, "warning[W021]: property 'HEIGHT' is not 'height', which a style reads\n"));
  CHECK(run({"tree", "a.style", "rect:6x4", "--attr", "height=9"}, folder.path()).err.empty());
}

TEST_CASE("the footprint's height is no misspelt variable Height") {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.style")
      << "style A { var Height = BUILDING_HEIGHT Mass { FOOTPRINT -> extrude(Height) { MASS } } }";
  const Run done = run({"tree", "a.style", "rect:6x4", "--attr", "height=9"}, folder.path());
  CHECK(done.status == 0);
  CHECK(done.err.empty());
}
