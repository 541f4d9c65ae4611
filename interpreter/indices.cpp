#include "interpreter/indices.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "interpreter/messages.hpp"

namespace mansard {
namespace {

std::span<const Production> productions_of(const Program& program, const RuleSet& rules) {
  return std::span(program.productions).subspan(rules.first, rules.count);
}

/// "1, 2 and 5", at most eight of them.
std::string listed(const std::set<double>& numbers) {
  constexpr std::size_t most = 8;
  std::string text;
  std::size_t i = 0;
  for (const double number : numbers) {
    if (++i > most) return text + " and others";
    text += (i == 1 ? "" : i == numbers.size() ? " and " : ", ") + number_text(number);
  }
  return text;
}

}  // namespace

std::optional<double> tested_index(const Program& program, const Production& production) {
  if (production.index_test == none) return std::nullopt;
  return program.constants[program.nodes[production.index_test].first].number;
}

bool takes_index(const Program& program, const RuleSet& rules, double index) {
  return std::ranges::any_of(productions_of(program, rules), [&](const Production& p) {
    return tested_index(program, p).value_or(index) == index || p.index_test == none;
  });
}

Diagnostic untaken_index(const Program& program, const RuleSet& rules, double index) {
  const std::span<const Production> productions = productions_of(program, rules);
  const auto name = std::string(productions[0].syntax->name.text);
  std::set<double> tested;
  const Production* nearest = &productions[0];
  const auto away = [&](const Production& p) {
    return std::abs(tested_index(program, p).value_or(index) - index);
  };
  for (const Production& p : productions) {
    if (const auto number = tested_index(program, p)) tested.insert(*number);
    if (away(p) < away(*nearest)) nearest = &p;
  }
  Diagnostic d;
  const std::string heads =
      (tested.size() == 1 ? "its rules take only " : "its rules take ") + listed(tested);
  if (std::isnan(index)) {
    d.text = "no production of '" + name + "' takes a shape without an index: " + heads;
    d.help = "set it where it is emitted, " + name + "[" + number_text(*tested.begin()) +
             "], or add a production for any: " + name + " -> ...";
    return d;
  }
  d.text = "no production of '" + name + "' takes index " + number_text(index) + ": " + heads;
  d.notes.push_back({"the nearest takes " + number_text(*tested_index(program, *nearest)),
                     nearest->syntax->head});
  if (rules.super != none && takes_index(program, program.rule_sets[rules.super], index)) {
    const Production& inherited = program.productions[program.rule_sets[rules.super].first];
    d.help = "those of style '" + std::string(inherited.from.style->name.text) +
             "', which these replace, have one: add " + name + " -> super";
    return d;
  }
  d.help = "add " + name + "[" + number_text(index) +
           "] -> ..., or a production for any other: " + name + " -> ...";
  return d;
}

}  // namespace mansard
