// Every script in tests/golden/explain says in its first comments what is asked of it:
// `// explain: Both TILE --set Tile.Width=2`. The .out beside it holds the questions and what the
// program answers. UPDATE_GOLDEN=1 accepts what comes out: read it first.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "grammar/utf8.hpp"
#include "tests/cli/run.hpp"

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using mansard::test::contents;
using mansard::test::Run;
using mansard::test::run;
using Words = std::vector<std::string>;

const fs::path root = MANSARD_ROOT;
const fs::path golden = fs::path(MANSARD_GOLDEN) / "explain";

struct Asked {
  fs::path folder;
  Words words;  ///< from "explain" on
};

std::string printed(const Words& words) {
  std::string line = "$ mansard";
  for (const std::string& word : words) line += " " + word;
  return line + "\n";
}

/// The questions in a script's first comments.
std::vector<Asked> questions(const fs::path& script) {
  std::vector<Asked> all;
  std::istringstream text(contents(script));
  constexpr std::string_view sign = "// explain:";
  for (std::string line; std::getline(text, line) && line.starts_with("// ");) {
    if (!line.starts_with(sign)) continue;
    Asked asked{script.parent_path(), {"explain", script.filename().string()}};
    std::istringstream words(line.substr(sign.size()));
    for (std::string word; words >> word;) asked.words.push_back(word);
    all.push_back(std::move(asked));
  }
  return all;
}

std::string answers(const std::vector<Asked>& questions) {
  std::string text;
  for (const Asked& asked : questions) {
    const Run done = run(asked.words, asked.folder);
    text += (text.empty() ? "" : "\n") + printed(asked.words) + done.out + done.err;
    if (done.status != 0) text += "exit status " + std::to_string(done.status) + "\n";
  }
  return text;
}

void compare(const std::string& text, const fs::path& expected) {
  CAPTURE(expected.filename().string());
  if (std::getenv("UPDATE_GOLDEN")) std::ofstream(expected, std::ios::binary) << text;
  CHECK(text == contents(expected));
}

std::vector<fs::path> scripts() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(golden)) {
    if (entry.path().extension() == ".style") found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// What is asked of styles that stand elsewhere.
struct Elsewhere {
  std::string golden;
  fs::path folder;
  std::vector<Words> questions;

  std::vector<Asked> asked() const {
    std::vector<Asked> all;
    for (const Words& words : questions) {
      Asked& made = all.emplace_back(Asked{folder, {"explain"}});
      made.words.insert(made.words.end(), words.begin(), words.end());
    }
    return all;
  }
};

const std::vector<Elsewhere> elsewhere{
    {"listings.out",
     root / "styles/library",
     {{"listings.style"},
      {"listings.style", "TILE"},
      {"listings.style", "Tile.WLedgeHeight"},
      {"listings.style", "Building2", "WINDOW"},
      {"listings.style", "GROUND_FLOOR"},
      {"listings.style", "Building1", "GroundFloorHeight", "--set", "Facade.GroundFloorHeight=2"}}},
    {"quarter.out",
     root / "examples/quarter",
     {{"quarter.style", "Villa"},
      {"quarter.style", "Villa", "Tile.WindowWidth"},
      {"quarter.style", "Villa", "ROOF"},
      {"quarter.style", "Villa", "WALL"},
      {"quarter.style", "Block", "Roof.Rise", "--attr", "height=12"},
      {"quarter.style", "Villa", "Rise"},
      {"quarter.style", "Terrace", "GroundFloor", "--footprint", "rect:10x8"}}},
    {"mixins.out", root / "examples", {{"mixins.style"}, {"mixins.style", "FACADE"}}},
};

std::vector<Asked> all_questions() {
  std::vector<Asked> all;
  const auto add = [&](const std::vector<Asked>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  for (const fs::path& script : scripts()) add(questions(script));
  for (const Elsewhere& place : elsewhere) add(place.asked());
  return all;
}

std::size_t columns_of(const std::string& line) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < line.size();) {
    const mansard::CodePoint character = mansard::decode(line, at);
    width += static_cast<std::size_t>(mansard::columns(character.value));
    at += character.bytes;
  }
  return width;
}

