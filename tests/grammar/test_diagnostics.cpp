// How diagnostics are collected, compared and printed.
#include <doctest/doctest.h>

#include <array>

#include "grammar/codes.hpp"
#include "grammar/parse.hpp"

namespace mansard {

namespace {

Span find(const Source& source, std::string_view word) {
  const auto at = static_cast<uint32_t>(source.text().find(word));
  return {&source, at, static_cast<uint32_t>(at + word.size())};
}

Diagnostic error(Span at, std::string text) {
  return {Severity::error, {}, at, std::move(text), {}, {}, {}};
}

}  // namespace

TEST_CASE("a diagnostic is printed as the manual shows it") {
  const Source source(
      "terrace.style",
      std::string(13, '\n') + "        FLOOR -> subdiv(\"X\", 1r, 0.9, 1r) { WALL | TileC }\n");
  Diagnostic d = error(find(source, "1r, 0.9, 1r"), "'subdiv' got 3 sizes for 2 parts");
  d.also.push_back(find(source, "WALL | TileC"));
  d.notes.push_back({"while checking block 'Floor' of style 'Terrace'", {}});
  d.help = "add a part, or drop a size";
  CHECK(to_text(d) == R"(error: 'subdiv' got 3 sizes for 2 parts
  --> terrace.style:14:30
   |
14 |         FLOOR -> subdiv("X", 1r, 0.9, 1r) { WALL | TileC }
   |                              ^^^^^^^^^^^    ^^^^^^^^^^^^
note: while checking block 'Floor' of style 'Terrace'
help: add a part, or drop a size
)");
}

TEST_CASE("carets on other lines have excerpts of their own") {
  const Source source("a.style", "one\ntwo\nthree\nfour\nfive\nsix\nseven\neight\nnine\nten");
  Diagnostic d = error(find(source, "two"), "text");
  d.code = "W001";
  d.severity = Severity::warning;
  d.also = {find(source, "ten"), find(source, "wo")};
  d.notes.push_back({"and here", find(source, "ive")});
  CHECK(to_text(d) == R"(warning[W001]: text
  --> a.style:2:1
   |
 2 | two
   | ^^^
  --> a.style:10:1
   |
10 | ten
   | ^^^
note: and here
  --> a.style:5:2
   |
 5 | five
   |  ^^^
)");
}

TEST_CASE("carets stand under tabs and wide characters") {
  const Source source("a.style", "\tä\t漢字 = x\r\n");
  CHECK(to_text(error(find(source, "x"), "text")) ==
        "error: text\n --> a.style:1:9\n  |\n1 |     ä   漢字 = x\n  |                ^\n");
  CHECK(to_text(error(find(source, "漢字"), "text")) ==
        "error: text\n --> a.style:1:4\n  |\n1 |     ä   漢字 = x\n  |         ^^^^\n");
}

TEST_CASE("what can not be printed is replaced") {
  const Source source("a.style", std::string("a\x01\xFF b\0c", 7));
  CHECK(to_text(error(find(source, "b"), "text")) ==
        "error: text\n --> a.style:1:5\n  |\n1 | a\uFFFD\uFFFD b\uFFFDc\n  |     ^\n");
}

TEST_CASE("a long line is cut around the caret") {
  std::string line(100000, 'a');
  line.replace(50000, 5, "WRONG");
  const Source source("a.style", line);
  const std::string text = to_text(error(find(source, "WRONG"), "text"));
  CHECK(text.size() < 500);
  const std::size_t row = text.find("| …") + 2, carets = text.find('^');
  const std::size_t caret_row = text.rfind("| ", carets) + 2;
  const std::string_view shown = std::string_view(text).substr(row);
  CHECK(shown.substr(carets - caret_row + 2, 5) == "WRONG");  // an ellipsis has three bytes
}

TEST_CASE("diagnostics without a place, at the end, and past it") {
  const Source source("a.style", "x\n"), empty("b.style", "");
  CHECK(to_text(error({}, "there is no file")) == "error: there is no file\n");
  CHECK(to_text(error({&source, 2, 2}, "t")) == "error: t\n --> a.style:2:1\n  |\n2 |\n  | ^\n");
  CHECK(to_text(error({&empty, 0, 0}, "t")) == "error: t\n --> b.style:1:1\n  |\n1 |\n  | ^\n");
}

TEST_CASE("colour goes around, never into the words") {
  const Source source("a.style", "x");
  std::string text = to_text(error({&source, 0, 1}, "text"), true);
  CHECK(text.find("\033[") == 0);
  for (std::size_t at; (at = text.find('\033')) != text.npos;) {
    text.erase(at, text.find('m', at) - at + 1);
  }
  CHECK(text == to_text(error({&source, 0, 1}, "text")));
}

TEST_CASE("JSON") {
  const Source source("a.style", "ä x\nyy");
  Diagnostic d = error(find(source, "x\ny"), "say \"x\"\xFF");
  d.notes = {{"n", {}}};
  CHECK(to_json(d) == R"({"severity":"error","code":"","text":"say \"x\")"
                      "\uFFFD"
                      R"(","file":"a.style","line":1,"column":3,"end_line":2,"end_column":2,)"
                      R"("also":[],"notes":[{"text":"n"}],"help":""})");
}

