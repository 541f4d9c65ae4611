// W003: two parents that know nothing of each other give the same member.

#include <algorithm>
#include <string>

#include "styles/complaint.hpp"
#include "styles/members.hpp"

namespace mansard {

namespace {

bool has_value(const syntax::Variable& variable) { return bool(variable.value); }
bool has_value(const syntax::Function&) { return true; }

/// An `abstract var` asks and takes part in no quarrel.
template <class T>
bool counts(const Given<T>& given) {
  return !given.dropped && has_value(*given.syntax);
}

template <class T>
void check_slot(Linking& linking, const Slot<T>& slot, const char* kind) {
  const auto winner = std::ranges::find_if(slot.given, [](const auto& g) { return counts(g); });
  if (winner == slot.given.end() || winner->syntax->pre.override) return;
  const auto loser = std::find_if(std::next(winner), slot.given.end(), [&](const Given<T>& g) {
    return counts(g) && !linking.ancestry.inherits(*winner->from.style, *g.from.style);
  });
  if (loser == slot.given.end()) return;
  warn_of_two(linking, full_name(slot.block, slot.name), kind,
              {winner->from.style, winner->syntax->name.at},
              {loser->from.style, loser->syntax->name.at});
}

}  // namespace

namespace {

/// `House, Cornice`, whose second goes on with super, the other way round; empty when the heir does
/// not name it as its parent.
std::string other_order(const syntax::Style& heir, const Rival& loser) {
  std::string parents;
  bool names_it = false;
  for (const syntax::Name& parent : heir.parents) {
    const bool is_it = parent.text == loser.style->name.text;
    names_it = names_it || is_it;
    if (!is_it) parents += ", " + std::string(parent.text);
  }
  if (!loser.goes_on || !names_it) return {};
  const std::string name(loser.style->name.text);
  return "write '" + std::string(heir.name.text) + " : " + name + parents +
         "': " + in_quotes(name) + " goes on with super";
}

}  // namespace

void warn_of_two(Linking& linking, std::string_view name, std::string_view kind, Rival winner,
                 Rival loser) {
  const syntax::Style& heir = linking.ancestry.meeting(*winner.style, *loser.style);
  const std::string first = in_quotes(winner.style->name.text);
  std::string help = "give " + in_quotes(name) + " in " + in_quotes(heir.name.text);
  if (kind != "entry") {
    help += ", or mark the " + std::string(kind) + " of " + first + " with override";
  }
  if (std::string order = other_order(heir, loser); !order.empty()) help = std::move(order);
  linking.diagnostics.add(
      warning("W003", heir.name.at,
              in_quotes(name) + " comes from both " + first + " and " +
                  in_quotes(loser.style->name.text) + ", and " + first + " wins",
              {{"given by " + first + " here", winner.at},
               {"given by " + in_quotes(loser.style->name.text) + " here", loser.at},
               while_linking(heir)},
              std::move(help)));
}

void check_conflicts(Linking& linking) {
  for (const auto& slot : linking.members.variables) check_slot(linking, slot, "variable");
  for (const auto& slot : linking.members.functions) check_slot(linking, slot, "function");
}

}  // namespace mansard