/// The text of a source from the place that a piece of JSON gives.
std::string at_place(const Json& json, const fs::path& folder) {
  std::istringstream text(contents(folder / json["file"].get<std::string>()));
  std::string line;
  for (int n = json["line"]; n > 0; --n) std::getline(text, line);
  std::string rest = line.substr(json["column"].get<std::size_t>() - 1) + "\n";
  while (std::getline(text, line)) rest += line + "\n";
  return rest;
}

void check_member(const Json& member, const fs::path& folder) {
  for (const Json& writing : member["writings"]) {
    CHECK(at_place(writing, folder).starts_with(writing["text"].get<std::string>()));
    CHECK(!writing["fate"].get<std::string>().empty());
  }
  const std::string name = member["name"];
  for (const Json& use : member["uses"]) {
    const std::string there = at_place(use, folder);
    CHECK(there.substr(0, there.find_first_of(" ,(){}[]\n")).ends_with(name));
  }
}

}  // namespace

TEST_CASE("what is explained of styles") {
  CHECK(scripts().size() > 10);
  for (const fs::path& script : scripts()) {
    const auto asked = questions(script);
    CHECK(!asked.empty());
    compare(answers(asked), fs::path(script).replace_extension(".out"));
  }
  for (const Elsewhere& place : elsewhere) compare(answers(place.asked()), golden / place.golden);
}

TEST_CASE("an explanation fits a page of a hundred columns and ends no line with a space") {
  for (const Asked& asked : all_questions()) {
    CAPTURE(printed(asked.words));
    std::istringstream text(run(asked.words, asked.folder).out);
    for (std::string line; std::getline(text, line);) {
      CHECK_MESSAGE(columns_of(line) <= 100, line);
      CHECK_MESSAGE(!line.ends_with(' '), line);
      CHECK(line.find('\x1b') == std::string::npos);
    }
  }
}

TEST_CASE("--json says the same with places that are right") {
  for (Asked asked : all_questions()) {
    CAPTURE(printed(asked.words));
    const Run text = run(asked.words, asked.folder);
    asked.words.push_back("--json");
    const Run json = run(asked.words, asked.folder);
    CHECK(json.status == text.status);
    CHECK(json.out.empty() == text.out.empty());
    if (json.out.empty()) continue;
    const Json parsed = Json::parse(json.out, nullptr, false);
    REQUIRE(!parsed.is_discarded());
    CHECK(parsed["order"][0]["style"] == parsed["style"]);
    CHECK(!parsed["members"].empty());
    for (const Json& member : parsed["members"]) check_member(member, asked.folder);
  }
}

TEST_CASE("--json tells a story in full") {
  const auto member = [](const Words& words) {
    Words all{"explain"};
    all.insert(all.end(), words.begin(), words.end());
    all.push_back("--json");
    const Run done = run(all, golden);
    CHECK(done.err.empty());
    return Json::parse(done.out)["members"].at(0);
  };
  const Json width = member({"precedence.style", "Tile.Width", "--attr", "Tile.Width=0.7"});
  CHECK(width["kind"] == "variable");
  CHECK(width["full_name"] == "Tile.Width");
  CHECK(width["in_force"]["value"] == "0.7");
  CHECK(width["in_force"]["giver"] == "property");
  CHECK(width["in_force"]["settable"] == true);
  CHECK(width["writings"][0]["style"] == "Base");
  CHECK(width["writings"][0]["fate"] == "hidden");
  CHECK(width["writings"][1]["fate"] == "in force");
  const Json facade = member({"mixin_with_super.style", "FACADE"});
  CHECK(facade["writings"][1]["super"] == "House");
  CHECK(facade["writings"][2]["super"] == "Plinth");
  const Json shares = member({"probabilities.style", "FACADE", "--set", "Shops=1"});
  CHECK(shares["writings"][0]["share"] == 0.25);
  CHECK(shares["writings"][0]["condition"] == "H > 4 && W > 3");
  CHECK(shares["writings"][3]["else"] == true);
  const Json door = member({"elements.style", "Child", "DOOR"});
  CHECK(door["elements"].size() == 3);
  CHECK(door["elements"][2]["ended_by"]["style"] == "Child");
  CHECK(door["elements"][2]["ended_by"]["how"] == "take");
  const Json docs = member({"imports.style", "Tile.Width"});
  CHECK(docs["writings"][0]["docs"][0] == "The clear width of the opening.");
  CHECK(docs["writings"][0]["annotations"][0] == "@range(0.4, 2.2, 0.1)");
}
