// Variables that read each other, by the thousand.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "interpreter/program.hpp"

using namespace mansard;

namespace {

class OneText final : public Files {
 public:
  explicit OneText(std::string text) : text_(std::move(text)) {}
  std::optional<std::string> read(const std::string& path) override {
    return path == "test.style" ? std::optional(text_) : std::nullopt;
  }
  bool exists(const std::string& path) override { return path == "test.style"; }

 private:
  std::string text_;
};

struct NoMeshes final : MeshSource {
  const Mesh* mesh(const std::string&, std::string&) override { return nullptr; }
  bool has_picture(const std::string&) override { return false; }
};

/// The texts of all errors, a line each.
std::string errors_of(const std::string& members) {
  OneText files("style S { Plot { " + members + " FOOTPRINT -> extrude(V0) MASS } }");
  Library library(files);
  Diagnostics diagnostics;
  library.load("test.style", diagnostics);
  NoMeshes meshes;
  compile(library, meshes, {}, diagnostics);
  std::string text;
  for (const Diagnostic& d : diagnostics.all()) text += d.text + "\n";
  return text;
}

/// V0 = V1 + 1, V1 = V2 + 1, and so on; `last` is what the last of them is.
std::string chain(int length, const std::string& last) {
  std::string text;
  for (int i = 0; i + 1 < length; ++i) {
    text += "var V" + std::to_string(i) + " = V" + std::to_string(i + 1) + " + 1\n";
  }
  return text + "var V" + std::to_string(length - 1) + " = " + last + "\n";
}

}  // namespace

TEST_CASE("a ring of twenty thousand variables is one error") {
  CHECK(errors_of(chain(20'000, "V0 + 1")) == "variable 'Plot.V0' is defined by itself\n");
}

TEST_CASE("thousands of rings are fifty errors") {
  std::string text = "var V0 = 1\n";
  for (int i = 0; i < 3000; ++i) {
    const std::string n = std::to_string(i);
    text += "var A" + n + " = B" + n + "\nvar B" + n + " = A" + n + "\n";
  }
  const std::string errors = errors_of(text);
  CHECK(std::count(errors.begin(), errors.end(), '\n') == 50);
}

TEST_CASE("a long chain that ends is too deep, not endless") {
  CHECK(errors_of(chain(900, "1")) == "");
  const std::string errors = errors_of(chain(5000, "1"));
  CHECK(errors.find("stands on a chain of other variables that is too deep") != std::string::npos);
  CHECK(errors.find("3000 allowed") != std::string::npos);
  CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
}
