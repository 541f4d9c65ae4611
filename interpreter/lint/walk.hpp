// Everything that a successor holds. Private to the warnings of `check`.
#pragma once

#include "interpreter/program.hpp"

namespace mansard {

/// Calls visit.step(const Step&) and visit.expression(ExprId) for all steps and expressions of a
/// body, in text order, those of nested parts and branches too.
template <class Visit>
class Walk {
 public:
  Walk(const Program& program, Visit& visit) : program_(program), visit_(visit) {}

  void body(BodyId id) {
    const Body body = program_.bodies[id];
    for (uint32_t i = body.first; i < body.first + body.count; ++i) step(program_.steps[i]);
  }
  void expression(ExprId id) {
    if (id != none) visit_.expression(id);
  }
  bool says_super() const { return says_super_; }

 private:
  void step(const Step& step) {
    visit_.step(step);
    says_super_ = says_super_ || step.kind == StepKind::super;
    expression(step.index);
    expression(step.style_of);
    for (uint32_t i = 0; i < step.argument_count; ++i) {
      expression(program_.arguments[step.arguments + i]);
    }
    if (step.kind == StepKind::emit_value) expression(step.what);
    if (step.kind == StepKind::push) body(step.what);
    if (step.kind == StepKind::operation) {
      const Call& call = program_.calls[step.what];
      for (const SizeExpr& arg : call.args) expression(arg.value);
      parts(call.parts);
    }
    if (step.kind == StepKind::branch) {
      for (const BranchArm& arm : program_.branches[step.what].arms) {
        expression(arm.condition);
        body(arm.body);
      }
    }
  }
  void parts(const std::vector<CallPart>& list) {
    for (const CallPart& part : list) {
      expression(part.size.value);
      if (part.group.empty()) body(part.body);
      parts(part.group);
    }
  }

  const Program& program_;
  Visit& visit_;
  bool says_super_ = false;
};

/// Whether it says `super`.
template <class Visit>
bool walk_production(const Program& program, const Production& production, Visit& visit) {
  Walk<Visit> walk(program, visit);
  walk.expression(production.guard);
  walk.expression(production.index_test);
  walk.expression(production.probability);
  walk.body(production.body);
  return walk.says_super();
}

/// The productions of a rule set, and of those that `super` leads to.
template <class Visit>
void walk_rules(const Program& program, uint32_t set, Visit& visit) {
  while (set != none) {
    const RuleSet& rules = program.rule_sets[set];
    bool goes_on = false;
    for (uint32_t i = rules.first; i < rules.first + rules.count; ++i) {
      if (walk_production(program, program.productions[i], visit)) goes_on = true;
    }
    set = goes_on ? rules.super : none;
  }
}

/// Calls visit(node) for an expression and all below it.
template <class Visit>
void walk_nodes(const Program& program, ExprId id, const Visit& visit) {
  const ExprNode& node = program.nodes[id];
  visit(node);
  for (uint32_t i = 0; i < node.count; ++i) {
    walk_nodes(program, program.children[node.children + i], visit);
  }
}

}  // namespace mansard
