// Scripts whose names are mixed up: they may complain, not crash or hang.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "grammar/parse.hpp"
#include "styles/style.hpp"
#include "tests/styles/memory_files.hpp"

using namespace mansard;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Names, and what stands between them.
Words words_of(const std::string& text) {
  Words words;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i == 0 || is_letter(text[i]) != is_letter(text[i - 1])) words.emplace_back();
    words.back() += text[i];
  }
  return words;
}

bool is_free_name(const std::string& word) {
  const auto known = keywords();
  return is_name(word) && std::find(known.begin(), known.end(), word) == known.end();
}

std::vector<Words> goldens() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(MANSARD_ROOT "/tests/golden/styles")) {
    if (entry.path().extension() == ".style") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Words> scripts;
  for (const fs::path& path : paths) scripts.push_back(words_of(DiskFiles().read(path).value()));
  return scripts;
}

/// Two scripts after each other, one name in ten changed for another of their names.
std::string mixed_up(const std::vector<Words>& scripts, std::mt19937& random) {
  Words words = scripts[random() % scripts.size()];
  const Words& more = scripts[random() % scripts.size()];
  words.insert(words.end(), more.begin(), more.end());
  Words names;
  std::copy_if(words.begin(), words.end(), std::back_inserter(names), is_free_name);
  std::string text;
  for (const std::string& word : words) {
    const bool change = is_free_name(word) && random() % 10 == 0;
    text += change ? names[random() % names.size()] : word;
  }
  return text;
}

}  // namespace

TEST_CASE("scripts with mixed-up names are complained about") {
  constexpr unsigned seed = 7;
  std::mt19937 random(seed);
  const std::vector<Words> scripts = goldens();
  std::size_t styles = 0, linked = 0, complaints = 0;
  for (int i = 0; i < 500; ++i) {
    MemoryFiles files(mixed_up(scripts, random));
    Library library(files);
    Diagnostics diagnostics;
    library.load("main.style", diagnostics);
    for (const syntax::Style* style : library.styles()) {
      ++styles;
      if (link(library, *style, diagnostics)) ++linked;
    }
    for (const Diagnostic& diagnostic : diagnostics.all()) {
      REQUIRE(!to_text(diagnostic).empty());
      ++complaints;
    }
  }
  INFO("seed " << seed << ", " << styles << " styles, " << linked << " linked");
  CHECK(linked > 1000);
  CHECK(styles > linked + 100);
  CHECK(complaints > 1000);
}
