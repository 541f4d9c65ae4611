// `mansard help WORD`: every word and sign of the language, of operations and of the command line
// leads somewhere.
#include <doctest/doctest.h>

#include <sstream>

#include "grammar/parse.hpp"
#include "interpreter/attribute_table.hpp"
#include "interpreter/function.hpp"
#include "interpreter/operation.hpp"
#include "interpreter/selectors.hpp"
#include "styles/annotations.hpp"
#include "tests/cli/run.hpp"

namespace {

using mansard::test::Run;
using mansard::test::run;

bool has(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

void check_page(const std::string& word) {
  const Run page = run({"help", word});
  CHECK_MESSAGE(page.status == 0, word << ": " << page.err);
  CHECK_MESSAGE(!page.out.empty(), word);
}

/// What stands behind a name at the beginning of a line, `  name   what it is`.
std::string line_of(const std::string& page, const std::string& name) {
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  " + name + " ")) continue;
    const std::size_t begin = line.find_first_not_of(' ', name.size() + 2);
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return {};
}

}  // namespace

TEST_CASE("every word of the tables has a page") {
  using namespace mansard;
  for (const Operation& row : operations()) check_page(std::string(row.name));
  for (const Function& row : functions()) check_page(std::string(row.name));
  for (const AnnotationRow& row : annotation_rows()) check_page(std::string(row.name));
  for (const AttributeRow& row : attributes()) check_page(std::string(row.name));
  for (const InputRow& row : inputs()) check_page(std::string(row.name));
  for (const std::string_view word : selector_words) check_page(std::string(word));
  for (const std::string_view word : keywords()) check_page(std::string(word));
  for (const char* const word : {"fits", "NIL", "FOOTPRINT", "Elements", "Materials", "replace",
                                 "remove", "per", "start", "attr"}) {
    check_page(word);
  }
}

TEST_CASE("every argument and part of every operation is explained") {
  for (const mansard::Operation& operation : mansard::operations()) {
    const std::string name(operation.name), page = run({"help", name}).out;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < operation.count; ++i)
      words.emplace_back(operation.parameter_name(i));
    for (std::size_t i = 0; i < mansard::parts_in(operation.parts); ++i)
      words.emplace_back(mansard::part_name(operation.parts, i));
    for (const std::string& word : words) {
      const std::string what = line_of(page, word);
      CHECK_MESSAGE((!what.empty() && what != "(optional)"),
                    "cli/argument_table.cpp has no row for " << word << " of " << name);
      CHECK(has(run({"help", word}).out, name + "("));
    }
  }
}

TEST_CASE("every flag has a page, with and without its hyphens") {
  std::size_t flags = 0;
  for (const char* const command :
       {"derive", "check", "format", "explain", "tree", "render", "vary", "lsp"}) {
    std::istringstream lines(run({"help", command}).out);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t begin = line.find("--");
      if (!line.starts_with("  -") || begin == std::string::npos) continue;
      const std::string flag = line.substr(begin, line.find(' ', begin) - begin);
      if (flag != "--json") check_page(flag);
      ++flags;
    }
  }
  CHECK(flags > 60);
  CHECK(has(run({"help", "-o"}).out, "a flag of derive"));
  CHECK(has(run({"help", "camera"}).out, "--camera VIEW, a flag of render"));
}

TEST_CASE("signs and words as a script writes them") {
  for (const char* const sign :
       {"->",     "|",           "::",          "~",      "1r",        "(Share)r",
        "30%",    "~1.2",        "House::ROOF", "@range", "\"gable\"", "gable",
        "roof()", "split.index", "{",           "[",      "==",        "//",
        "///",    "=",           ":",           "@"}) {
    check_page(sign);
  }
  const Run unknown = run({"help", "overhnag"});
  CHECK(unknown.status == 2);
  CHECK(unknown.err == "error: no help on 'overhnag'; did you mean 'overhang'?\n");
  CHECK(run({"help", "W099"}).status == 2);
}

TEST_CASE("the page of an operation says what its arguments and parts are") {
  CHECK(run({"help", "detrude"}).out ==
        "detrude(depth) { inner | reveal }\n\n"
        "  Moves a face in by the depth; the reveals are the faces around the recess.\n\n"
        "Arguments\n"
        "  depth          metres into the wall, 0 or more\n\n"
        "Parts\n"
        "  inner          the face, moved in\n"
        "  reveal         each face around the recess, from the wall to the inner face\n\n"
        "Example\n"
        "  FOOTPRINT -> extrude(6) comp { front : detrude(0.2) { WINDOW | WALL } }\n");
  const std::string roof = run({"help", "roof"}).out;
  CHECK(has(roof, "overhang       metres beyond the walls, 0 to 10; 0 if nothing is said"));
  const std::string overhang = run({"help", "overhang"}).out;
  CHECK(has(overhang, "overhang, an argument of roof("));
  CHECK(has(overhang, "more: mansard help roof"));
  CHECK(has(run({"help", "import"}).out, "import \"parts.style\""));
}
