// What nobody writes on purpose: depth, length and garbage.
#include <doctest/doctest.h>

#include <chrono>
#include <random>

#include "dump.hpp"
#include "grammar/parse.hpp"

namespace mansard {

namespace {

struct Outcome {
  std::string first;
  std::size_t errors = 0, rules = 0;
  double seconds = 0;
};

Outcome read(std::string text) {
  const Source source("x.style", std::move(text));
  Diagnostics diagnostics;
  const auto begin = std::chrono::steady_clock::now();
  Outcome outcome;
  {
    const syntax::File file = parse(source, diagnostics);
    for (const syntax::Style& style : file.styles) {
      for (const syntax::StyleMember& member : style.members) {
        if (const auto* block = std::get_if<syntax::Block>(&member)) {
          outcome.rules += block->items.size();
        }
      }
    }
  }
  for (const Diagnostic& d : diagnostics.all()) to_text(d);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  outcome.errors = diagnostics.errors();
  if (!diagnostics.all().empty()) outcome.first = diagnostics.all().front().text;
  return outcome;
}

std::string repeat(std::string_view text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

std::string in_block(const std::string& text) { return "style S { B { " + text + " } }"; }

}  // namespace

TEST_CASE("brackets are bounded in depth, whichever they are") {
  const std::string deep = "brackets and ifs stand more than 250 deep in each other";
  for (const auto& [open, close] :
       std::initializer_list<std::pair<const char*, const char*>>{{"(", ")"},
                                                                  {"f(", ")"},
                                                                  {"[", "]"},
                                                                  {"a[", "]"},
                                                                  {"-(", ")"},
                                                                  {"a + (", ")"},
                                                                  {"if a then b else ", ""},
                                                                  {"if ", " then a else b"},
                                                                  {"f([a[(", ")]])"}}) {
    CAPTURE(open);
    const auto nested = [&](std::size_t times) {
      return in_block("var X = " + repeat(open, times) + "1" + repeat(close, times));
    };
    CHECK(read(nested(50)).errors == 0);
    CHECK(read(nested(50)).rules == 1);
    CHECK(read(nested(300)).first == deep);
    CHECK(read(nested(20000)).first == deep);
    CHECK(read(in_block("var X = " + repeat(open, 20000))).errors > 0);
  }
  for (const auto& [open, close] : std::initializer_list<std::pair<const char*, const char*>>{
           {"[", "]"}, {"x() {", "}"}, {"x() { 1 :", "}"}, {"if a {", "}"}, {"x() { {", "}* }"}}) {
    CAPTURE(open);
    const auto nested = [&](std::size_t times) {
      return in_block("A -> " + repeat(open, times) + "B" + repeat(close, times));
    };
    CHECK(read(nested(100)).errors == 0);
    CHECK(read(nested(300)).first == deep);
    CHECK(read(nested(20000)).errors > 0);
    CHECK(read(in_block("A -> " + repeat(open, 20000))).errors > 0);
  }
}

TEST_CASE("chains are as long as you like") {
  for (const char* sign : {"+", "*", "&&", "||"}) {
    CHECK(read(in_block("var X = 1" + repeat(std::string(sign) + "1", 20000))).rules == 1);
  }
  CHECK(read(in_block("var X = " + repeat("- ", 20000) + "1")).rules == 1);
  CHECK(read(in_block("var X = " + repeat("!", 20000) + "a")).rules == 1);
  CHECK(read(in_block("var X = a" + repeat(".b", 20000))).rules == 1);
  CHECK(read(in_block("A -> if a { B }" + repeat(" else if a { B }", 20000))).rules == 1);
  CHECK(read(in_block("A -> x() { B" + repeat("| B", 20000) + "}")).rules == 1);
  CHECK(read(in_block("A -> B" + repeat(" B", 20000))).rules == 1);
  CHECK(read(in_block("var X = a" + repeat("[1]", 20000))).first ==
        "more than 250 indices in a row");
}

TEST_CASE("garbage is refused soon") {
  const double limit = 5;  // seconds; a loaded machine with sanitizers
  const std::size_t size = 1 << 20;
  for (const char* piece :
       {"a",         "a ",   "(",        ")",          "{",      "}",          "[",
        "]",         "\"",   "\" ",      "\n",         "A ->\n", "A -> B ",    "a : ",
        "->",        "a{",   "a{a:",     "@a ",        "@a(",    "style ",     "style A {",
        "x { y -> ", "var ", "var x = ", "/*",         "//",     "///\n",      "1 ",
        "1+",        "a(",   "a[",       "a : a[",     "a : (",  "if ",        "a : if ",
        "else ",     ";",    "\\u",      "Elements {", "A : \"", "A : \"b\" ", "~",
        ": ",        "| ",   "A : b(",   "replace ",   "é",      "a\n\n;"}) {
    CAPTURE(piece);
    for (const char* before : {"", "style S {", "style S { B { ", "style S { B { A -> ",
                               "style S { B { A -> x() { ", "style S { Elements { A : "}) {
      CAPTURE(before);
      const Outcome outcome = read(before + repeat(piece, size / 8 / std::string(piece).size()));
      CHECK(outcome.errors <= 51);
      CHECK(outcome.seconds < limit);
    }
  }
  CHECK(read(std::string(Source::max_bytes + 1, 'a')).first ==
        "the file is larger than the 4 MB that a script may have");
}

TEST_CASE("a hundred warnings of one kind say no more than fifty") {
  const Source source("x.style", in_block("A -> B\n" + repeat("C\n", 1000)));
  Diagnostics diagnostics;
  parse(source, diagnostics);
  CHECK(diagnostics.all().size() == 50);
}

TEST_CASE("what is no text is refused with a place") {
  CHECK(read(std::string("style A { }\n\0", 13)).first == "a control character stands here");
  CHECK(read("style A { } // old\rstyle B { }").first == "a carriage return without a line feed");
  CHECK(read("style A { }\r\n").errors == 0);
  CHECK(read("style A { } // \x1b[31m").first == "a control character stands here");
  CHECK(read("style A { } // \xC3(").first == "this is not UTF-8 text");
  CHECK(read("\xFF").first == "this is not UTF-8 text");
  CHECK(read("style A { } // \xED\xA0\x80").first == "this is not UTF-8 text");
  CHECK(read("").errors == 0);
}

TEST_CASE("random words never hang or crash") {
  constexpr std::array words{
      "style",    "S",         "{",       "}",      "(",     ")",        "[",      "]",
      "|",        ":",         "->",      "A",      "B",     "1",        "1r",     "30%",
      "~",        "var",       "def",     "if",     "then",  "else",     "\"x\"",  ",",
      "=",        "==",        "+",       "-",      "*",     "/",        "///\n",  "//\n",
      "/*",       "*/",        "@a",      ".",      "::",    "\n",       "!",      "&&",
      "||",       ";",         "super",   "final",  "start", "abstract", "remove", "per",
      "Elements", "Materials", "replace", "import", "true",  "override"};
  const unsigned seed = 20240607;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 3000; ++i) {
    std::string text = i % 3 ? "style S { Q { A -> B " : "";
    const unsigned length = random() % 60;
    for (unsigned j = 0; j < length; ++j) {
      text += words[random() % words.size()];
      text += random() % 4 ? " " : "";
    }
    CAPTURE(text);
    CHECK(read(text).seconds < 5);
  }
}

TEST_CASE("a text without its end is never silently whole") {
  const std::string whole = "style S { B { A : x -> f(1, [2]) { 1r : B | { 2 : C }* } D : 0.5 } }";
  CHECK(read(whole).errors == 0);
  for (std::size_t end = 1; end + 1 < whole.size(); ++end) {
    CAPTURE(whole.substr(0, end));
    CHECK(read(whole.substr(0, end)).errors > 0);
  }
}

TEST_CASE("spans are exact") {
  const Source source(
      "x.style",
      in_block("@a /* x */ override  A : b  /* c */ -> f( 1 ) { C } /* d */ : (2) /* e */ "));
  Diagnostics diagnostics;
  const syntax::File file = parse(source, diagnostics);
  REQUIRE(diagnostics.all().empty());
  const auto& block = std::get<syntax::Block>(file.styles[0].members[0]);
  const auto& rule = std::get<syntax::Rule>(block.items[0]);
  CHECK(file.styles[0].at.text() == source.text());
  CHECK(block.at.text().starts_with("B {"));
  CHECK(block.at.text().ends_with("/* e */  }"));
  CHECK(rule.at.text() == "@a /* x */ override  A : b  /* c */ -> f( 1 ) { C } /* d */ : (2)");
  CHECK(rule.head.text() == "A : b");
  CHECK(rule.guard->at.text() == "b");
  CHECK(rule.successor[0].at.text() == "f( 1 ) { C }");
  const auto& emit = std::get<syntax::Emit>(rule.successor[0].is);
  CHECK(emit.args_at.text() == "( 1 )");
  CHECK(emit.parts->at.text() == "{ C }");
  CHECK(rule.probability->at.text() == "(2)");
}

TEST_CASE("expressions of the command line") {
  const auto value = [](std::string text) {
    const Source source("--set", std::move(text));
    Diagnostics diagnostics;
    const syntax::ExprPtr expr = parse_expression(source, diagnostics);
    CHECK(diagnostics.has_errors() == !expr);
    return expr ? dump(*expr) : to_text(diagnostics.all()[0]);
  };
  CHECK(value(" 1 + a.b ") == "( 1 + a.b )");
  CHECK(value("\"x\"") == "\"x\"");
  CHECK(value("") ==
        "error: expected a value before the end of the file\n --> --set:1:1\n  |\n1 |\n  | ^\n");
  CHECK(value("1 1") ==
        "error: expected the end of the value, not '1'\n --> --set:1:3\n  |\n1 | 1 1\n  |   ^\n");
  CHECK(value("1r").starts_with("error: '1r' is a share of a split"));
  CHECK(value("/* 1").starts_with("error: "));
}

}  // namespace mansard
