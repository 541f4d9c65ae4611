// Why every style stands where it does in the resolution order.
#pragma once

#include <vector>

#include "styles/style.hpp"

namespace mansard {

/// Where a style stands among the ancestors of the one that was linked, itself among them.
struct Standing {
  const syntax::Style* style = nullptr;
  std::vector<uint32_t> parents;  ///< their places in the order, as the style names them
  std::vector<uint32_t> heirs;    ///< the places of those that name it as a parent
  /// It comes after the one before it because a style names two parents in this order: that one is
  /// the first or an ancestor of the first, this one the second or an ancestor of the second. Null
  /// when the one before it inherits from it, which is reason enough.
  const syntax::Style* chooser = nullptr;
  const syntax::Style *first = nullptr, *second = nullptr;
};

/// One a style, in resolution order.
std::vector<Standing> standings(const LinkedStyle& style);

}  // namespace mansard