TEST_CASE("repeats and allowed warnings are dropped") {
  const Source source("a.style",
                      "A // allow W001, W002\nB // because allow W001\nC //allow W003: so it is");
  Diagnostics all;
  const auto warn = [&](std::string_view word, std::string_view code) {
    all.add({Severity::warning, code, find(source, word), "text", {}, {}, {}});
  };
  warn("A", "W001"), warn("A", "W002"), warn("C", "W003");
  CHECK(all.all().empty());
  warn("A", "W003"), warn("B", "W001"), warn("B", "W001"), warn("C", "W00");
  CHECK(all.all().size() == 3);
  CHECK_FALSE(all.has_errors());
  all.add(error(find(source, "A"), "x"));
  all.add(error(find(source, "A"), "x"));
  all.add(error(find(source, "A"), "y"));
  CHECK(all.errors() == 2);
}

TEST_CASE("sorted by file, then by position") {
  const Source a("a", "xyz"), b("b", "xyz");
  Diagnostics all;
  all.add(error({&b, 2, 3}, "1"));
  all.add(error({&a, 1, 2}, "2"));
  all.add(error({&b, 0, 1}, "3"));
  all.add(error({&a, 0, 1}, "4"));
  all.sort();
  std::string order;
  for (const Diagnostic& d : all.all()) order += d.text;
  CHECK(order == "3142");
}

TEST_CASE("at one place errors first, then what speaks of fewer words") {
  const Source a("a", "NAME : W > 3 -> WALL");
  Diagnostics all;
  all.add({Severity::warning, "W002", {&a, 0, 12}, "2", {}, {}, {}});
  all.add({Severity::warning, "W016", {&a, 0, 4}, "1", {}, {}, {}});
  all.add(error({&a, 0, 20}, "0"));
  all.sort();
  std::string order;
  for (const Diagnostic& d : all.all()) order += d.text;
  CHECK(order == "012");
}

TEST_CASE("the nearest word") {
  constexpr std::array<std::string_view, 5> words{"style", "class", "subdiv", "WALL", "if"};
  CHECK(nearest("styel", words) == "style");
  CHECK(nearest("Style", words) == "style");
  CHECK(nearest("subdivide", words) == "subdiv");
  CHECK(nearest("wal", words) == "WALL");
  CHECK_FALSE(nearest("roof", words));
  CHECK_FALSE(nearest("", words));
  CHECK_FALSE(nearest("x", words));
}

TEST_CASE("every code has a page") {
  for (const CodePage& page : code_pages()) {
    CHECK(find_code(page.code) == &page);
    CHECK(page.title.ends_with('.'));
    CHECK(page.page.size() > 100);
  }
  CHECK_FALSE(find_code("W999"));
}

TEST_CASE("names") {
  CHECK(is_name("_a1"));
  CHECK(is_name("style"));
  CHECK_FALSE(is_name(""));
  CHECK_FALSE(is_name("1a"));
  CHECK_FALSE(is_name("a b"));
  CHECK_FALSE(is_name("é"));
}

TEST_CASE("places in a source") {
  const Source source("a", "ab\r\n\nä€x");
  CHECK(source.line(1) == "ab");
  CHECK(source.line(2).empty());
  CHECK(source.line(3) == "ä€x");
  CHECK(source.position(9).line == 3);
  CHECK(source.position(10).column == 3);
  CHECK(source.position(1000).column == 4);
}

}  // namespace mansard
