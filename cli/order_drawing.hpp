// A resolution order as a graph, drawn as `git log --graph` draws commits.
#pragma once

#include <string>
#include <vector>

#include "styles/standing.hpp"

namespace mansard {

struct DrawnLine {
  std::string lanes;                   ///< "● │", "├─╯"
  const Standing* standing = nullptr;  ///< whose dot it is; null for a line between two
};

/// Styles from top to bottom as they are asked; a line leads from each down to its parents.
std::vector<DrawnLine> drawn_order(const std::vector<Standing>& standings);

/// Why a style stands below the one before it: "Both names Narrow before it", "parent of Narrow".
/// Empty for the first.
std::string why(const std::vector<Standing>& standings, std::size_t place);

}  // namespace mansard
