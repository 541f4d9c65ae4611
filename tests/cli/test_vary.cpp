// Contact sheets and the child styles that reproduce their pictures.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/run.hpp"

namespace {

namespace fs = std::filesystem;
using mansard::test::contents;
using mansard::test::Run;
using mansard::test::run;
using mansard::test::TemporaryFolder;
using mansard::test::written;
using Words = std::vector<std::string>;

const char* const script = R"(style House {
    @range(3, 6, 1) var Height = 4
    Mass   { FOOTPRINT -> extrude(Height) { comp { side : FACADE | top : ROOF } } }
    Facade { FACADE -> repeat("X", 2) { TILE } }
    Tile {
        @range(0.6, 1.4, 0.2) var Width = 1
        @choice("oak", "elm") var Frame = "oak"
        var Infill = GLASS   var Sill = choose(0.8, 1.0)
        TILE   -> subdiv("X", 1r, Width, 1r) { WALL | Column | WALL }
        Column -> subdiv("Y", Sill, 1, 1r) { WALL | label(Frame) Infill | WALL }
    }
    Roof { var Kind = "flat"   ROOF -> roof(Kind, 30) { slope : TILES | gable : WALL | top : DECK } }
}
style Broad : House { Tile { var Width = 1.3 } }
)";

/// A folder with the script and `mansard vary house.style rect:6x4 … -o sheet.png` in it.
class Atelier {
 public:
  Atelier() { write("house.style", script); }
  void write(const std::string& name, const std::string& text) const {
    written(folder_, name, text);
  }
  std::string operator/(const std::string& name) const { return folder_ / name; }
  const fs::path& path() const { return folder_.path(); }
  Run vary(const Words& flags) const {
    Words words{"vary", "house.style", "rect:6x4", "-o", "sheet.png", "--size", "32x24"};
    words.insert(words.end(), flags.begin(), flags.end());
    return run(words, folder_.path());
  }
  std::vector<std::string> files(const std::string& in, const std::string& ending) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path() / in)) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(ending)) names.push_back(name);
    }
    std::ranges::sort(names);
    return names;
  }
  bool has_sheet() const { return contents(folder_ / "sheet.png").starts_with("\x89PNG"); }

 private:
  TemporaryFolder folder_;
};

/// Every exported style, derived with no flag, gives its model's bytes.
std::size_t reproduced(const Atelier& atelier, const std::string& in,
                       const std::string& footprint = "rect:6x4", const Words& more = {}) {
  const TemporaryFolder again;
  std::size_t count = 0;
  for (const std::string& name : atelier.files(in, ".style")) {
    CAPTURE(name);
    CHECK(std::ranges::count(contents(atelier / (in + "/" + name)), '\n') == 3);
    const std::string model = fs::path(name).replace_extension(".obj").string();
    Words words{"derive", in + "/" + name, footprint, "-o", again / model, "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const Run derive = run(words, atelier.path());
    CHECK_MESSAGE(derive.status == 0, derive.err);
    const std::string bytes = contents(again / model);
    CHECK(bytes.size() > 1000);
    CHECK(bytes == contents(atelier / (in + "/" + model)));
    const std::string looks = fs::path(name).replace_extension(".mtl").string();
    CHECK(contents(again / looks) == contents(atelier / (in + "/" + looks)));
    ++count;
  }
  return count;
}

/// A model without its comments, which name the style.
std::string faces(const std::string& path) {
  std::istringstream lines(contents(path));
  std::string text;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("#") && !line.starts_with("mtllib")) text += line + "\n";
  return text;
}

}  // namespace

TEST_CASE("a property that is nearly a variable of every style is told") {
  const Atelier atelier;
  atelier.write("two.style",
                "import \"house.style\"\nstyle Wide : House { Tile { var Widths = 2 TILE -> "
                "extrude(Widths / 10) WALL } }");
  const Words two{"vary",   "two.style", "rect:6x4", "-o",        "two.png",
                  "--size", "32x24",     "--styles", "House,Wide"};
  const auto told = [&](const std::string& property) {
    Words words(two);
    words.insert(words.end(), {"--attr", property});
    const Run vary = run(words, atelier.path());
    CHECK_MESSAGE(vary.status == 0, vary.err);
    return vary.err.find("W021") != std::string::npos;
  };
  CHECK(told("Tile.Widht=2"));
  CHECK_FALSE(told("Tile.Widths=2"));  // of one of the two
  CHECK_FALSE(told("Tile.Width=2"));
}

