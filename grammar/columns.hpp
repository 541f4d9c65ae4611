// Columns: consecutive rows of one kind align their signs.
#pragma once

#include <functional>
#include <span>

#include "grammar/page.hpp"

namespace mansard::layout {

/// Members that begin one line together.
struct Row {
  std::size_t member = 0, members = 1;  ///< the first of them, and how many
  uint32_t first = 0;                   ///< token
  Range line;                           ///< without annotations on lines above
  std::vector<uint32_t> stops;          ///< tokens that may be moved to the right, in order
  std::string_view key;                 ///< rows of one key align; empty: with none
  int most_padding = 16;                ///< columns; with more the eye is lost on the way
  bool all_or_none = false;             ///< the rows of its key that follow each other
  uint32_t weight = 0;                  ///< the ':' of a probability; 0: none
  std::string_view symbol;              ///< whose probability
  bool apart = false;                   ///< a blank line, a comment or an annotation stands above
};

/// Pads the stops of rows that follow each other so that the first, second … of each stand below
/// one another, where no row becomes wider than the page or needs more lines. `write` writes a row.
void align(std::span<const Row> rows, int column, Page& page, const Tokens& tokens,
           const std::function<void(const Row&)>& write);

}  // namespace mansard::layout
