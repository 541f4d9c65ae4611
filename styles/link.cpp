// The steps of linking one style, and what is left to say when all is known.

#include <utility>

#include "styles/complaint.hpp"
#include "styles/members.hpp"

namespace mansard {

std::optional<LinkedStyle> link(const Library& library, const syntax::Style& style,
                                Diagnostics& diagnostics) {
  const std::optional<Ancestry> ancestry = Ancestry::of(library, style, diagnostics);
  if (!ancestry) return std::nullopt;
  const Members members = gather(ancestry->order());

  LinkedStyle result;
  result.syntax = &style;
  result.order = ancestry->order();
  result.blocks = members.blocks;
  result.block_set.insert(members.blocks.begin(), members.blocks.end());
  Linking linking{*ancestry, members, result, diagnostics};
  check_declarations(linking);
  check_overriding(linking);
  check_conflicts(linking);
  find_misspelt_blocks(linking);
  link_start(linking);
  link_seed(linking);
  link_symbols(linking);
  link_variables(linking);
  link_functions(linking);
  link_elements(linking);
  link_materials(linking);
  find_missing(linking);
  return result;
}

void link_start(Linking& linking) {
  for (const syntax::Style* style : linking.ancestry.order()) {
    for (const syntax::StyleMember& member : style->members) {
      const auto* start = std::get_if<syntax::Start>(&member);
      if (!start) continue;
      linking.result.start = start->symbol.text;
      linking.result.start_at = start->symbol.at;
      return;
    }
  }
}

void find_missing(Linking& linking) {
  LinkedStyle& result = linking.result;
  const auto miss = [&](const std::string& what, Span asked) {
    result.missing.push_back(
        error(result.syntax->name.at,
              "style " + in_quotes(result.name()) + " is abstract: it has no " + what,
              {{"asked for here", asked}, while_linking(*result.syntax)}));
  };
  std::unordered_set<std::string_view> with_elements;
  for (const ElementBinding& binding : result.elements) with_elements.insert(binding.symbol);
  for (const auto& slot : linking.members.abstract_symbols) {
    if (result.find_symbol(slot.name) || with_elements.contains(slot.name)) continue;
    for (const auto& given : slot.given) {
      if (given.dropped) continue;
      miss("rule for " + in_quotes(slot.name), given.syntax->name.at);
      result.asked.emplace(slot.name, given.syntax);
      break;
    }
  }
  for (const VariableBinding& variable : result.variables) {
    if (variable.syntax->value) continue;
    miss("value for " + in_quotes(variable.name), variable.syntax->name.at);
  }
}

bool LinkedStyle::has_block(std::string_view name) const { return block_set.contains(name); }

}  // namespace mansard