TEST_CASE("twelve seeds, as many as asked, from the one that is asked") {
  const Atelier atelier;
  const Run twelve = atelier.vary({});
  CHECK(twelve.status == 0);
  CHECK(twelve.err == "12 variations: sheet.png (style Broad, the last of 2)\n");
  CHECK(atelier.has_sheet());
  const Run three = atelier.vary({"--count", "3", "--seed", "7", "--export", "out"});
  CHECK(three.err ==
        "3 models and styles: out\n3 variations: sheet.png (style Broad, the last of 2)\n");
  CHECK(atelier.files("out", ".style") ==
        Words{"01-seed-7.style", "02-seed-8.style", "03-seed-9.style"});
  CHECK(
      contents(atelier / "out/02-seed-8.style") ==
      "// made by mansard vary\nimport \"../house.style\"\n@seed(8) style Broad_02 : Broad { }\n");
  CHECK(reproduced(atelier, "out") == 3);
}

TEST_CASE("each exported style derives its model again") {
  const Atelier atelier;
  CHECK(atelier.vary({"--styles", "House,Broad", "--export", "styles"}).status == 0);
  CHECK(reproduced(atelier, "styles") == 2);
  CHECK(atelier.vary({"--sweep", "Tile.Width=0.6:1.4:0.2", "--seed", "5", "--export", "sweep"})
            .status == 0);
  CHECK(atelier.files("sweep", ".obj").size() == 5);
  CHECK(reproduced(atelier, "sweep") == 5);
  CHECK(atelier
            .vary({"--sweep", "Roof.Kind=gable,hip", "--sweep", "Tile.Width=0.8,1.2", "--set",
                   "Height=5", "--export", "deep"})
            .status == 0);
  CHECK(reproduced(atelier, "deep") == 4);
  CHECK(atelier.vary({"--count", "2", "--lod", "2", "--attr", "height=9", "--export", "flags"})
            .status == 0);
  CHECK(reproduced(atelier, "flags", "rect:6x4", {"--lod", "2", "--attr", "height=9"}) == 2);
}

TEST_CASE("a variation is what --set and --seed give") {
  const Atelier atelier;
  REQUIRE(
      atelier.vary({"--sweep", "Roof.Kind=gable,hip", "--seed", "3", "--export", "out"}).status ==
      0);
  REQUIRE(run({"derive", "house.style", "rect:6x4", "--set", "Roof.Kind=hip", "--seed", "3", "-o",
               "set.obj", "--quiet"},
              atelier.path())
              .status == 0);
  const Words models = atelier.files("out", ".obj");
  CHECK(models == Words{"01-Roof.Kind-gable.obj", "02-Roof.Kind-hip.obj"});
  CHECK(faces(atelier / ("out/" + models[1])) == faces(atelier / "set.obj"));
  CHECK(faces(atelier / ("out/" + models[0])) != faces(atelier / "set.obj"));
}

TEST_CASE("@range and @choice say what to sweep, also those of a parent") {
  const Atelier atelier;
  CHECK(atelier.vary({"--sweep", "Tile.Width", "--export", "range"}).status == 0);
  CHECK(atelier.files("range", ".style") ==
        Words{"01-Tile.Width-0.6.style", "02-Tile.Width-0.8.style", "03-Tile.Width-1.style",
              "04-Tile.Width-1.2.style", "05-Tile.Width-1.4.style"});
  CHECK(atelier.vary({"--sweep", "Tile.Frame", "--sweep", "Height", "--export", "both"}).status ==
        0);
  CHECK(atelier.files("both", ".style").size() == 8);
  CHECK(contents(atelier / "both/08-Tile.Frame-elm-Height-6.style")
            .find("Tile { var Frame = \"elm\" } var Height = 6 }") != std::string::npos);
  const Run none = atelier.vary({"--sweep", "Tile.Sill"});
  CHECK(none.status == 1);
  CHECK(none.err.find("house.style:8:") != std::string::npos);
  CHECK(none.err.find("--sweep Tile.Sill=from:to:step") != std::string::npos);
}

