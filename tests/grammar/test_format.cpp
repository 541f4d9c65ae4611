// The formatter's laws, over every script of the project and over damaged copies of them: nothing
// is lost or moved, the tree stays the same, and what is formatted stays as it is. Golden files
// show what it looks like; UPDATE_GOLDEN=1 accepts what comes out now.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>

#include "dump.hpp"
#include "grammar/format.hpp"
#include "grammar/parse.hpp"

namespace fs = std::filesystem;

namespace mansard {

namespace {

const fs::path root = MANSARD_ROOT;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// ---- a script as the words, signs, strings and comments that no formatter may touch

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// A name, or a number with its unit.
std::size_t word_length(std::string_view rest) {
  const bool number = is_digit(rest[0]) || rest[0] == '.';
  std::size_t length = 1;
  for (; length < rest.size(); ++length) {
    const char c = rest[length], before = rest[length - 1];
    const bool exponent = (c == '-' || c == '+') && (before == 'e' || before == 'E');
    if (!is_word(c) && !(number && (c == '.' || exponent))) break;
  }
  return length;
}

/// Of a comment its words.
std::string without_space(std::string_view text) {
  std::string made;
  std::copy_if(text.begin(), text.end(), std::back_inserter(made),
               [](char c) { return std::isspace(static_cast<unsigned char>(c)) == 0; });
  return made;
}

std::size_t comment_length(std::string_view rest) {
  if (rest.starts_with("//")) return std::min(rest.find('\n'), rest.size());
  std::size_t at = 0;
  for (int depth = 0; at < rest.size();) {
    const std::string_view two = rest.substr(at, 2);
    depth += two == "/*" ? 1 : two == "*/" ? -1 : 0;
    at += two == "/*" || two == "*/" ? 2 : 1;
    if (depth == 0) break;
  }
  return at;
}

struct Piece {
  std::string text;
  bool glued = false;  ///< stands against the one before
  bool operator==(const Piece& other) const { return text == other.text; }
};

constexpr std::array<std::string_view, 8> signs{"->", "::", "<=", ">=", "==", "!=", "&&", "||"};

std::vector<Piece> pieces(std::string_view text) {
  std::vector<Piece> all;
  bool glued = false;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    if (std::isspace(static_cast<unsigned char>(rest[0])) != 0) {
      glued = false, ++at;
      continue;
    }
    std::size_t length = 1;
    const bool comment = rest.starts_with("//") || rest.starts_with("/*");
    if (comment) {
      length = comment_length(rest);
    } else if (rest[0] == '"') {
      while (rest[length] != '"') length += rest[length] == '\\' ? 2 : 1;
      ++length;
    } else if (std::find(signs.begin(), signs.end(), rest.substr(0, 2)) != signs.end()) {
      length = 2;
    } else if (is_word(rest[0]) || (rest[0] == '.' && rest.size() > 1 && is_digit(rest[1]))) {
      length = word_length(rest);
    }
    std::string piece(rest.substr(0, length));
    if (comment) piece = without_space(piece);
    if (piece == "class") piece = "style";
    all.push_back({piece, glued});
    glued = true;
    at += length;
  }
  return all;
}

std::string joined(const std::vector<Piece>& all) {
  std::string text;
  for (const Piece& piece : all) text += piece.text + "\n";
  return text;
}

// ---- one script

struct Formatted {
  std::optional<std::string> text;
  std::string tree;
};

Formatted formatted(const std::string& text) {
  const Source source("test.style", text);
  Diagnostics diagnostics;
  Formatted made{format(source, diagnostics), {}};
  if (made.text) made.tree = dump(parse(source, diagnostics));
  return made;
}

/// What is wrong with how a script is formatted; nothing when it has errors or all is well.
std::string trespass(const std::string& text) {
  const Formatted once = formatted(text);
  if (!once.text) return {};
  if (joined(pieces(text)) != joined(pieces(*once.text))) return "something is lost or moved";
  const Formatted twice = formatted(*once.text);
  if (!twice.text) return "the result can not be read";
  if (once.tree != twice.tree) return "the tree is another";
  if (*once.text != *twice.text) return "it does not stay as it is:\n" + *twice.text;
  if (once.text->find('\r') != std::string::npos) return "a carriage return is left";
  if (once.text->find(" \n") != std::string::npos) return "space is left at the end of a line";
  return {};
}

void obey(const std::string& text) {
  const std::string wrong = trespass(text);
  CHECK_MESSAGE(wrong.empty(), wrong << "\nfrom\n"
                                     << text << "\nto\n"
                                     << formatted(text).text.value_or(""));
}

// ---- the scripts of the project

std::vector<std::string> code_blocks(const fs::path& page) {
  const std::string text = read(page);
  const std::regex fence("```style\n([^]*?)```");
  std::vector<std::string> all;
  for (std::sregex_iterator it(text.begin(), text.end(), fence), end; it != end; ++it) {
    const std::string block = (*it)[1];
    for (const std::string& whole : {block, "style Example {\n" + block + "}\n",
                                     "style Example { Rules {\n" + block + "} }\n"}) {
      if (formatted(whole).text) all.push_back(whole);
    }
  }
  return all;
}

std::vector<std::string> scripts() {
  std::vector<fs::path> paths;
  for (const char* const folder : {"examples", "styles", "bench", "docs", "tests",
                                   "../shared/prototypes", "../shared/design"}) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.is_regular_file()) paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> all;
  for (const fs::path& path : paths) {
    if (path.extension() == ".style" && formatted(read(path)).text) all.push_back(read(path));
    if (path.extension() != ".md") continue;
    const std::vector<std::string> blocks = code_blocks(path);
    all.insert(all.end(), blocks.begin(), blocks.end());
  }
  return all;
}

