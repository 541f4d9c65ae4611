// A variation as a child style: what differs, in the language itself.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/vary_sweep.hpp"

namespace mansard {

class Library;

struct Variation {
  std::string caption;  ///< what differs: "seed 7", "Tile.WindowWidth = 0.8"
  std::string base;     ///< the style that it varies
  std::vector<Change> changes;
  std::optional<uint64_t> seed;
};

/// A script of three lines that derives like the variation.
struct Child {
  std::string stem;   ///< of its files: "03-seed-9"
  std::string style;  ///< the name of its style
  std::string text;
};

/// The first words of such a script: what begins with them may be written over.
constexpr std::string_view child_mark = "// made by mansard vary";

/// `number` counts from 1; `import` is how the child names the script of its base.
Child child_of(const Variation& variation, std::size_t number, const std::string& import,
               const Library& library);

}  // namespace mansard
