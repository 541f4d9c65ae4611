// Rules override by symbol: the productions that one style gives replace all that it inherits.

#include <utility>

#include "styles/members.hpp"

namespace mansard {

namespace {

using syntax::AbstractSymbol;
using syntax::Rule;

std::vector<Generation> generations_of(const Slot<Rule>& slot) {
  std::vector<Generation> generations;
  for (const Given<Rule>& given : slot.given) {
    if (given.dropped) continue;
    if (generations.empty() || generations.back().from.style != given.from.style) {
      generations.push_back({given.from, {}, {}});
    }
    generations.back().productions.push_back(given.syntax);
    generations.back().origins.push_back(given.from);
  }
  return generations;
}

/// An `abstract` without parameters says nothing of how many there are.
std::unordered_map<std::string_view, const Given<AbstractSymbol>*> asked_with_parameters(
    const Members& members) {
  std::unordered_map<std::string_view, const Given<AbstractSymbol>*> asked;
  for (const auto& slot : members.abstract_symbols) {
    for (const auto& given : slot.given) {
      if (!given.dropped && !given.syntax->params.empty()) asked[slot.name] = &given;
    }
  }
  return asked;
}

}  // namespace

void link_symbols(Linking& linking) {
  LinkedStyle& result = linking.result;
  const auto asked = asked_with_parameters(linking.members);
  for (const Slot<Rule>& slot : linking.members.symbols) {
    SymbolRules symbol{slot.name, generations_of(slot)};
    if (symbol.generations.empty()) continue;
    const auto found = asked.find(slot.name);
    check_symbol(linking, symbol, found == asked.end() ? nullptr : found->second);
    result.symbol_index.emplace(slot.name, result.symbols.size());
    result.symbols.push_back(std::move(symbol));
  }
}

const SymbolRules* LinkedStyle::find_symbol(std::string_view name) const {
  const auto found = symbol_index.find(name);
  return found == symbol_index.end() ? nullptr : &symbols[found->second];
}

}  // namespace mansard