// ---- the same with other space and more comments

class Respacer {
 public:
  explicit Respacer(uint32_t seed) : random_(seed) {}

  std::string respaced(const std::string& text, unsigned comments) {
    std::string made;
    bool comment = false;
    for (const Piece& piece : pieces(text)) {
      if (!made.empty()) made += comment ? "\n" : gap(made.back(), piece, comments);
      // Comments came out of pieces() without their space: they are words of their own here.
      comment = piece.text.starts_with("//");
      made += piece.text;
    }
    return made + gap('}', {"", false}, comments);
  }

 private:
  unsigned below(unsigned n) { return random_() % n; }

  std::string gap(char before, const Piece& piece, unsigned comments) {
    if (piece.glued && (piece.text == "[" || piece.text == "r" || piece.text == "%")) return {};
    const bool may_touch = piece.glued && piece.text != "[";
    if (below(100) < comments) return comment();
    if (may_touch && before != '/' && below(2) == 0) return {};
    return space();
  }

  std::string space() {
    static constexpr std::array<const char*, 9> kinds{" ",    " ",      "  ",     "\n",     "\n  ",
                                                      "\r\n", "\n\n\n", "\t\t\n", " \n \n "};
    return kinds[below(kinds.size())];
  }

  std::string comment() {
    static constexpr std::array<const char*, 9> kinds{
        "// one\n",      "/* two */",           "/* three\n   lines */", "\n/// four\n",
        "\n// five\n\n", "/* /* six */ six */", "\n/* seven */",         "\n /*\n  * eight\n  */\n",
        "/* nine */\n"};
    std::string made;
    do {
      made += space() + kinds[below(kinds.size())] + (below(2) == 0 ? " " : space());
    } while (below(4) == 0);
    return made;
  }

  std::mt19937 random_;
};

}  // namespace

TEST_CASE("formatting loses nothing, changes no tree and is done after once") {
  const std::vector<std::string> all = scripts();
  CHECK(all.size() > 200);
  for (const std::string& text : all) obey(text);
}

TEST_CASE("whatever the space was, and wherever comments stand") {
  constexpr uint32_t seeds = 8;
  std::size_t read = 0;
  for (const std::string& text : scripts()) {
    for (uint32_t seed = 0; seed < seeds; ++seed) {
      const std::string other = Respacer(seed).respaced(text, seed * seed / 2);
      CAPTURE(seed);
      read += formatted(other).text.has_value();
      obey(other);
    }
  }
  CHECK(read > seeds * 200);
}

TEST_CASE("golden layouts") {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(root / "tests/golden/format")) {
    if (entry.path().extension() == ".style") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  REQUIRE(paths.size() > 5);
  for (const fs::path& path : paths) {
    const std::string now = formatted(read(path)).text.value_or("it has errors\n");
    const fs::path expected = fs::path(path).replace_extension(".out");
    if (std::getenv("UPDATE_GOLDEN")) std::ofstream(expected, std::ios::binary) << now;
    CHECK_MESSAGE(now == read(expected), path.filename().string() << " is now\n" << now);
  }
}

TEST_CASE("a script with errors is not formatted") {
  const Source source("test.style", "style A { Plot { FOOTPRINT -> } }");
  Diagnostics diagnostics;
  CHECK_FALSE(format(source, diagnostics).has_value());
  CHECK(diagnostics.errors() == 1);
}

TEST_CASE("lines are as wide as the page where they can be") {
  for (const std::string& text : scripts()) {
    const Source source("test.style", *formatted(text).text);
    uint32_t line = 1;
    while (line <= source.line_of(static_cast<uint32_t>(source.text().size()))) {
      const std::string_view here = source.line(line++);
      const bool breakable = here.find("//") == here.npos && here.find(", ") != here.npos;
      CHECK_MESSAGE((here.size() <= 100 || !breakable), here);
    }
  }
}

}  // namespace mansard