TEST_CASE("values are read as the variable's") {
  const Atelier atelier;
  CHECK(atelier.vary({"--sweep", "Tile.Infill=GLASS,PANEL", "--export", "out"}).status == 0);
  CHECK(contents(atelier / "out/02-Tile.Infill-PANEL.style").find("var Infill = PANEL }") !=
        std::string::npos);
  CHECK(atelier.vary({"--sweep", "Tile.Frame=\"a, b\",c\\d,12,it's", "--export", "text"}).status ==
        0);
  CHECK(contents(atelier / "text/01-Tile.Frame-a-b.style").find("Frame = \"a, b\" }") !=
        std::string::npos);
  CHECK(contents(atelier / "text/02-Tile.Frame-c-d.style").find("Frame = \"c\\\\d\" }") !=
        std::string::npos);
  CHECK(contents(atelier / "text/03-Tile.Frame-12.style").find("Frame = \"12\" }") !=
        std::string::npos);
  CHECK(reproduced(atelier, "text") == 4);
}

TEST_CASE("wrong sweeps, styles and counts say what is right") {
  const Atelier atelier;
  const auto says = [&](const Words& flags, int status, const char* text) {
    const Run wrong = atelier.vary(flags);
    CAPTURE(wrong.err);
    CHECK(wrong.status == status);
    CHECK(wrong.err.find(text) != std::string::npos);
    CHECK_FALSE(fs::exists(atelier / "sheet.png"));
  };
  says({"--sweep", "Tile.Wdth=1,2"}, 1, "did you mean 'Tile.Width'?");
  says({"--sweep", "Tile.Width=0.6:1.4"}, 2, "from:to:step");
  says({"--sweep", "Tile.Width=0.6:1.4:0"}, 2, "does not lead");
  says({"--sweep", "Tile.Width=0:1:0.0001"}, 2, "more than 400");
  says({"--sweep", "Tile.Width=1,,2"}, 2, "a value is missing");
  says({"--sweep", "=1"}, 2, "--sweep takes NAME=");
  says({"--styles", "House,Braod"}, 1, "did you mean 'Broad'?");
  says({"--styles", "House", "--sweep", "Height", "--count", "2"}, 2, "rows and columns");
  says({"--count", "0"}, 2, "1 to 400");
  says({"--count", "400", "--size", "4000x3000"}, 2, "smaller --size");
  says({"--set", "Tile.Wdth=2"}, 1, "did you mean 'Tile.Width'?");
}

TEST_CASE("a variation that fails ends the run, or shows why") {
  const Atelier atelier;
  const Words fails{"--sweep", "Height=-1,4,\"wide\"", "--export", "out"};
  const Run ended = atelier.vary(fails);
  CHECK(ended.status == 1);
  CHECK_FALSE(fs::exists(atelier / "sheet.png"));
  CHECK_FALSE(fs::exists(atelier / "out"));
  Words going = fails;
  going.emplace_back("--keep-going");
  const Run gone = atelier.vary(going);
  CHECK(gone.status == 1);
  CHECK(gone.err.find("note: in the picture 'Height = -1'") != std::string::npos);
  CHECK(gone.err.find("03-Height-wide.style:3:") != std::string::npos);
  CHECK(atelier.has_sheet());
  CHECK(atelier.files("out", ".style") == Words{"02-Height-4.style"});
}

