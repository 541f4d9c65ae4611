#include <doctest/doctest.h>

#include "styles/library.hpp"
#include "tests/styles/dump.hpp"
#include "tests/styles/memory_files.hpp"

using namespace mansard;

namespace {

std::string names(const Library& library) {
  std::string text;
  for (const syntax::Style* style : library.styles()) text += std::string(style->name.text) + " ";
  return text;
}

}  // namespace

TEST_CASE("imports stand before the file that names them, each file read once") {
  MemoryFiles files{
      {"town/main.style", "import \"parts/a.style\" import \"b.style\" style Main { }"},
      {"town/parts/a.style", "import \"../b.style\" style A { }"},
      {"town/b.style", "style B { }"}};
  Diagnostics diagnostics;
  Library library(files);
  REQUIRE(library.load("town/main.style", diagnostics));
  CHECK(dump(diagnostics) == "");
  CHECK(names(library) == "B A Main ");
  CHECK(files.reads["town/b.style"] == 1);
  REQUIRE(library.default_style());
  CHECK(library.default_style()->name.text == "Main");
  CHECK(Library::folder_of(library.find("A")->at) == "town/parts");
}

TEST_CASE("files that import each other are fine") {
  MemoryFiles files{{"a.style", "import \"b.style\" style A : B { }"},
                    {"b.style", "import \"a.style\" import \"b.style\" style B { }"}};
  Diagnostics diagnostics;
  Library library(files);
  REQUIRE(library.load("./a.style", diagnostics));
  CHECK(dump(diagnostics) == "");
  CHECK(names(library) == "B A ");
}

TEST_CASE("an import is looked for beside the file, then along the style path") {
  MemoryFiles files{{"main.style", "import \"x.style\""},
                    {"one/y.style", ""},
                    {"two/x.style", "style Two { }"},
                    {"three/x.style", "style Three { }"}};
  Diagnostics diagnostics;
  Library library(files, {"one", "two", "three"});
  REQUIRE(library.load("main.style", diagnostics));
  CHECK(dump(diagnostics) == "");
  CHECK(names(library) == "Two ");
  CHECK(!library.default_style());
}

TEST_CASE("a missing import says where it was looked for and spoils nothing else") {
  MemoryFiles files{{"town/main.style", "import \"x.style\"\nstyle Main { }\n"}};
  Diagnostics diagnostics;
  Library library(files, {"lib"});
  REQUIRE(library.load("town/main.style", diagnostics));
  REQUIRE(diagnostics.errors() == 1);
  const Diagnostic& missing = diagnostics.all().front();
  CHECK(missing.text == "there is no file 'x.style' to import");
  CHECK(missing.at.text() == "\"x.style\"");
  REQUIRE(missing.notes.size() == 2);
  CHECK(missing.notes[0].text == "looked for 'town/x.style'");
  CHECK(missing.notes[1].text == "looked for 'lib/x.style'");
  CHECK(names(library) == "Main ");
}

TEST_CASE("a script that is not there is an error without a place") {
  MemoryFiles files{{"a.style", ""}};
  Diagnostics diagnostics;
  Library library(files);
  CHECK(!library.load("b.style", diagnostics));
  REQUIRE(diagnostics.errors() == 1);
  CHECK(diagnostics.all().front().text == "there is no file 'b.style'");
  CHECK(!diagnostics.all().front().at);
}

TEST_CASE("a library loads several scripts, and one again for its default style") {
  MemoryFiles files{{"a.style", "style A { } style A2 { }"}, {"b.style", "style B { }"}};
  Diagnostics diagnostics;
  Library library(files);
  const syntax::File* a = library.load("a.style", diagnostics);
  library.load("b.style", diagnostics);
  CHECK(library.default_style() == library.find("B"));
  CHECK(library.load("a.style", diagnostics) == a);
  CHECK(library.default_style() == library.find("A2"));
  CHECK(names(library) == "A A2 B ");
  CHECK(dump(diagnostics) == "");
}

TEST_CASE("an endless chain of imports ends") {
  struct Endless final : Files {
    std::optional<std::string> read(const std::string& path) override {
      return "import \"x" + path + "\"";
    }
    bool exists(const std::string&) override { return true; }
  } files;
  Diagnostics diagnostics;
  Library library(files);
  CHECK(library.load("a.style", diagnostics));
  CHECK(diagnostics.errors() == 1);
}
