// W007 and W018: productions that are never chosen, and probabilities that can not be met.
#include <algorithm>
#include <map>
#include <optional>

#include "interpreter/lint/linting.hpp"

namespace mansard {

namespace {

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

std::string number_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// The productions of one symbol that one style gives.
class Chances {
 public:
  Chances(Linting& linting, const RuleSet& rules) : linting_(linting), program_(linting.program) {
    const auto first = program_.productions.begin() + rules.first;
    for (auto p = first; p != first + rules.count; ++p) classes_[index_of(*p)].push_back(&*p);
    name_ = first->syntax->name.text;
  }

  void warn() {
    for (const auto& [index, productions] : classes_) {
      warn_of_order(productions);
      warn_of_zeros(productions);
      warn_of_sums(productions);
    }
  }

 private:
  using Productions = std::vector<const Production*>;

  static std::string_view text_of(const syntax::ExprPtr& expr) {
    return expr ? expr->at.text() : std::string_view();
  }
  /// Productions that test one index are candidates among themselves; a name tests none.
  static std::string_view index_of(const Production& p) {
    return p.index_test == none ? std::string_view() : text_of(p.syntax->index);
  }

  std::optional<bool> guard_of(const Production& p) const {
    if (p.guard == none) return true;
    const ExprNode& node = program_.nodes[p.guard];
    if (node.kind != ExprKind::constant) return std::nullopt;
    const Value& value = program_.constants[node.first];
    return value.type == Type::boolean ? std::optional(value.boolean) : std::nullopt;
  }

  /// 1 where none is given; nothing where it has to be computed.
  std::optional<double> probability_of(const Production& p) const {
    if (p.probability == none) return 1;
    const ExprNode& node = program_.nodes[p.probability];
    if (node.kind != ExprKind::constant) return std::nullopt;
    const Value& value = program_.constants[node.first];
    return value.type == Type::number ? std::optional(value.number) : std::nullopt;
  }

  void never(const Production& p, const std::string& why, std::vector<Note> notes = {}) {
    linting_.warn("W007", p.syntax->head,
                  "this production of " + quoted(name_) + " is never chosen: " + why,
                  "take it away, or put its condition right", std::move(notes));
  }

  void warn_of_order(const Productions& productions) {
    const Production* always =
        nullptr;  // a candidate whatever the shape, or whatever was not before
    for (const Production* p : productions) {
      const std::optional<bool> holds = guard_of(*p);
      if (p->is_else && !p->joins_else && always) {
        never(*p, "one before it always fits",
              {{always->is_else ? "this takes all that is left" : "this always fits",
                always->syntax->head}});
      } else if (holds == false) {
        never(*p, "its condition is never true");
      }
      if (holds == true && !always) always = p;
    }
  }

  void warn_of_zeros(const Productions& productions) {
    Productions zeros;
    for (const Production* p : productions) {
      if (probability_of(*p) == 0.0) zeros.push_back(p);
    }
    if (zeros.empty()) return;
    if (zeros.size() < productions.size()) {
      for (const Production* p : zeros) never(*p, "its probability is 0");
      return;
    }
    linting_.warn("W018", program_.spans[zeros.front()->probability],
                  "the probabilities of " + quoted(name_) + " add up to 0, so none can be drawn",
                  "give one of them more than 0");
  }

  /// Shares of more than the whole beside a production that was to have the rest. Numbers above 1
  /// are weights, of which a production without any has one.
  void warn_of_sums(const Productions& productions) {
    std::map<std::pair<bool, std::string_view>, Productions> groups;
    for (const Production* p : productions) {
      groups[{p->is_else, text_of(p->syntax->guard)}].push_back(p);
    }
    for (const auto& [condition, group] : groups) {
      double sum = 0;
      const Production* without = nullptr;
      bool shares = true;
      for (const Production* p : group) {
        const auto probability = probability_of(*p);
        shares = shares && probability && *probability <= 1;
        if (p->probability == none) {
          without = p;
        } else if (shares) {
          sum += *probability;
        }
      }
      if (!shares || !without || sum <= 1 + 1e-9) continue;
      linting_.warn("W018", without->syntax->head,
                    "the other probabilities of " + quoted(name_) + " add up to " + number_of(sum) +
                        ", which leaves nothing for this production; it counts as 1",
                    "give it a probability, too");
    }
  }

  Linting& linting_;
  const Program& program_;
  std::string_view name_;
  std::map<std::string_view, Productions> classes_;
};

}  // namespace

void warn_of_chances(Linting& linting) {
  for (const CompiledStyle& style : linting.program.styles) {
    for (const uint32_t top : style.rules) {
      for (uint32_t set = top; set != none; set = linting.program.rule_sets[set].super) {
        const RuleSet& rules = linting.program.rule_sets[set];
        const Production& first = linting.program.productions[rules.first];
        const bool own = first.from.style == style.linked->syntax;
        if (own && linting.here(first.syntax->head)) Chances(linting, rules).warn();
      }
    }
  }
}

}  // namespace mansard