TEST_CASE("--export writes over its own files and no others") {
  const Atelier atelier;
  const Words once{"--count", "1", "--export", "out"};
  CHECK(atelier.vary(once).status == 0);
  CHECK(atelier.vary(once).status == 0);
  atelier.write("out/01-seed-0.style", "// mine\n");
  const Run refused = atelier.vary(once);
  CHECK(refused.status == 1);
  CHECK(refused.err.find("out/01-seed-0.style") != std::string::npos);
  CHECK(contents(atelier / "out/01-seed-0.style") == "// mine\n");
  fs::remove_all(atelier.path() / "out");
  fs::create_directory(atelier.path() / "out");
  atelier.write("out/01-seed-0.obj", "# mine\n");
  CHECK(atelier.vary(once).status == 1);
  CHECK(contents(atelier / "out/01-seed-0.obj") == "# mine\n");

  // A variation of a variation, in the same folder, must not import itself.
  CHECK(atelier.vary({"--count", "1", "--export", "self"}).status == 0);
  const std::string before = contents(atelier / "self/01-seed-0.style");
  const Run self = run(
      {"vary", "01-seed-0.style", "rect:6x4", "--count", "1", "--export", ".", "-o", "sheet.png"},
      atelier.path() / "self");
  CHECK(self.status == 1);
  CHECK(self.err.find("which is read") != std::string::npos);
  CHECK(contents(atelier / "self/01-seed-0.style") == before);
  const Run deeper = run({"vary", "self/01-seed-0.style", "rect:6x4", "--count", "2", "--seed", "4",
                          "--export", "deeper", "-o", "sheet.png", "--size", "32x24"},
                         atelier.path());
  CHECK(deeper.status == 0);
  CHECK(reproduced(atelier, "deeper") == 2);
}

TEST_CASE("a style carries its seed; --seed is stronger") {
  const Atelier atelier;
  const auto model = [&](const std::string& style, const Words& flags) {
    atelier.write("seeded.style", "import \"house.style\"\n" + style);
    Words words{"derive", "seeded.style", "rect:9x7", "-o", "seeded.obj"};
    words.insert(words.end(), flags.begin(), flags.end());
    const Run derive = run(words, atelier.path());
    CHECK_MESSAGE(derive.status == 0, derive.err);
    return faces(atelier / "seeded.obj");
  };
  std::string plain, other;  // of two seeds that differ
  int seed = 0;
  do {
    plain = model("style S : House { }", {});
    other = model("style S : House { }", {"--seed", std::to_string(++seed)});
  } while (plain == other && seed < 50);
  REQUIRE(plain != other);
  const std::string at = "@seed(" + std::to_string(seed) + ") ";
  CHECK(model(at + "style S : House { }", {}) == other);
  CHECK(model(at + "style S : House { }", {"--seed", "0"}) == plain);
  CHECK(model(at + "style P : House { } style S : P { }", {}) == other);
  CHECK(model(at + "style P : House { } @seed(0) style S : P { }", {}) == plain);
  CHECK(model(at + "style P : House { } style S : House { S { FOOTPRINT -> P::FOOTPRINT } }", {}) ==
        plain);
}

TEST_CASE("what has no effect is said") {
  const Atelier atelier;
  atelier.write("house.style", R"(style House {
    Mass { FOOTPRINT -> set(Mass.Height, 5) B   B -> extrude(Height) MASS   var Height = 3 }
})");
  const Run alike = atelier.vary({"--count", "2"});
  CHECK(alike.err.find("note: all 2 variations are alike") != std::string::npos);
  const Run stronger = atelier.vary({"--sweep", "Mass.Height=3,4"});
  CHECK(stronger.err.find("'Mass.Height' is also given by set()") != std::string::npos);
}

TEST_CASE("a picture appears whole or not at all") {
  const Atelier atelier;
  const auto render = [&](const std::string& out) {
    return run({"render", "house.style", "rect:6x4", "--size", "32x24", "-o", out}, atelier.path());
  };
  fs::create_directories(atelier.path() / "folder.png");
  const Run folder = render("folder.png"), nowhere = render("no/such/folder.png");
  CHECK(folder.status == 1);
  CHECK(folder.err.find("Is a directory") != std::string::npos);
  CHECK(nowhere.status == 1);
  CHECK(nowhere.err.find("No such file or directory") != std::string::npos);
  fs::create_symlink("/dev/full", atelier.path() / "full.png");
  CHECK(render("full.png").err.find("No space left on device") != std::string::npos);
  CHECK(render("house.png").status == 0);
  CHECK(atelier.files(".", ".part").empty());
}
