// W016 for blocks: a new block that gives what an inherited block of nearly the same name has.

#include <algorithm>
#include <string>
#include <utility>

#include "styles/complaint.hpp"
#include "styles/members.hpp"

namespace mansard {

namespace {

/// Whether an ancestor of the style at hand gives one of the block's members in block `home`.
class Likeness {
 public:
  Likeness(const Linking& linking, std::string_view home) : linking_(linking), home_(home) {}

  bool operator()(const syntax::Rule& rule) const {
    return gives(linking_.members.symbols,
                 [&](const auto& slot) { return slot.name == rule.name.text; });
  }
  bool operator()(const syntax::Variable& variable) const {
    return gives(linking_.members.variables, [&](const auto& slot) {
      return slot.name == variable.name.text && slot.block == home_;
    });
  }
  bool operator()(const syntax::Function& function) const {
    return gives(linking_.members.functions, [&](const auto& slot) {
      return slot.name == function.name.text && slot.block == home_;
    });
  }
  bool operator()(const syntax::AbstractSymbol&) const { return false; }

 private:
  template <class T, class Same>
  bool gives(const std::vector<Slot<T>>& slots, Same same) const {
    const auto slot = std::ranges::find_if(slots, same);
    if (slot == slots.end()) return false;
    return std::ranges::any_of(slot->given, [&](const Given<T>& given) {
      return given.rank > 0 && given.from.block && given.from.block->name.text == home_;
    });
  }

  const Linking& linking_;
  std::string_view home_;
};

/// It gives a rule of the other block, or its variables and nothing that would be new.
bool resembles(const syntax::Block& block, const Likeness& alike) {
  bool rules = false, others = false, new_rules = false;
  for (const syntax::BlockItem& item : block.items) {
    const bool is_rule = std::holds_alternative<syntax::Rule>(item);
    const bool is_alike = std::visit(alike, item);
    rules = rules || (is_rule && is_alike);
    others = others || (!is_rule && is_alike);
    new_rules = new_rules || (is_rule && !is_alike);
  }
  return rules || (others && !new_rules);
}

std::set<std::string_view> inherited_blocks(const Order& order) {
  std::set<std::string_view> names;
  for (std::size_t rank = 1; rank < order.size(); ++rank) {
    for_each_block(*order[rank], [&](const syntax::Block& block) {
      if (block.kind == syntax::BlockKind::rules) names.insert(block.name.text);
    });
  }
  return names;
}

}  // namespace

void find_misspelt_blocks(Linking& linking) {
  const Order& order = linking.ancestry.order();
  if (order.size() == 1) return;
  const std::set<std::string_view> inherited = inherited_blocks(order);
  const std::vector<std::string_view> names(inherited.begin(), inherited.end());
  for_each_block(*order.front(), [&](const syntax::Block& block) {
    const bool is_new =
        block.kind == syntax::BlockKind::rules && !inherited.contains(block.name.text);
    if (!is_new || linking.suggestions_left-- <= 0) return;
    const auto near = nearest(block.name.text, names);
    if (!near) return;
    if (!resembles(block, Likeness(linking, *near))) return;
    linking.misspelt_blocks.insert(block.name.text);
    if (block.replace) return;  // an error already
    linking.diagnostics.add(
        warning("W016", block.name.at,
                "block " + in_quotes(block.name.text) + " is new, but gives what block " +
                    in_quotes(*near) + " has",
                {while_linking(*order.front())}, "did you mean " + in_quotes(*near) + "?"));
  });
}

}  // namespace mansard
