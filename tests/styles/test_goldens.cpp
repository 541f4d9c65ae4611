// Every script of tests/golden/styles: all its styles are linked, as `mansard check` does. NAME.err
// holds what is then printed, NAME.out the last style when nothing was wrong. UPDATE_GOLDEN=1
// accepts.

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "styles/style.hpp"
#include "tests/styles/dump.hpp"

using namespace mansard;
namespace fs = std::filesystem;

namespace {

const fs::path root = MANSARD_ROOT;
const fs::path folder = root / "tests/golden/styles";

/// The disk as seen from one folder, so that the texts hold no path of this machine.
class FolderFiles final : public Files {
 public:
  explicit FolderFiles(fs::path base) : base_(std::move(base)) {}
  std::optional<std::string> read(const std::string& path) override {
    return disk_.read(base_ / path);
  }
  bool exists(const std::string& path) override { return disk_.exists(base_ / path); }

 private:
  fs::path base_;
  DiskFiles disk_;
};

void compare(const fs::path& golden, const std::string& actual) {
  if (std::getenv("UPDATE_GOLDEN")) {
    fs::remove(golden);
    if (!actual.empty()) std::ofstream(golden) << actual;
    return;
  }
  INFO(golden.filename().string());
  CHECK(actual == DiskFiles().read(golden).value_or(""));
}

void check_golden(const std::string& name) {
  FolderFiles files(folder);
  Library library(files, {"parts"});
  Diagnostics diagnostics;
  library.load(name + ".style", diagnostics);
  std::optional<LinkedStyle> last;
  for (const syntax::Style* style : library.styles()) last = link(library, *style, diagnostics);

  std::string out;
  if (last && !diagnostics.has_errors()) {
    out = dump_head(*last) + dump_body(*last);
    for (const Diagnostic& missing : last->missing) out += to_text(missing);
  }
  compare(folder / (name + ".out"), out);
  compare(folder / (name + ".err"), dump(diagnostics));
}

/// An empty heir of the last style of a script is that style.
void check_empty_heir(const std::string& text) {
  struct OneFile final : Files {
    std::optional<std::string> read(const std::string& path) override {
      return path == "main.style" ? std::optional(text) : FolderFiles(folder).read(path);
    }
    bool exists(const std::string&) override { return true; }
    std::string text;
  } files;
  files.text = text;
  Library library(files, {"parts"});
  Diagnostics diagnostics;
  library.load("main.style", diagnostics);
  const syntax::Style* style = library.default_style();
  if (!style || diagnostics.has_errors() || style->pre.final) return;
  const auto parent = link(library, *style, diagnostics);
  if (!parent || diagnostics.has_errors()) return;

  files.text += "\nstyle EmptyHeir : " + std::string(style->name.text) + " { }\n";
  Library with_heir(files, {"parts"});
  with_heir.load("main.style", diagnostics);
  const auto heir = link(with_heir, *with_heir.default_style(), diagnostics);
  REQUIRE(heir);
  CHECK(heir->name() == "EmptyHeir");
  CHECK(dump_body(*heir) == dump_body(*parent));
}

}  // namespace

TEST_CASE("golden styles") {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".style") names.insert(entry.path().stem());
  }
  CHECK(names.size() > 15);
  for (const std::string& name : names) {
    check_golden(name);
    check_empty_heir(*DiskFiles().read(folder / (name + ".style")));
  }
}

TEST_CASE("the listings of the thesis") {
  FolderFiles files(root / "styles/library");
  Library library(files);
  Diagnostics diagnostics;
  library.load("listings.style", diagnostics);
  REQUIRE(library.default_style());
  const auto style = link(library, *library.default_style(), diagnostics);
  CHECK(dump(diagnostics) == "");
  REQUIRE(style);
  compare(folder / "listings.out", dump_head(*style) + dump_body(*style));
}
