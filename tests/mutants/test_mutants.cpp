// One slip in a sound script: every one is told on its line or the next, and nine of ten first
// messages name what it was. MANSARD_MUTANTS=1 prints them all.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "interpreter/program.hpp"
#include "styles/library.hpp"
#include "tests/mutants/mutants.hpp"

namespace fs = std::filesystem;

namespace mansard::test {

namespace {

/// The disk, with one file changed.
class Changed final : public Files {
 public:
  Changed(std::string path, std::string text) : path_(std::move(path)), text_(std::move(text)) {}
  std::optional<std::string> read(const std::string& path) override {
    return path == path_ ? text_ : disk_.read(path);
  }
  bool exists(const std::string& path) override { return disk_.exists(path); }
  std::string identity(const std::string& path) override { return disk_.identity(path); }

 private:
  DiskFiles disk_;
  std::string path_, text_;
};

class AnyMesh final : public MeshSource {
 public:
  const Mesh* mesh(const std::string&, std::string&) override { return &mesh_; }
  bool has_picture(const std::string&) override { return true; }

 private:
  Mesh mesh_;
};

struct Said {
  std::string first;                     ///< all words of the first message
  std::set<uint32_t> lines, note_lines;  ///< of messages; of the notes of the first
  std::string printed;
};

/// What `mansard check` says that it does not say of the original.
class Checker {
 public:
  Said check(const std::string& path, const std::string& text,
             const std::set<std::string>& known = {}) {
    Changed files(path, text);
    Library library(files, {std::string(MANSARD_ROOT) + "/styles/library"});
    Diagnostics diagnostics;
    CompileOptions options;
    options.all_styles = true;
    if (library.load(path, diagnostics) && !diagnostics.has_errors())
      compile(library, meshes_, options, diagnostics);
    diagnostics.sort();
    Said said;
    for (const Diagnostic& d : diagnostics.all()) {
      const std::string place = d.text + " " + std::to_string(line(d.at, path));
      all_.insert(place);
      if (!known.contains(place)) add(d, path, said);
    }
    return said;
  }
  const std::set<std::string>& all() const { return all_; }

 private:
  static uint32_t line(const Span& at, const std::string& path) {
    return at && at.source->name() == path ? at.source->position(at.begin).line : 0;
  }
  static void add(const Diagnostic& d, const std::string& path, Said& said) {
    said.lines.insert(line(d.at, path));
    for (const Span& at : d.also) said.lines.insert(line(at, path));
    if (!said.first.empty()) return;
    said.first = d.text + "\n" + d.help;
    for (const Note& note : d.notes) {
      said.first += "\n" + note.text;
      said.note_lines.insert(line(note.at, path));
    }
    said.printed = to_text(d);
  }

  AnyMesh meshes_;
  std::set<std::string> all_;
};

bool is_near(const std::set<uint32_t>& lines, uint32_t line) {
  return lines.contains(line - 1) || lines.contains(line) || lines.contains(line + 1);
}

bool names_cause(const Mutant& mutant, const std::string& message) {
  return std::any_of(mutant.causes.begin(), mutant.causes.end(), [&](const auto& words) {
    return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
      return message.find(word) != std::string::npos;
    });
  });
}

std::string line_of(const Mutant& mutant) {
  std::istringstream text(mutant.text);
  std::string line;
  for (uint32_t i = 0; i < mutant.line && std::getline(text, line); ++i) continue;
  return line;
}

/// A fixed set, so that an example more does not draw other slips everywhere.
constexpr std::array examples{
    "arcade",      "best",   "block",      "building3", "city",    "dormers",   "entrance",
    "first_house", "groups", "hidden",     "indexed",   "mixins",  "occlusion", "quarter/quarter",
    "roof_kinds",  "rows",   "shopfronts", "sills",     "snapped", "storeys"};

std::deque<Original> originals() {
  const fs::path root = MANSARD_ROOT;
  std::vector<fs::path> paths{root / "styles/library/listings.style"};
  for (const char* name : examples)
    paths.push_back(root / "examples" / (name + std::string(".style")));
  for (const auto& entry : fs::directory_iterator(root / "examples/tutorial")) {
    if (entry.path().extension() == ".style") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::deque<Original> all;
  for (const fs::path& path : paths) all.emplace_back(path.string(), *DiskFiles().read(path));
  return all;
}

}  // namespace

TEST_CASE("one slip in a script is told where it is, by its name") {
  const std::deque<Original> scripts = originals();
  std::map<std::string, std::set<std::string>> known;
  for (const Original& script : scripts) {
    Checker checker;
    checker.check(script.path(), script.text());
    known[script.path()] = checker.all();
  }
  const std::vector<Mutant> all = mutants(scripts, 7, 6);
  std::size_t named = 0;
  for (const Mutant& mutant : all) {
    const Said said = Checker().check(mutant.path, mutant.text, known[mutant.path]);
    const bool names = names_cause(mutant, said.first);
    const bool near =
        is_near(said.lines, mutant.line) || (names && is_near(said.note_lines, mutant.line));
    named += names;
    const bool show = std::getenv("MANSARD_MUTANTS") != nullptr;
    if (show)
      std::printf("%s%s%s: line %u of %s\n%s\n", near ? "" : "FAR ", names ? "" : "UNNAMED ",
                  mutant.kind.c_str(), mutant.line, mutant.path.c_str(), said.printed.c_str());
    CHECK_MESSAGE(near, mutant.kind << ", line " << mutant.line << " of " << mutant.path << "\n"
                                    << line_of(mutant) << "\n"
                                    << said.printed);
  }
  std::printf("%zu mutants, %zu first messages name the cause: %.1f %%\n", all.size(), named,
              100.0 * static_cast<double>(named) / static_cast<double>(all.size()));
  CHECK(all.size() >= 200);
  CHECK(named * 10 >= all.size() * 9);
}

}  // namespace mansard::test
