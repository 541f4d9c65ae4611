// The order in which a style and its ancestors are asked for a member: C3, as Python's
// (Barrett et al. 1996, "A monotonic superclass linearization for Dylan").
#pragma once

#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "grammar/diagnostic.hpp"
#include "grammar/syntax.hpp"
#include "styles/library.hpp"

namespace mansard {

using Order = std::vector<const syntax::Style*>;

/// A style with the orders of itself and of all its ancestors.
class Ancestry {
 public:
  /// Nothing when a parent is missing or named twice, when styles inherit in a ring, or when the
  /// parents' orders contradict each other; `diagnostics` says which. An heir of a final style is
  /// an error too, but has an order.
  static std::optional<Ancestry> of(const Library& library, const syntax::Style& style,
                                    Diagnostics& diagnostics);

  const Order& order() const { return order_of(*style_); }
  const Order& order_of(const syntax::Style& style) const { return lines_.at(&style).order; }
  /// Also when they are the same.
  bool inherits(const syntax::Style& heir, const syntax::Style& ancestor) const {
    return lines_.at(&heir).members.contains(&ancestor);
  }
  /// The most basic style that has both in its order: the one to blame when they do not agree.
  const syntax::Style& meeting(const syntax::Style& a, const syntax::Style& b) const;

 private:
  friend class Lineariser;
  struct Line {
    Order order;
    std::unordered_set<const syntax::Style*> members;
  };
  explicit Ancestry(const syntax::Style& style) : style_(&style) {}

  const syntax::Style* style_;
  std::unordered_map<const syntax::Style*, Line> lines_;
};

}  // namespace mansard
