// All that a style and its ancestors say, gathered by name before it is decided what is in force.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "grammar/syntax.hpp"
#include "styles/linearise.hpp"
#include "styles/style.hpp"

namespace mansard {

/// The `replace` words of an order. The most derived one of a block drops that block of all less
/// derived styles.
class Replacements {
 public:
  explicit Replacements(const Order& order);
  bool drops(const syntax::Block& block, std::size_t rank) const {
    const auto found = most_derived_.find(block.name.text);
    return found != most_derived_.end() && rank > found->second.rank;
  }
  /// Of a block that has one.
  const Origin& replacer(std::string_view block) const { return most_derived_.at(block).from; }

 private:
  struct Replacement {
    Origin from;
    std::size_t rank;
  };
  std::unordered_map<std::string_view, Replacement> most_derived_;
};

/// One writing of a member. `rank` is the place of its style in the order, 0 the most derived.
/// `dropped` when a `replace` of a more derived style takes its block away.
template <class T>
struct Given {
  const T* syntax;
  Origin from;
  std::size_t rank;
  bool dropped;
};

/// All writings of one name, the most derived style's first, within a style in text order.
/// `block` is empty for style-wide members and for symbols and their entries, which are global to
/// the style.
template <class T>
struct Slot {
  std::string_view block, name;
  std::vector<Given<T>> given;
};

/// Slots in the order in which a reader meets them, base style first.
struct Members {
  std::vector<Slot<syntax::Rule>> symbols;
  std::vector<Slot<syntax::AbstractSymbol>> abstract_symbols;
  std::vector<Slot<syntax::Variable>> variables;
  std::vector<Slot<syntax::Function>> functions;
  std::vector<Slot<syntax::ElementEntry>> elements;
  std::vector<Slot<syntax::MaterialEntry>> materials;
  std::vector<std::string_view> blocks;  ///< those of rules
  Replacements replaced;
};

Members gather(const Order& order);

/// Calls `visit` with every block of a style, in text order.
template <class Visit>
void for_each_block(const syntax::Style& style, Visit visit) {
  for (const syntax::StyleMember& member : style.members) {
    if (const auto* block = std::get_if<syntax::Block>(&member)) visit(*block);
  }
}

/// What the steps of one link share.
struct Linking {
  const Ancestry& ancestry;
  const Members& members;
  LinkedStyle& result;
  Diagnostics& diagnostics;
  /// Each suggestion looks at all names; a script of a hundred thousand mistakes gets no more.
  int suggestions_left = 50;
  /// New blocks of the style itself whose name is a slip for an inherited one.
  std::set<std::string_view> misspelt_blocks = {};
};

/// `Tile.WindowWidth`; just the name of what is style-wide.
std::string full_name(std::string_view block, std::string_view name);

/// One of two styles that give the same, and where.
struct Rival {
  const syntax::Style* style;
  Span at;
  bool goes_on = false;  ///< a rule that says super
};
/// W003. `kind` is what the user calls it: "rule", "variable", "function", or "entry" of Elements
/// and Materials, which can not be marked `override`.
void warn_of_two(Linking& linking, std::string_view name, std::string_view kind, Rival winner,
                 Rival loser);

// The steps, each of which fills its part of the result.
void check_declarations(Linking& linking);
void check_overriding(Linking& linking);
void check_conflicts(Linking& linking);
void find_misspelt_blocks(Linking& linking);
void link_start(Linking& linking);
void link_seed(Linking& linking);
void link_symbols(Linking& linking);
/// `asked` is the `abstract` that says how many parameters there are; may be null.
void check_symbol(Linking& linking, const SymbolRules& symbol,
                  const Given<syntax::AbstractSymbol>* asked);
void link_variables(Linking& linking);
void link_functions(Linking& linking);
void link_elements(Linking& linking);
void link_materials(Linking& linking);
/// Needs all others: what an `abstract` asks for may be given by a rule or by an element.
void find_missing(Linking& linking);

}  // namespace mansard
