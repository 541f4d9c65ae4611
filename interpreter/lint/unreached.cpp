// W009 and W016: rules, elements and materials of symbols that no derivation comes to.
#include <algorithm>

#include "interpreter/lint/linting.hpp"
#include "interpreter/messages.hpp"

namespace mansard {

namespace {

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

/// The first rule that a style gives for a symbol nothing reaches.
struct Lost {
  const syntax::Style* style;
  const syntax::Rule* rule;
  uint32_t symbol;
};

class Unreached {
 public:
  explicit Unreached(Linting& linting) : linting_(linting) {}

  void warn() {
    for (const syntax::Style& style : linting_.file.styles) collect(style);
    if (!lost_.empty()) {
      // First what no other rule emits: what hangs below it needs no words of its own.
      const auto emitted = emitted_by_others(linting_.program);
      for (const Lost& lost : lost_) {
        if (!is_emitted(lost, emitted)) complain(lost);
      }
      for (const Lost& lost : lost_) complain(lost);
    }
    for (const syntax::Style& style : linting_.file.styles) check_entries(style);
  }

 private:
  void collect(const syntax::Style& style) {
    if (linting_.live_heirs(style).empty() || !linting_.linked(style)) return;
    std::set<std::string_view> seen;
    for (const syntax::StyleMember& member : style.members) {
      const auto* block = std::get_if<syntax::Block>(&member);
      if (!block) continue;
      for (const syntax::BlockItem& item : block->items) {
        const auto* rule = std::get_if<syntax::Rule>(&item);
        if (!rule || !seen.insert(rule->name.text).second) continue;
        const auto symbol = linting_.program.symbols.find(rule->name.text);
        if (!symbol || linting_.reached(style, *symbol) || is_told(style, *rule, *symbol)) continue;
        lost_.push_back({&style, rule, *symbol});
      }
    }
  }

  /// The same is said of an ancestor in this script.
  bool is_told(const syntax::Style& style, const syntax::Rule& rule, uint32_t symbol) const {
    const SymbolRules* const rules = linting_.linked(style)->find_symbol(rule.name.text);
    return rules && std::ranges::any_of(rules->generations, [&](const Generation& generation) {
             const syntax::Style& other = *generation.from.style;
             return &other != &style && linting_.here(other.name.at) &&
                    !linting_.reached(other, symbol);
           });
  }

  bool is_emitted(const Lost& lost, const std::vector<std::vector<bool>>& emitted) const {
    return std::ranges::any_of(linting_.live_heirs(*lost.style),
                               [&](uint16_t heir) { return emitted[heir][lost.symbol]; });
  }

  void complain(const Lost& lost) {
    if (linting_.reached(*lost.style, lost.symbol)) return;  // by way of another lost one
    const std::string_view name = lost.rule->name.text;
    const std::string_view inherited = linting_.nearest_of(name, inherited_symbols(lost));
    if (!inherited.empty()) {
      suspect(inherited);
      linting_.warn(
          "W016", lost.rule->name.at,
          "nothing emits " + quoted(name) + ", which is nearly the inherited " + quoted(inherited),
          "did you mean to override " + quoted(inherited) + "?");
    } else {
      const std::string_view near = linting_.nearest_of(name, reached_terminals(lost));
      if (!near.empty()) suspect(near);
      linting_.warn("W009", lost.rule->name.at,
                    quoted(name) + " has rules, but no derivation comes to it",
                    near.empty() ? "emit it somewhere, or take its rules away"
                                 : quoted(near) +
                                       " is emitted and has no rules: one of them may "
                                       "be misspelt",
                    emissions_of(near));
    }
    for (const uint16_t heir : linting_.live_heirs(*lost.style)) {
      linting_.reach.go_on_from(heir, lost.symbol);
    }
  }

  /// The first place in this script where a rule emits the symbol.
  std::vector<Note> emissions_of(std::string_view name) const {
    const auto symbol = linting_.program.symbols.find(name);
    for (const Step& step : linting_.program.steps) {
      if (step.kind != StepKind::emit || symbol != step.what || !linting_.here(step.at)) continue;
      return {{quoted(name) + " is emitted here", step.at}};
    }
    return {};
  }

  void suspect(std::string_view name) {
    if (const auto symbol = linting_.program.symbols.find(name)) linting_.suspected.insert(*symbol);
  }

  /// Those that a parent gives rules for, and the terminals that it emits; none when the symbol is
  /// itself a parent's.
  std::vector<std::string_view> inherited_symbols(const Lost& lost) const {
    const LinkedStyle& linked = *linting_.linked(*lost.style);
    std::vector<std::string_view> names;
    if (linked.order.size() == 1) return names;
    for (const SymbolRules& rules : linked.symbols) {
      if (rules.generations.back().from.style == lost.style) continue;
      if (rules.name == lost.rule->name.text) return {};
      names.push_back(rules.name);
    }
    for (const syntax::Style* parent : linked.order) {
      if (parent == lost.style) continue;
      const auto number = linting_.program.style_numbers.find(parent->name.text);
      if (number != linting_.program.style_numbers.end()) add_terminals(number->second, names);
    }
    return names;
  }

  std::vector<std::string_view> reached_terminals(const Lost& lost) const {
    std::vector<std::string_view> names;
    for (const uint16_t heir : linting_.live_heirs(*lost.style)) add_terminals(heir, names);
    return names;
  }

  void add_terminals(uint16_t style, std::vector<std::string_view>& names) const {
    const Program& program = linting_.program;
    for (uint32_t symbol = 0; symbol < program.symbols.size(); ++symbol) {
      if (linting_.reach.reached(style, symbol) && program.styles[style].rules[symbol] == none) {
        names.push_back(program.symbols[symbol]);
      }
    }
  }

  // ---- elements and materials

  void check_entries(const syntax::Style& style) {
    const LinkedStyle* const linked = linting_.linked(style);
    if (linting_.live_heirs(style).empty() || !linked) return;
    for (const syntax::StyleMember& member : style.members) {
      const auto* block = std::get_if<syntax::Block>(&member);
      if (!block) continue;
      for (const auto& entry : block->elements) check_entry(style, *linked, entry, "elements");
      for (const auto& entry : block->materials) check_entry(style, *linked, entry, "materials");
    }
  }

  template <class Entry>
  void check_entry(const syntax::Style& style, const LinkedStyle& linked, const Entry& entry,
                   const std::string& kind) {
    const bool gives = entry.kind == syntax::EntryKind::set || entry.kind == syntax::EntryKind::add;
    const auto symbol = linting_.program.symbols.find(entry.symbol.text);
    if (!gives || (symbol && linting_.reached(style, *symbol))) return;
    const bool is_told = std::ranges::any_of(linked.order, [&](const syntax::Style* other) {
      return told_.contains({other, entry.symbol.text});
    });
    if (is_told) return;
    told_.emplace(&style, entry.symbol.text);
    const Lost lost{&style, nullptr, none};
    const std::string_view near = linting_.nearest_of(entry.symbol.text, reached_terminals(lost));
    linting_.warn("W009", entry.symbol.at,
                  quoted(entry.symbol.text) + " has " + kind + ", but no shape is ever one",
                  near.empty() ? "emit it somewhere, or take the entry away"
                               : "did you mean " + quoted(near) + "?");
    if (!near.empty()) suspect(near);
  }

  Linting& linting_;
  std::vector<Lost> lost_;
  std::set<std::pair<const syntax::Style*, std::string_view>> told_;
};

}  // namespace

void warn_of_unreached(Linting& linting) { Unreached(linting).warn(); }

}  // namespace mansard
