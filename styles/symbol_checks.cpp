// What the generations of a symbol may not disagree on, or should not without a word.

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "styles/complaint.hpp"
#include "styles/members.hpp"

namespace mansard {

namespace {

using syntax::AbstractSymbol;
using syntax::Rule;

bool uses_super(const syntax::Body& body);

bool uses_super(const syntax::Part& part) {
  return uses_super(part.body) ||
         std::ranges::any_of(part.group, [](const auto& inner) { return uses_super(inner); });
}

bool uses_super(const syntax::Element& element) {
  if (std::holds_alternative<syntax::Super>(element.is)) return true;
  if (const auto* push = std::get_if<syntax::Push>(&element.is)) return uses_super(push->body);
  if (const auto* branch = std::get_if<syntax::If>(&element.is)) {
    return std::ranges::any_of(branch->arms, [](const auto& arm) { return uses_super(arm.body); });
  }
  const auto& emit = std::get<syntax::Emit>(element.is);
  return emit.parts && std::ranges::any_of(emit.parts->parts, [](const syntax::Part& part) {
           return uses_super(part);
         });
}

bool uses_super(const syntax::Body& body) {
  return std::ranges::any_of(body, [](const syntax::Element& e) { return uses_super(e); });
}

bool says_override(const Generation& generation) {
  return std::ranges::any_of(generation.productions,
                             [](const Rule* rule) { return bool(rule->pre.override); });
}

/// Checks one symbol's generations against each other.
class SymbolCheck {
 public:
  SymbolCheck(Linking& linking, const SymbolRules& symbol, const Given<AbstractSymbol>* asked)
      : linking_(linking), ancestry_(linking.ancestry), symbol_(symbol), asked_(asked) {}

  void check() {
    check_parameters();
    check_unrelated();
    check_blocks();
  }

 private:
  const syntax::Style& style(std::size_t i) const { return *generations()[i].from.style; }
  const std::vector<Generation>& generations() const { return symbol_.generations; }

  /// Where the number of a symbol's parameters is said first: in an `abstract`, or by the base
  /// style.
  struct Reference {
    std::size_t parameters;
    Span at;
    const syntax::Style* style;
  };

  Reference reference() const {
    if (asked_) return {asked_->syntax->params.size(), asked_->syntax->name.at, asked_->from.style};
    const Generation& base = generations().back();
    const Rule& first = *base.productions.front();
    return {first.params.size(), first.head, base.from.style};
  }

  void check_parameters() {
    const Reference expected = reference();
    for (const Generation& generation : generations()) {
      const auto other = std::ranges::find_if(generation.productions, [&](const Rule* rule) {
        return rule->params.size() != expected.parameters;
      });
      if (other == generation.productions.end()) continue;
      linking_.diagnostics.add(
          error((*other)->head,
                in_quotes(symbol_.name) + " has " + counted((*other)->params.size()) +
                    " here but " + std::to_string(expected.parameters) + " elsewhere",
                {{"with " + counted(expected.parameters) + " here", expected.at},
                 while_linking(ancestry_.meeting(*generation.from.style, *expected.style))},
                "give all productions of a symbol the same number of parameters"));
    }
  }

  static std::string counted(std::size_t parameters) {
    return std::to_string(parameters) + (parameters == 1 ? " parameter" : " parameters");
  }

  /// W003. Goes down as far as `super` does: what it does not reach is hidden from everyone.
  void check_unrelated() {
    for (std::size_t i = 0; i < generations().size(); ++i) {
      const bool asks_on = uses_super(generations()[i]);
      if (!asks_on && !says_override(generations()[i])) {
        for (std::size_t j = i + 1; j < generations().size(); ++j) {
          if (ancestry_.inherits(style(i), style(j)) || settled(i, j)) continue;
          warn_of_two(linking_, symbol_.name, "rule", rival(i), rival(j));
          return;
        }
      }
      if (!asks_on) return;
    }
  }

  Rival rival(std::size_t i) const {
    return {&style(i), generations()[i].productions.front()->head, uses_super(generations()[i])};
  }

  /// An heir of both has the word.
  bool settled(std::size_t i, std::size_t j) const {
    for (std::size_t k = 0; k < i; ++k) {
      if (ancestry_.inherits(style(k), style(i)) && ancestry_.inherits(style(k), style(j))) {
        return true;
      }
    }
    return false;
  }

  /// W004: the variables of the one block no longer shape the symbol, those of the other do.
  void check_blocks() {
    for (std::size_t i = 0; i + 1 < generations().size(); ++i) {
      const Generation* inherited = nullptr;
      std::set<std::string_view> homes;
      for (std::size_t j = i + 1; j < generations().size(); ++j) {
        if (!ancestry_.inherits(style(i), style(j))) continue;
        if (!inherited) inherited = &generations()[j];
        for (const Origin& origin : generations()[j].origins) homes.insert(origin.block->name.text);
      }
      if (inherited) check_blocks(generations()[i], *inherited, homes);
    }
  }

  void check_blocks(const Generation& heir, const Generation& inherited,
                    const std::set<std::string_view>& homes) {
    for (std::size_t k = 0; k < heir.productions.size(); ++k) {
      const std::string_view block = heir.origins[k].block->name.text;
      if (homes.contains(block) || is_slip(block, *heir.from.style)) continue;
      warn_of_block(*heir.productions[k], block, *heir.from.style, inherited);
      return;
    }
  }

  /// The block's own name has been complained of.
  bool is_slip(std::string_view block, const syntax::Style& style) const {
    return &style == ancestry_.order().front() && linking_.misspelt_blocks.contains(block);
  }

  void warn_of_block(const Rule& rule, std::string_view block, const syntax::Style& style,
                     const Generation& inherited) {
    const std::string_view home = inherited.from.block->name.text;
    linking_.diagnostics.add(warning(
        "W004", rule.name.at,
        in_quotes(symbol_.name) + " is a rule of block " + in_quotes(home) +
            " and is overridden in block " + in_quotes(block),
        {{"inherited from here", inherited.productions.front()->head}, while_linking(style)},
        "move it into " + in_quotes(home)));
  }

  Linking& linking_;
  const Ancestry& ancestry_;
  const SymbolRules& symbol_;
  const Given<AbstractSymbol>* asked_;  ///< the `abstract` that names parameters, if there is one
};

}  // namespace

bool uses_super(const Generation& generation) {
  return std::ranges::any_of(generation.productions,
                             [](const Rule* rule) { return uses_super(rule->successor); });
}

void check_symbol(Linking& linking, const SymbolRules& symbol, const Given<AbstractSymbol>* asked) {
  SymbolCheck(linking, symbol, asked).check();
}

}  // namespace mansard
