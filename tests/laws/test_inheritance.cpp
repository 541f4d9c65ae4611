// What styles inherit, in what they derive.
#include <doctest/doctest.h>

#include <filesystem>
#include <map>

#include "tests/laws/derive.hpp"

namespace {

using namespace mansard;
using namespace mansard::test;
namespace fs = std::filesystem;

// ---- an empty style over S derives S

/// The disk, and one script more.
class WithHeir final : public Files {
 public:
  explicit WithHeir(std::string text) : text_(std::move(text)) {}
  std::optional<std::string> read(const std::string& path) override {
    return path == heir ? std::optional(text_) : disk_.read(path);
  }
  bool exists(const std::string& path) override { return path == heir || disk_.exists(path); }

  static constexpr const char* heir = "heir.style";

 private:
  std::string text_;
  DiskFiles disk_;
};

/// All that a derivation gives, with the names of what runs and terminals are numbered by.
std::string bytes_of(const Script& script, const Footprint& on, uint64_t seed) {
  const Building building = script.derive(on, {.seed = seed, .keep_tree = true});
  std::string bytes;
  const auto add = [&](const auto& items) {
    bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(*items.data()));
  };
  const Surface& surface = building.surface;
  add(surface.points);
  add(surface.uvs);
  add(surface.ends);
  add(surface.normals);
  const Program& program = script.program();
  for (const Surface::Run& run : surface.runs) {
    const std::size_t shared = program.materials.size();
    const Material& look = run.material < shared ? program.materials[run.material]
                                                 : building.materials[run.material - shared];
    bytes += std::string(program.symbols[run.symbol]) + " " + look.name + " " + look.texture + " " +
             std::to_string(run.end) + " " + std::to_string(look.color.x + look.opacity) + "\n";
  }
  std::map<std::string, uint32_t> counts;
  for (uint32_t i = 0; i < building.terminals.size(); ++i) {
    if (building.terminals[i] > 0) counts.emplace(program.symbols[i], building.terminals[i]);
  }
  for (const auto& [symbol, count] : counts) bytes += symbol + std::to_string(count) + "\n";
  for (const auto& [key, entry] : building.report) {
    bytes += key + std::to_string(entry.sum) + "\n";
    for (const auto& [text, count] : entry.strings) bytes += text + std::to_string(count) + "\n";
  }
  for (const std::string& line : building.printed) bytes += line + "\n";
  for (const Diagnostic& d : building.warnings) bytes += std::string(d.code) + d.text + "\n";
  for (const TreeNode& node : building.tree) {
    bytes += std::string(program.symbols[node.shape.symbol]) + std::to_string(node.parent) + "\n";
  }
  return bytes;
}

