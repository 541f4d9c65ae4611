// --sweep: the values that a variable takes from picture to picture.
#pragma once

#include <string>
#include <vector>

#include "styles/style.hpp"

namespace mansard {

class Library;

/// No more pictures on a sheet, and no more values in a sweep.
constexpr std::size_t most_variations = 400;

/// A variable and a value for it, both as a script writes them.
struct Change {
  std::string name;  ///< "Tile.WindowWidth", or "Height" for one of the style
  std::string value;
};

/// `text` is NAME=from:to:step, NAME=value,value… or NAME, which takes the variable's @range or
/// @choice. Throws UsageError for another form, Failure when the style has no such variable or the
/// variable nothing to take; `library` is asked for styles that have it.
std::vector<Change> sweep(const std::string& text, const LinkedStyle& style,
                          const Library& library);

/// NAME=VALUE of --set, likewise. A bare word is text unless it is a name that the style knows.
Change setting(const std::string& text, const LinkedStyle& style, const Library& library);

}  // namespace mansard
