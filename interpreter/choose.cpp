// Which production rewrites a shape.
#include <array>

#include "interpreter/indices.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/messages.hpp"

namespace mansard {

void Machine::bind_index(const Production& chosen, const RuleSet& rules, const Shape& shape,
                         Env& env) {
  if (chosen.index_parameter == 0xff) return;
  Value* const bound = values_.take(rules.parameters + 1u);
  std::copy_n(env.parameters, rules.parameters, bound);
  bound[rules.parameters] = Value::of(shape.index);
  env.parameters = bound;
}

/// All productions whose condition holds are candidates, indexed ones before the others; `else`
/// only where none before it was, unless those before it are the same `else`. One is drawn by the
/// normalised probabilities.
const Production* Machine::choose(const RuleSet& rules, const Shape& shape, Env& env) {
  const Production* const all = program.productions.data() + rules.first;
  if (rules.always) return all;
  std::array<std::pair<const Production*, double>, most_productions> candidates;
  const Env outer = env;
  without_chance_ = 0;
  for (const bool indexed : {true, false}) {
    if (indexed && !rules.tests_index) continue;
    std::size_t found = 0;
    double total = 0;
    bool closed = false;  // to the `else` at hand and those that join it
    for (uint32_t i = 0; i < rules.count; ++i) {
      const Production& p = all[i];
      if ((p.index_test != none) != indexed) continue;
      if (p.is_else && !p.joins_else) closed = found > 0;
      if (p.is_else && closed) continue;
      Env inner = outer;
      inner.draws = mix(outer.draws, hash_of("guard") + i);
      production = &p;
      bind_index(p, rules, shape, inner);
      if (p.index_test != none && number(p.index_test, inner) != shape.index) continue;
      if (p.guard != none && !condition(p.guard, inner)) continue;
      const double weight = p.probability == none ? 1 : number(p.probability, inner);
      if (weight < 0) fail(program.spans[p.probability], "a probability can not be negative");
      candidates[found++] = {&p, weight};
      total += weight;
    }
    if (total <= 0) {
      without_chance_ += found;
      continue;
    }
    if (found == 1) return candidates[0].first;
    reads |= read_bits::chance;
    double draw = unit_interval(mix(outer.draws, hash_of("production"))) * total;
    for (std::size_t i = 0; i + 1 < found; ++i) {
      if (draw < candidates[i].second) return candidates[i].first;
      draw -= candidates[i].second;
    }
    return candidates[found - 1].first;
  }
  return nullptr;
}

Diagnostic Machine::why_no_candidate(const RuleSet& rules, const Shape& shape) const {
  Diagnostic d;
  d.at = program.productions[rules.first].syntax->head;
  const std::string name = "'" + std::string(program.symbols[shape.symbol]) + "'";
  if (without_chance_ > 0) {
    d.code = "W018";
    d.text = "the probabilities of the productions of " + name + " that fit a shape of " +
             size_text(shape.scope.size) + " add up to 0";
    d.help = "a probability of 0 is never drawn: give one of them more";
    return d;
  }
  if (!takes_index(program, rules, shape.index)) {
    const Span head = d.at;
    d = untaken_index(program, rules, shape.index);
    d.code = "W010";
    d.at = head;
    return d;
  }
  d.code = "W010";
  d.text = "no production of " + name + " fits a shape of " + size_text(shape.scope.size);
  d.help = "add a production with ': else'";
  for (uint32_t i = 0; i < rules.count; ++i) {
    const Production& p = program.productions[rules.first + i];
    const bool open = tested_index(program, p).value_or(shape.index) == shape.index;
    if (p.syntax->guard && (open || p.index_test == none))
      d.notes.push_back({"this condition was tried and is false", p.syntax->guard->at});
  }
  return d;
}

void Machine::no_candidate(const RuleSet& rules, const Shape& shape) {
  ++building->unmatched;
  Diagnostic d = why_no_candidate(rules, shape);
  if (options.strict) {
    d.code = {};
    production = nullptr;  // none was taken
    throw Failure(std::move(d));
  }
  d.severity = Severity::warning;
  warn(std::move(d));
}

}  // namespace mansard
