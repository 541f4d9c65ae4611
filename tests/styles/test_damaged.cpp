// Scripts cut up and sewn together wrongly: they may complain, not crash or hang.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "styles/style.hpp"
#include "tests/styles/memory_files.hpp"

using namespace mansard;
namespace fs = std::filesystem;

namespace {

/// The golden scripts as words, with the space after each.
std::vector<std::string> words_of_goldens() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(MANSARD_ROOT "/tests/golden/styles")) {
    if (entry.path().extension() == ".style") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> words;
  for (const fs::path& path : paths) {
    const std::string text = DiskFiles().read(path).value();
    bool in_space = true;
    for (const char c : text) {
      const bool space = c == ' ' || c == '\n';
      if (!space && in_space) words.emplace_back();
      if (!words.empty()) words.back() += c;
      in_space = space;
    }
  }
  return words;
}

std::string damaged(const std::vector<std::string>& words, std::mt19937& random) {
  std::string text;
  const std::size_t start = random() % words.size();
  for (std::size_t i = start; i < std::min(start + 150, words.size()); ++i) {
    const unsigned what = random() % 50;
    if (what == 0) continue;
    text += what == 1 ? words[random() % words.size()] : words[i];
    if (what == 2) text += words[random() % words.size()];
  }
  return text;
}

}  // namespace

TEST_CASE("damaged scripts are complained about") {
  constexpr unsigned seed = 7;
  std::mt19937 random(seed);
  const std::vector<std::string> words = words_of_goldens();
  std::size_t styles = 0, linked = 0;
  for (int i = 0; i < 400; ++i) {
    MemoryFiles files(damaged(words, random));
    Library library(files);
    Diagnostics diagnostics;
    library.load("main.style", diagnostics);
    for (const syntax::Style* style : library.styles()) {
      ++styles;
      if (link(library, *style, diagnostics)) ++linked;
    }
    for (const Diagnostic& diagnostic : diagnostics.all()) REQUIRE(!to_text(diagnostic).empty());
  }
  INFO("seed " << seed);
  CHECK(styles > 400);
  CHECK(linked > 200);
}
