// Variables and functions: the most derived style's is in force.

#include <algorithm>

#include "styles/members.hpp"

namespace mansard {

namespace {

/// An `abstract var` asks for a value and hides none.
const Given<syntax::Variable>* in_force(const Slot<syntax::Variable>& slot) {
  const Given<syntax::Variable>* asked = nullptr;
  for (const auto& given : slot.given) {
    if (given.dropped) continue;
    if (given.syntax->value) return &given;
    if (!asked) asked = &given;
  }
  return asked;
}

}  // namespace

void link_variables(Linking& linking) {
  LinkedStyle& result = linking.result;
  for (const auto& slot : linking.members.variables) {
    const auto* winner = in_force(slot);
    if (!winner) continue;
    VariableBinding binding{slot.block, slot.name, winner->syntax, winner->from, {}};
    for (const auto& given : slot.given) {
      if (!given.dropped && given.rank > winner->rank) binding.overrides.push_back(given.from);
    }
    result.variable_index.emplace(full_name(slot.block, slot.name), result.variables.size());
    result.variables.push_back(std::move(binding));
  }
}

void link_functions(Linking& linking) {
  LinkedStyle& result = linking.result;
  for (const auto& slot : linking.members.functions) {
    const auto winner = std::ranges::find_if(slot.given, [](const auto& g) { return !g.dropped; });
    if (winner == slot.given.end()) continue;
    result.function_index.emplace(full_name(slot.block, slot.name), result.functions.size());
    FunctionBinding binding{slot.block, slot.name, winner->syntax, winner->from, {}};
    for (auto given = std::next(winner); given != slot.given.end(); ++given) {
      if (!given->dropped && given->rank > winner->rank) binding.overrides.push_back(given->from);
    }
    result.functions.push_back(std::move(binding));
  }
}

const VariableBinding* LinkedStyle::find_variable(std::string_view block,
                                                  std::string_view name) const {
  const auto found = variable_index.find(full_name(block, name));
  return found == variable_index.end() ? nullptr : &variables[found->second];
}

const FunctionBinding* LinkedStyle::find_function(std::string_view block,
                                                  std::string_view name) const {
  const auto found = function_index.find(full_name(block, name));
  return found == function_index.end() ? nullptr : &functions[found->second];
}

}  // namespace mansard