/// Scripts whose styles are all derived, with what they need of a footprint.
std::vector<std::string> scripts() {
  std::vector<std::string> paths;
  for (const char* const folder : {"examples", "styles/library", "tests/golden/styles_run"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(MANSARD_ROOT) / folder)) {
      // The tutorial's mistake is one.
      if (entry.path().extension() == ".style" && entry.path().stem() != "mistake") {
        paths.push_back(fs::relative(entry.path(), MANSARD_ROOT).string());
      }
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// Names of the styles of a script that can be derived and have heirs.
std::vector<std::string> styles_in(const std::string& path) {
  DiskFiles disk;
  Library library(disk, {std::string(MANSARD_ROOT) + "/styles/library"});
  Diagnostics diagnostics;
  const syntax::File* file = library.load(std::string(MANSARD_ROOT) + "/" + path, diagnostics);
  std::vector<std::string> names;
  if (!file || diagnostics.has_errors()) return names;
  for (const syntax::Style& style : file->styles) {
    const auto linked = link(library, style, diagnostics);
    if (linked && linked->missing.empty() && !style.pre.final) names.emplace_back(style.name.text);
  }
  return names;
}

// ---- where a value comes from

/// What the variable of the style `Derived` is, said by report(); the shape of the rule that reads
/// it lies below a set() when `is_set`.
double value_of(bool overridden, bool property, bool is_set,
                std::vector<std::pair<std::string, std::string>> settings,
                const std::string& name = "Tile.Width") {
  const std::string block_default =
      "Tile { var Width = 1  TILE -> report(\"value\", Width) WALL } ";
  const std::string text = "style Base { var Wide = 1 " + block_default +
                           "Wide { SHAPE -> report(\"value\", Wide) WALL } Mass { FOOTPRINT -> " +
                           (is_set ? "set(" + name + ", 3) " : std::string()) +
                           (name == "Tile.Width" ? "TILE" : "SHAPE") +
                           " } } style Middle : Base { } style Derived : Middle { " +
                           (overridden ? "var Wide = 2  Tile { var Width = 2 }" : "") + " }";
  CompileOptions options;
  options.settings = std::move(settings);
  const Script script = Script::text(text, options);
  Footprint on = footprint("rect:10x8");
  if (property) on.properties.push_back({name, 4.0});
  return script.derive(on).report.at("value").sum;
}

}  // namespace

TEST_CASE("an empty style over S derives what S derives") {
  std::size_t compared = 0;
  Footprint plain = footprint("rect:10x8"), bent = footprint("L:14x11x6x5");
  for (Footprint* on : {&plain, &bent}) on->properties.push_back({"height", 8.0});
  for (const std::string& path : scripts()) {
    for (const std::string& name : styles_in(path)) {
      CAPTURE(path);
      CAPTURE(name);
      const Script base = Script::file(path, {{}, name});
      const Script heir = Script::files(
          std::make_unique<WithHeir>("import \"" + std::string(MANSARD_ROOT) + "/" + path +
                                     "\"\nstyle EmptyHeir : " + name + " { }\n"),
          WithHeir::heir);
      REQUIRE(base.good());
      REQUIRE(heir.good());
      for (const Footprint* on : {&plain, &bent}) {
        for (const uint64_t seed : {0, 7}) {
          const std::string expected = bytes_of(base, *on, seed);
          CHECK(expected.size() > 50);
          CHECK(bytes_of(heir, *on, seed) == expected);
        }
      }
      ++compared;
    }
  }
  CHECK(compared > 30);
}

TEST_CASE("the strongest word for a variable's value wins") {
  // set() on the shape is 3, the footprint's property 4, the command line 5 and 6.
  const std::vector<std::pair<std::string, std::string>> none_set, set{{"Tile.Width", "5"}},
      of_style{{"Derived::Tile.Width", "6"}},
      both{{"Derived::Tile.Width", "6"}, {"Tile.Width", "5"}};
  struct Row {
    bool overridden, property, is_set;
    const std::vector<std::pair<std::string, std::string>>& settings;
    double expected;
  };
  const std::vector<Row> rows{
      {false, false, false, none_set, 1},  // the base
      {true, false, false, none_set, 2},   // the most derived style
      {true, true, false, none_set, 4},    // a property of the footprint
      {false, true, false, none_set, 4},   //
      {true, true, true, none_set, 3},     // set() on an ancestor of the shape
      {true, false, true, none_set, 3},    //
      {true, true, true, set, 5},          // --set Block.Name
      {true, true, false, set, 5},         //
      {false, false, false, set, 5},       //
      {true, true, true, of_style, 6},     // --set Style::Block.Name
      {true, true, true, both, 6},         // which is stronger, whichever comes first
  };
  for (const Row& row : rows) {
    CAPTURE(&row - rows.data());
    CHECK(value_of(row.overridden, row.property, row.is_set, row.settings) == row.expected);
  }
}

TEST_CASE("style-wide variables are set by a bare name") {
  CHECK(value_of(true, false, false, {}, "Wide") == 2);
  CHECK(value_of(true, true, false, {}, "Wide") == 4);
  CHECK(value_of(true, true, true, {}, "Wide") == 3);
  CHECK(value_of(true, true, true, {{"Wide", "5"}}, "Wide") == 5);
  CHECK(value_of(true, true, true, {{"Derived::Wide", "6"}}, "Wide") == 6);
}

TEST_CASE("a bare property gives no variable of a block its value") {
  const Script script =
      Script::text("style S { Tile { var Width = 1 FOOTPRINT -> report(\"value\", Width) WALL } }");
  Footprint on = footprint("rect:10x8");
  on.properties.push_back({"Width", 4.0});
  CHECK(script.derive(on).report.at("value").sum == 1);
}

TEST_CASE("--set of one style leaves the others alone") {
  const std::string text =
      "style Shop { Tile { var Width = 1 SHOP -> report(\"shop\", Width) WALL } }\n"
      "style House { Tile { var Width = 1 FOOTPRINT -> report(\"house\", Width) Shop::SHOP } }";
  const auto sum = [&](const std::string& setting, const std::string& key) {
    CompileOptions options;
    options.settings = {{setting, "5"}};
    return Script::text(text, options).derive("rect:10x8").report.at(key).sum;
  };
  CHECK(sum("Shop::Tile.Width", "shop") == 5);
  CHECK(sum("Shop::Tile.Width", "house") == 1);
  CHECK(sum("Tile.Width", "shop") == 5);
  CHECK(sum("Tile.Width", "house") == 5);
}
