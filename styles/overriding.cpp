// Whether the words `final`, `override` and `replace` are kept.

#include <algorithm>
#include <set>
#include <string>
#include <type_traits>
#include <utility>

#include "styles/complaint.hpp"
#include "styles/members.hpp"

namespace mansard {

namespace {

using syntax::Function;
using syntax::Rule;
using syntax::Variable;

template <class T>
constexpr const char* kind = std::is_same_v<T, Rule>       ? "rule"
                             : std::is_same_v<T, Variable> ? "variable"
                                                           : "function";

template <class T>
Diagnostic overrides_final(const Linking& linking, const Slot<T>& slot, const Given<T>& heir,
                           const Given<T>& final) {
  return error(heir.syntax->name.at,
               std::string(kind<T>) + " " + in_quotes(full_name(slot.block, slot.name)) +
                   " is final and can not be overridden",
               {{"final in style " + in_quotes(final.from.style->name.text), final.syntax->name.at},
                while_linking(linking.ancestry.meeting(*heir.from.style, *final.from.style))});
}

template <class T>
Diagnostic replaces_final(const Linking& linking, const Slot<T>& slot, const Given<T>& final) {
  const Origin& replacer = linking.members.replaced.replacer(final.from.block->name.text);
  return error(replacer.block->name.at,
               "block " + in_quotes(replacer.block->name.text) +
                   " can not be replaced: " + kind<T> + " " + in_quotes(slot.name) + " is final",
               {{"final in style " + in_quotes(final.from.style->name.text), final.syntax->name.at},
                while_linking(linking.ancestry.meeting(*replacer.style, *final.from.style))});
}

/// From the base on: what one style makes final, no more derived one may give.
template <class T>
void check_final(Linking& linking, const Slot<T>& slot) {
  const Given<T>*forbids = nullptr, *own = nullptr;
  std::size_t rank = linking.ancestry.order().size();
  for (auto given = slot.given.rbegin(); given != slot.given.rend(); ++given) {
    if (given->rank != rank && own) forbids = std::exchange(own, nullptr);
    rank = given->rank;
    if (given->dropped) {
      if (given->syntax->pre.final) linking.diagnostics.add(replaces_final(linking, slot, *given));
      continue;
    }
    if (given->syntax->pre.final) own = &*given;
    const auto next = std::next(given);
    if (forbids && (next == slot.given.rend() || next->rank != rank)) {
      linking.diagnostics.add(overrides_final(linking, slot, *given, *forbids));
    }
  }
}

template <class T>
std::string suggestion(Linking& linking, const std::vector<Slot<T>>& slots, const Slot<T>& slot,
                       std::size_t rank) {
  if (rank + 1 == linking.ancestry.order().size() || linking.suggestions_left-- <= 0) return {};
  std::vector<std::string> elsewhere;
  std::vector<std::string_view> candidates;
  for (const Slot<T>& other : slots) {
    if (other.given.back().rank <= rank) continue;
    if (other.block == slot.block) {
      candidates.push_back(other.name);
    } else if (other.name == slot.name) {
      elsewhere.push_back(full_name(other.block, other.name));
    }
  }
  if (!elsewhere.empty()) return "there is " + in_quotes(elsewhere.front());
  return did_you_mean(slot.name, std::move(candidates));
}

template <class T>
void check_overrides(Linking& linking, const std::vector<Slot<T>>& slots, const Slot<T>& slot,
                     std::size_t basest_abstract) {
  const std::size_t basest = std::max(slot.given.back().rank, basest_abstract);
  std::size_t complained = linking.ancestry.order().size();
  for (const Given<T>& given : slot.given) {
    if (!given.syntax->pre.override || given.rank < basest || given.rank == complained) continue;
    complained = given.rank;
    const syntax::Style& style = *given.from.style;
    Diagnostic complaint =
        error(given.syntax->name.at,
              in_quotes(full_name(slot.block, slot.name)) + " overrides nothing: no parent of " +
                  in_quotes(style.name.text) + " has this " + kind<T>,
              {while_linking(style)}, suggestion(linking, slots, slot, given.rank));
    complaint.also.push_back(given.syntax->pre.override);
    linking.diagnostics.add(std::move(complaint));
  }
}

template <class T>
void check_slots(Linking& linking, const std::vector<Slot<T>>& slots) {
  for (const Slot<T>& slot : slots) {
    check_final(linking, slot);
    check_overrides(linking, slots, slot, 0);
  }
}

/// `replace` in a style with parents, none of which has the block. One without may be a mixin.
void check_replacements(Linking& linking) {
  const Order& order = linking.ancestry.order();
  std::set<std::string_view> below;
  for (std::size_t rank = order.size(); rank-- > 0;) {
    for_each_block(*order[rank], [&](const syntax::Block& block) {
      if (!block.replace || order[rank]->parents.empty() || below.contains(block.name.text)) return;
      std::string help;
      if (linking.suggestions_left-- > 0)
        help = did_you_mean(block.name.text, {below.begin(), below.end()});
      Diagnostic complaint =
          error(block.name.at,
                "'replace " + std::string(block.name.text) + "' replaces nothing: no parent of " +
                    in_quotes(order[rank]->name.text) + " has this block",
                {while_linking(*order[rank])}, std::move(help));
      complaint.also.push_back(block.replace);
      linking.diagnostics.add(std::move(complaint));
    });
    for_each_block(*order[rank],
                   [&](const syntax::Block& block) { below.insert(block.name.text); });
  }
}

}  // namespace

std::string full_name(std::string_view block, std::string_view name) {
  return block.empty() ? std::string(name) : std::string(block) + "." + std::string(name);
}

void check_overriding(Linking& linking) {
  const Members& members = linking.members;
  check_slots(linking, members.variables);
  check_slots(linking, members.functions);
  check_replacements(linking);
  std::unordered_map<std::string_view, std::size_t> abstracts;  // an `abstract` can be overridden
  for (const auto& slot : members.abstract_symbols) abstracts[slot.name] = slot.given.back().rank;
  for (const Slot<Rule>& slot : members.symbols) {
    check_final(linking, slot);
    const auto asked = abstracts.find(slot.name);
    check_overrides(linking, members.symbols, slot, asked == abstracts.end() ? 0 : asked->second);
  }
}

}  // namespace mansard
