// tests/golden/syntax/*.style against .out (the tree) and .err (the diagnostics); UPDATE_GOLDEN=1
// accepts what the parser says now.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "dump.hpp"
#include "grammar/parse.hpp"

namespace fs = std::filesystem;

namespace mansard {

namespace {

const fs::path folder = fs::path(MANSARD_ROOT) / "tests" / "golden" / "syntax";

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

void compare(const fs::path& path, const std::string& now) {
  if (std::getenv("UPDATE_GOLDEN")) {
    if (now.empty()) {
      fs::remove(path);
    } else {
      std::ofstream(path, std::ios::binary) << now;
    }
  } else {
    CHECK_MESSAGE(now == read(path), path.filename().string() << " is now\n" << now);
  }
}

}  // namespace

TEST_CASE("golden syntax files") {
  std::vector<fs::path> scripts;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".style") scripts.push_back(entry.path());
  }
  std::sort(scripts.begin(), scripts.end());
  REQUIRE(scripts.size() > 5);
  for (fs::path script : scripts) {
    Sources sources;
    Diagnostics diagnostics;
    const Source& source = sources.add(script.filename().string(), read(script));
    const syntax::File file = parse(source, diagnostics);
    diagnostics.sort();
    std::string errors;
    for (const Diagnostic& diagnostic : diagnostics.all()) errors += to_text(diagnostic) + "\n";
    compare(script.replace_extension(".out"), dump(file));
    compare(script.replace_extension(".err"), errors);
  }
}

}  // namespace mansard
