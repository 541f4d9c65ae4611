// Every script in tests/golden/derive and styles_run gives the shape tree and the mesh in the .out
// beside it, every one in errors the messages in its .err, every one in check what check says of
// it. A script says in its first comments what it is derived on: `// footprint: rect:10x8` (the
// default) and `// flags: --lod 2`. UPDATE_GOLDEN=1 accepts what comes out: read it first.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/run.hpp"

namespace {

namespace fs = std::filesystem;
using mansard::test::contents;
using mansard::test::Run;
using mansard::test::run;

struct Script {
  fs::path path;
  std::string footprint = "rect:10x8";
  std::vector<std::string> flags;

  explicit Script(const fs::path& file) : path(file) {
    std::istringstream text(contents(file));
    for (std::string line; std::getline(text, line) && line.starts_with("// ");) {
      constexpr std::string_view on = "// footprint: ", with = "// flags: ";
      if (line.starts_with(on)) footprint = line.substr(on.size());
      if (!line.starts_with(with)) continue;
      std::istringstream words(line.substr(with.size()));
      for (std::string word; words >> word;) flags.push_back(word);
    }
  }

  Run command(std::string name, const std::vector<std::string>& more) const {
    std::vector<std::string> words{std::move(name), path.filename().string(), footprint};
    words.insert(words.end(), flags.begin(), flags.end());
    words.insert(words.end(), more.begin(), more.end());
    return run(words, path.parent_path());
  }
};

std::string number(double v) {
  std::ostringstream out;
  out.precision(9);
  out << (std::abs(v) < 1e-9 ? 0 : v);
  return out.str();
}

/// "depth: 7", "use: shop 3, house 12".
std::string reported(const std::string& key, const nlohmann::ordered_json& entry) {
  std::string text = "report " + key + ":";
  if (!entry.contains("values")) {
    const bool one = entry["count"] == 1;
    return text + " " + number(entry["sum"]) +
           (one ? "\n"
                : " from " + entry["count"].dump() + ", " + number(entry["min"]) + " to " +
                      number(entry["max"]) + "\n");
  }
  for (const auto& [value, count] : entry["values"].items()) {
    text += " " + value + " " + count.dump();
  }
  return text + "\n";
}

/// The materials as the model's .mtl has them, without its comments and the plain one.
std::string looks(const fs::path& mtl) {
  std::string text;
  bool plain = false;
  std::istringstream lines(contents(mtl));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("newmtl")) plain = line == "newmtl plain";
    if (!line.empty() && line[0] != '#' && !plain) text += "  " + line + "\n";
  }
  return text.empty() ? text : "materials:\n" + text;
}

/// Counts and areas; no times.
std::string mesh_summary(const nlohmann::ordered_json& report) {
  std::string text = "mesh: " + report["polygons"].dump() + " polygons, " +
                     report["vertices"].dump() + " vertices, " + report["operations"].dump() +
                     " operations\n";
  for (const auto& [symbol, is] : report["terminals"].items()) {
    text += "  " + symbol + ": " + is["count"].dump() + ", area " + number(is["area"]) + "\n";
  }
  for (const char* const count : {"parts_cut", "shapes_without_production", "roof_fallbacks"}) {
    if (report[count] != 0) text += std::string(count) + ": " + report[count].dump() + "\n";
  }
  for (const auto& [key, entry] : report["report"].items()) text += reported(key, entry);
  return text;
}

std::string derived(const Script& script) {
  const mansard::test::TemporaryFolder folder;
  const Run tree = script.command("tree", {});
  CHECK_MESSAGE(tree.status == 0, tree.err);
  const Run derive = script.command(
      "derive", {"--quiet", "--report", folder / "report.json", "-o", folder / "model.obj"});
  CHECK_MESSAGE(derive.status == 0, derive.err);
  std::string text = tree.out + "\n" + tree.err;
  if (!tree.err.empty()) text += "\n";
  const auto report = nlohmann::ordered_json::parse(contents(folder / "report.json"), {}, false);
  if (report.is_discarded()) return text;
  return text + mesh_summary(report) + looks(folder.path() / "model.mtl");
}

std::string complaints(const Script& script) {
  const mansard::test::TemporaryFolder folder;
  const Run derive = script.command("derive", {"--quiet", "-o", folder / "model.obj"});
  CHECK(derive.out.empty());
  CHECK(derive.status <= 2);  // a fault of the program's is no result, whoever accepted it
  CHECK(fs::exists(folder / "model.obj") == (derive.status == 0));
  return derive.err + "exit status " + std::to_string(derive.status) + "\n";
}

/// What check says of a script, and whether it is content.
std::string checked(const Script& script) {
  std::vector<std::string> words{"check", script.path.filename().string()};
  words.insert(words.end(), script.flags.begin(), script.flags.end());
  const Run check = run(words, script.path.parent_path());
  CHECK(check.out.empty());
  CHECK(check.status <= 2);
  return check.err + "exit status " + std::to_string(check.status) + "\n";
}

template <class F>
void compare_folder(const std::string& folder, const char* ending, F result) {
  std::vector<fs::path> scripts;
  for (const auto& entry : fs::directory_iterator(fs::path(MANSARD_GOLDEN) / folder)) {
    if (entry.path().extension() == ".style") scripts.push_back(entry.path());
  }
  std::sort(scripts.begin(), scripts.end());
  CHECK_FALSE(scripts.empty());
  for (const fs::path& script : scripts) {
    CAPTURE(script.filename().string());
    const std::string text = result(Script(script));
    const fs::path expected = fs::path(script).replace_extension(ending);
    if (std::getenv("UPDATE_GOLDEN")) std::ofstream(expected, std::ios::binary) << text;
    CHECK(text == contents(expected));
  }
}

}  // namespace

TEST_CASE("what scripts derive") { compare_folder("derive", ".out", derived); }
TEST_CASE("what styles inherit shows in what they derive") {
  compare_folder("styles_run", ".out", derived);
}
TEST_CASE("what check warns of") { compare_folder("check", ".err", checked); }
TEST_CASE("what is wrong with scripts is said to the character") {
  compare_folder("errors", ".err", complaints);
}
