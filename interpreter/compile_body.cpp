// Successors.
#include <algorithm>

#include "interpreter/compiler.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/random.hpp"
#include "interpreter/roof_words.hpp"
#include "interpreter/words_elsewhere.hpp"

namespace mansard {

BodyId Compiler::body(const syntax::Body& source, NameScope& scope) {
  std::vector<Step> steps;
  for (const syntax::Element& e : source) {
    attempt(scope.style, scope.block, [&] { element(e, scope, steps); });
  }
  Body body;
  body.first = static_cast<uint32_t>(program_.steps.size());
  body.count = static_cast<uint32_t>(steps.size());
  program_.steps.insert(program_.steps.end(), steps.begin(), steps.end());
  program_.bodies.push_back(body);
  return static_cast<BodyId>(program_.bodies.size() - 1);
}

void Compiler::element(const syntax::Element& e, NameScope& scope, std::vector<Step>& steps) {
  if (const auto* symbol = std::get_if<syntax::Emit>(&e.is))
    return emit(*symbol, e.at, scope, steps);
  if (const auto* chain = std::get_if<syntax::If>(&e.is)) return branch(*chain, e.at, scope, steps);
  Step step;
  step.at = e.at;
  if (const auto* push = std::get_if<syntax::Push>(&e.is)) {
    step.kind = StepKind::push;
    step.what = body(push->body, scope);
  } else {
    step.kind = StepKind::super;
  }
  steps.push_back(step);
}

void Compiler::branch(const syntax::If& chain, Span at, NameScope& scope,
                      std::vector<Step>& steps) {
  Branch branch;
  for (const syntax::IfArm& arm : chain.arms) {
    BranchArm out;
    if (arm.condition) out.condition = expression(*arm.condition, scope);
    out.body = body(arm.body, scope);
    branch.arms.push_back(out);
  }
  Step step;
  step.kind = StepKind::branch;
  step.at = at;
  step.what = static_cast<uint32_t>(program_.branches.size());
  program_.branches.push_back(std::move(branch));
  steps.push_back(step);
}

void Compiler::emit(const syntax::Emit& e, Span at, NameScope& scope, std::vector<Step>& steps) {
  if (e.style || e.style_of) return emit_elsewhere(e, at, scope, steps);
  if (const Operation* operation = find_operation(e.name.text)) {
    if (!e.args && !e.parts) {
      if (std::ranges::find(scope.parameters, e.name.text) != scope.parameters.end()) {
        refuse(e.name.at,
               "parameter '" + std::string(e.name.text) +
                   "' bears the name of an operation, so it can not stand as a symbol",
               "give it another name");
      }
      refuse(e.name.at,
             "'" + std::string(e.name.text) + "' is an operation and needs its arguments",
             "write " + std::string(e.name.text) + "(" + operation->names_by_place() + ")");
    }
    Step step;
    step.kind = StepKind::operation;
    step.at = at;
    step.what = operation_call(*operation, e, at, scope);
    steps.push_back(step);
    return;
  }
  if (e.parts || (e.args && is_later_operation(e.name.text))) not_an_operation(e, scope.style);
  emit_symbol(e, at, scope, steps);
}

void Compiler::not_an_operation(const syntax::Emit& e, uint16_t style) {
  const auto name = std::string(e.name.text);
  if (is_later_operation(e.name.text))
    refuse(e.name.at, "'" + name + "' comes with a later version of Mansard");
  std::vector<std::string_view> known;
  for (const Operation& o : operations()) known.push_back(o.name);
  if (e.args) {  // or a symbol with parameters was meant
    for (const SymbolRules& rules : program_.styles[style].linked->symbols) {
      if (!rules.generations[0].productions[0]->params.empty()) known.push_back(rules.name);
    }
  }
  std::string help = meant(e.name.text, known);
  if (name.starts_with("roof") && meant_roof_kind(name))  // CityEngine's roofHip(35)
    help = "write roof(\"" + std::string(*meant_roof_kind(name)) + "\", pitch)";
  if (const std::string_view here = operation_elsewhere(e.name.text); !here.empty())
    help = "write " + std::string(here);
  if (find_function(name))
    help = "it is a function: it gives a value to a condition or an argument";
  if (help.empty() && known_symbols_.contains(e.name.text) && !e.args)
    help = "only an operation takes { ... }; put the parts into a rule of '" + name + "'";
  refuse(e.name.at, "unknown operation '" + name + "'", help);
}

void Compiler::arguments(const syntax::Emit& e, NameScope& scope, Step& step) {
  if (!e.args) return;
  std::vector<ExprId> ids;
  scope.symbols = true;
  for (const syntax::Arg& arg : *e.args) ids.push_back(plain_argument(arg, scope));
  scope.symbols = false;
  step.arguments = static_cast<uint32_t>(program_.arguments.size());
  step.argument_count = static_cast<uint32_t>(ids.size());
  program_.arguments.insert(program_.arguments.end(), ids.begin(), ids.end());
}

void Compiler::emit_symbol(const syntax::Emit& e, Span at, NameScope& scope,
                           std::vector<Step>& steps) {
  Step step;
  step.at = at;
  const LinkedStyle& linked = *program_.styles[scope.style].linked;
  const SymbolRules* const rules = linked.find_symbol(e.name.text);
  const bool is_parameter =
      std::ranges::find(scope.parameters, e.name.text) != scope.parameters.end();
  const bool is_variable =
      !rules && (variable_slot(scope.style, scope.block, e.name.text) != none ||
                 variable_slot(scope.style, {}, e.name.text) != none);
  if ((is_parameter || is_variable) && !e.args) {
    step.kind = StepKind::emit_value;
    step.what = plain_name(e.name, scope);
  } else {
    const std::size_t given = e.args ? e.args->size() : 0;
    const auto asked = linked.asked.find(e.name.text);  // by an abstract style, of its heirs
    const bool is_asked = !rules && asked != linked.asked.end();
    const std::size_t expected = rules      ? rules->generations[0].productions[0]->params.size()
                                 : is_asked ? asked->second->params.size()
                                            : 0;
    if (is_parameter) {
      refuse(e.args_at,
             "parameter '" + std::string(e.name.text) +
                 "' stands as a symbol here, and takes no arguments",
             "give them where the symbol is handed over, in a rule of its own");
    }
    if (!rules && !is_asked && e.args) not_an_operation(e, scope.style);
    if ((rules || is_asked) && given != expected) {
      refuse(e.args ? e.args_at : e.name.at,
             "'" + std::string(e.name.text) + "' takes " + count_text(expected, "argument") +
                 ", not " + std::to_string(given),
             {},
             {rules ? Note{"its rule is here", rules->generations[0].productions[0]->head}
                    : Note{"it is asked for here", asked->second->name.at}});
    }
    step.what = program_.symbols.intern(e.name.text);
    arguments(e, scope, step);
  }
  if (e.index) step.index = expression(*e.index, scope);
  steps.push_back(step);
}

void Compiler::emit_elsewhere(const syntax::Emit& e, Span at, NameScope& scope,
                              std::vector<Step>& steps) {
  Step step;
  step.at = at;
  if (e.parts) refuse(e.parts->at, "only an operation takes { ... }");
  if (e.style) {
    const auto style = style_number(e.style.text);
    if (!style) refuse_style(e.style);
    step.style = *style;
    const auto* target = program_.styles[*style].linked->find_symbol(e.name.text);
    const std::size_t given = e.args ? e.args->size() : 0;
    const std::size_t expected = target ? target->generations[0].productions[0]->params.size() : 0;
    if (given != expected) {
      refuse(e.name.at, "'" + std::string(e.name.text) + "' of style '" +
                            std::string(e.style.text) + "' takes " +
                            count_text(expected, "argument") + ", not " + std::to_string(given));
    }
  } else {
    reach_all();
    step.style_of = expression(*e.style_of, scope);
  }
  step.what = program_.symbols.intern(e.name.text);
  arguments(e, scope, step);
  if (e.index) step.index = expression(*e.index, scope);
  steps.push_back(step);
}

/// The hash of the first symbol in text order; that of no name when there is none.
uint64_t Compiler::first_symbol(BodyId id) const {
  constexpr uint64_t no_symbol = hash_of("");
  const Body body = program_.bodies[id];
  for (uint32_t i = body.first; i < body.first + body.count; ++i) {
    const Step& step = program_.steps[i];
    if (step.kind == StepKind::emit) return hash_of(program_.symbols[step.what]);
    uint64_t found = no_symbol;
    if (step.kind == StepKind::push) found = first_symbol(step.what);
    if (step.kind == StepKind::operation) {
      for (const CallPart& part : program_.calls[step.what].parts) {
        if (part.group.empty() && found == no_symbol) found = first_symbol(part.body);
      }
    }
    if (found != no_symbol) return found;
  }
  return no_symbol;
}

/// The first split in text order, whatever it stands in; none when there is none.
uint32_t Compiler::first_split(BodyId id) const {
  const Body body = program_.bodies[id];
  for (uint32_t i = body.first; i < body.first + body.count; ++i) {
    const Step& step = program_.steps[i];
    if (step.kind == StepKind::push) {
      if (const uint32_t found = first_split(step.what); found != none) return found;
    }
    if (step.kind != StepKind::operation) continue;
    const Call& call = program_.calls[step.what];
    const std::string_view name = call.operation->name;
    if (name == "subdiv" || name == "repeat" || name == "split") return step.what;
    for (const CallPart& part : call.parts) {
      if (!part.group.empty()) continue;
      if (const uint32_t found = first_split(part.body); found != none) return found;
    }
  }
  return none;
}

}  // namespace mansard
