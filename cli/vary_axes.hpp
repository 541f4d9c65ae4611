// Which variations a command line asks for.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/vary_child.hpp"

namespace mansard {

class Library;

struct Variations {
  std::vector<Variation> all;  ///< row by row
  int columns = 0;             ///< of a table; 0 when one thing varies and any number will do
  std::string common;          ///< what all share: "Terrace, Roof.Pitch = 45, seed 7"
};

/// --styles, each --sweep and --count (or nothing: twelve seeds) are what varies: one of them, or
/// two as rows and columns. `library` holds the script. Throws UsageError and Failure; `warnings`
/// are of linking.
Variations variations_of(const Arguments& arguments, const Library& library, Diagnostics& warnings);

}  // namespace mansard
