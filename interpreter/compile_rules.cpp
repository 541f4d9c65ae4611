// The productions of symbols.
#include <algorithm>

#include "interpreter/compiler.hpp"

namespace mansard {
namespace {

/// The same words after `else`: one of them is drawn, as of productions with one condition.
bool same_else(const syntax::Rule& a, const syntax::Rule& b) {
  const auto text = [](const syntax::ExprPtr& expr) {
    return expr ? expr->at.text() : std::string_view();
  };
  return a.guard_else && b.guard_else && text(a.guard) == text(b.guard) &&
         text(a.index) == text(b.index);
}

}  // namespace

/// A bare name of an operation is never a symbol, so nothing could emit it.
void Compiler::check_rule_name(uint16_t style, const SymbolRules& symbol) {
  if (!find_operation(symbol.name)) return;
  const Generation& base = symbol.generations.back();
  const Span name = base.productions.front()->name.at;
  const auto is_told = [&](const Diagnostic& d) { return d.at == name && d.code.empty(); };
  if (std::ranges::any_of(diagnostics_.all(), is_told)) return;
  attempt(style, base.from.block ? base.from.block->name.text : "", [&] {
    refuse(name,
           "'" + std::string(symbol.name) + "' is an operation and can not be the name of a rule",
           "choose another name");
  });
}

void Compiler::check_function_name(uint16_t style, const FunctionBinding& binding) {
  if (!find_function(binding.name) && binding.name != "attr") return;
  attempt(style, binding.block, [&] {
    refuse(binding.syntax->name.at,
           "'" + std::string(binding.name) + "' is a function of the language",
           "choose another name");
  });
}

void Compiler::compile_rules(uint16_t number) {
  // Indices, not references: compiling a rule may reach another style and grow the tables.
  std::vector<uint32_t> sets;
  for (const uint32_t top : program_.styles[number].rules) {
    for (uint32_t s = top; s != none; s = program_.rule_sets[s].super) sets.push_back(s);
  }
  for (const uint32_t s : sets) {
    const RuleSet set = program_.rule_sets[s];
    bool tests = false;
    const syntax::Rule* before[2] = {nullptr, nullptr};  // without an index in the head, and with
    for (uint32_t i = 0; i < set.count; ++i) {
      Production production = program_.productions[set.first + i];
      const std::string_view block = production.from.block ? production.from.block->name.text : "";
      attempt(number, block, [&] {
        if (i == most_productions) {
          refuse(production.syntax->head,
                 "a symbol has " + std::to_string(most_productions) + " productions at most");
        }
        compile_production(production, number);
      });
      const syntax::Rule*& last = before[production.index_test == none ? 0 : 1];
      production.joins_else = last && same_else(*last, *production.syntax);
      last = production.syntax;
      tests = tests || production.index_test != none;
      program_.productions[set.first + i] = production;
    }
    const Production& only = program_.productions[set.first];
    program_.rule_sets[s].tests_index = tests;
    program_.rule_sets[s].always = set.count == 1 && only.guard == none && !tests;
  }
}

void Compiler::compile_production(Production& p, uint16_t style) {
  const syntax::Rule& rule = *p.syntax;
  p.stage = stage_of(rule);
  uint16_t salt = 1;
  NameScope scope;
  scope.style = style;
  scope.block = p.from.block ? p.from.block->name.text : std::string_view{};
  scope.salt = &salt;
  for (const syntax::Name& name : rule.params) scope.parameters.push_back(name.text);
  if (rule.index) {
    const auto* name = std::get_if<syntax::Reference>(&rule.index->is);
    if (name && name->names.size() == 1 && !name->style) {
      p.index_parameter = static_cast<uint8_t>(scope.parameters.size());
      scope.parameters.push_back(name->names[0].text);
    } else {
      p.index_test = expression(*rule.index, scope);
    }
  }
  p.is_else = rule.guard_else;
  const std::size_t failures = failures_;
  p.body = body(rule.successor, scope);
  if (rule.guard) {
    scope.in_guard = true;
    scope.body_failed = failures_ > failures;
    scope.fits_call = first_split(p.body);
    p.guard = expression(*rule.guard, scope);
    scope.in_guard = false;
    p.asks_fits = scope.asked_fits;
  }
  if (rule.probability) p.probability = expression(*rule.probability, scope);
}

void Compiler::warn_unguarded(uint16_t number) {
  const CompiledStyle& style = program_.styles[number];
  for (const uint32_t top : style.rules) {
    if (top == none) continue;
    const RuleSet& set = program_.rule_sets[top];
    const auto* first = &program_.productions[set.first];
    const bool open = std::all_of(first, first + set.count, [](const Production& p) {
      return p.guard != none && !(p.is_else && !p.syntax->guard);
    });
    if (!open || !is_checked(first[set.count - 1].syntax->head)) continue;
    Diagnostic d;
    d.severity = Severity::warning;
    d.code = "W002";
    d.at = first[set.count - 1].syntax->head;
    d.text = "'" + std::string(first->syntax->name.text) +
             "' has only productions with conditions: where none holds the shape stays as it is";
    d.help = "add a production with ': else'";
    diagnostics_.add(std::move(d));
  }
}

}  // namespace mansard
