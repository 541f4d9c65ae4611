// C3 against Python's own, over random hierarchies.

#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>

#include "styles/complaint.hpp"
#include "styles/linearise.hpp"
#include "tests/styles/dump.hpp"
#include "tests/styles/memory_files.hpp"

using namespace mansard;

namespace {

/// parents[i] names earlier styles.
using Hierarchy = std::vector<std::vector<int>>;

Hierarchy random_hierarchy(std::mt19937& random) {
  Hierarchy parents(4 + random() % 10);
  for (std::size_t i = 1; i < parents.size(); ++i) {
    std::vector<int> earlier(i);
    for (std::size_t k = 0; k < i; ++k) earlier[k] = static_cast<int>(k);
    std::shuffle(earlier.begin(), earlier.end(), random);
    const std::size_t wanted = std::min<std::size_t>(i, random() % 4);
    // A mostly sorted choice agrees more often, and so makes deeper hierarchies.
    if (random() % 3 != 0) std::sort(earlier.begin(), earlier.begin() + wanted, std::greater<>());
    parents[i].assign(earlier.begin(), earlier.begin() + wanted);
  }
  return parents;
}

std::string name_of(std::size_t i) { return std::string("S").append(std::to_string(i)); }

std::string as_styles(const Hierarchy& parents) {
  std::string text;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    text += "style " + name_of(i);
    for (std::size_t k = 0; k < parents[i].size(); ++k) {
      text += (k == 0 ? " : " : ", ") + name_of(parents[i][k]);
    }
    text += " { }\n";
  }
  return text;
}

/// A line for each style: its order, or "none".
std::string our_orders(const Hierarchy& parents) {
  MemoryFiles files(as_styles(parents));
  Library library(files);
  Diagnostics diagnostics;
  library.load("main.style", diagnostics);
  std::string text;
  for (const syntax::Style* style : library.styles()) {
    const auto ancestry = Ancestry::of(library, *style, diagnostics);
    text += (ancestry ? listed(ancestry->order()) : "none") + "\n";
  }
  return text;
}

const char* python_program = R"(
import sys
def line(classes, parents, i):
    try:
        classes[i] = type('S%d' % i, tuple(classes[k] for k in parents), {})
    except (TypeError, KeyError):
        return 'none'
    return ', '.join(c.__name__ for c in classes[i].__mro__[:-1])
for text in sys.stdin:
    classes = {}
    for i, parents in enumerate(eval(text)):
        print(line(classes, parents, i))
)";

std::string as_python(const Hierarchy& parents) {
  std::string text = "[";
  for (const auto& of_one : parents) {
    text += "[";
    for (const int parent : of_one) text += std::to_string(parent) + ",";
    text += "],";
  }
  return text + "]\n";
}

/// Nothing when Python fails.
std::optional<std::string> python_orders(const std::vector<Hierarchy>& hierarchies) {
  namespace fs = std::filesystem;
  const std::string base = fs::temp_directory_path() / ("mansard_c3_" + std::to_string(getpid()));
  std::ofstream(base + ".py") << python_program;
  std::ofstream input(base + ".txt");
  for (const Hierarchy& hierarchy : hierarchies) input << as_python(hierarchy);
  input.close();
  const std::string command = MANSARD_PYTHON " " + base + ".py < " + base + ".txt 2>/dev/null";
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string output;
  char buffer[4096];
  while (pipe && std::fgets(buffer, sizeof buffer, pipe)) output += buffer;
  const bool ran = pipe && pclose(pipe) == 0;
  fs::remove(base + ".py");
  fs::remove(base + ".txt");
  return ran ? std::optional(output) : std::nullopt;
}

std::optional<Ancestry> ancestry_of_last(const std::string& text, Diagnostics& diagnostics) {
  MemoryFiles files(text);
  Library library(files);
  library.load("main.style", diagnostics);
  return Ancestry::of(library, *library.default_style(), diagnostics);
}

}  // namespace

TEST_CASE("the order is Python's") {
  constexpr unsigned seed = 20240611;
  std::mt19937 random(seed);
  std::vector<Hierarchy> hierarchies;
  for (int i = 0; i < 10'000; ++i) hierarchies.push_back(random_hierarchy(random));
  const std::optional<std::string> expected = python_orders(hierarchies);
  REQUIRE(expected);
  std::istringstream lines(*expected);
  int orders = 0, refused = 0;
  for (const Hierarchy& hierarchy : hierarchies) {
    std::string theirs;
    for (std::size_t i = 0; i < hierarchy.size(); ++i) {
      std::string line;
      REQUIRE(std::getline(lines, line));
      ++(line == "none" ? refused : orders);
      theirs += line + "\n";
    }
    INFO("seed " << seed << "\n" << as_styles(hierarchy));
    REQUIRE(our_orders(hierarchy) == theirs);
  }
  CHECK(orders > 50'000);
  CHECK(refused > 5'000);
}

TEST_CASE("thousands of generations are an error, not a stack overflow") {
  std::string text = "style S0 { }\n";
  for (int i = 1; i < 5000; ++i) {
    text += "style " + name_of(i) + " : " + name_of(i - 1) + " { }\n";
  }
  Diagnostics diagnostics;
  CHECK(!ancestry_of_last(text, diagnostics));
  CHECK(diagnostics.errors() == 1);
}

TEST_CASE("a lattice over a missing style is visited once, not once for every path") {
  std::string text = "style A0 : Missing { } style B0 : Missing { }\n";
  for (int i = 1; i < 100; ++i) {
    const std::string below = std::to_string(i - 1), here = std::to_string(i);
    text += "style A" + here + " : A" + below + ", B" + below + " { }\n";
    text += "style B" + here + " : A" + below + ", B" + below + " { }\n";
  }
  Diagnostics diagnostics;
  CHECK(!ancestry_of_last(text, diagnostics));
  CHECK(diagnostics.errors() == 2);
}
