#include "interpreter/lint/reach.hpp"

#include "interpreter/lint/walk.hpp"

namespace mansard {

namespace {

uint16_t style_count(const Program& program) {
  return static_cast<uint16_t>(program.styles.size());
}

}  // namespace

Reach::Reach(const Program& program)
    : program_(program),
      reached_(program.styles.size(), std::vector<bool>(program.symbols.size(), false)),
      live_(program.styles.size(), false),
      variables_(program.variables.size(), false),
      functions_(program.functions.size(), false) {
  for (uint16_t style = 0; style < style_count(program); ++style) {
    const CompiledStyle& compiled = program.styles[style];
    const bool derivable =
        compiled.linked->missing.empty() && compiled.rules[compiled.start] != none;
    if (derivable) push(style, compiled.start);
  }
  run();
}

void Reach::go_on_from(uint16_t style, uint32_t symbol) {
  push(style, symbol);
  run();
}

void Reach::push(uint16_t style, uint32_t symbol) {
  if (reached_[style][symbol]) return;
  reached_[style][symbol] = true;
  live_[style] = true;
  pending_.emplace_back(style, symbol);
}

void Reach::run() {
  while (!pending_.empty()) {
    const auto [style, symbol] = pending_.back();
    pending_.pop_back();
    expand(style, symbol);
  }
}

void Reach::expand(uint16_t style, uint32_t symbol) {
  style_ = style;
  walk_rules(program_, program_.styles[style].rules[symbol], *this);
}

void Reach::step(const Step& step) {
  if (step.kind != StepKind::emit) return;
  if (step.style_of == none) return push(step.style == 0xffff ? style_ : step.style, step.what);
  for (uint16_t style = 0; style < style_count(program_); ++style) {
    if (program_.styles[style].rules[step.what] != none) push(style, step.what);
  }
}

/// A symbol that stands anywhere as a value may be emitted.
void Reach::expression(ExprId expr) {
  walk_nodes(program_, expr, [this](const ExprNode& node) {
    if (node.kind == ExprKind::constant) constant(program_.constants[node.first]);
    if (node.kind == ExprKind::variable) variable(node.first);
    if (node.kind == ExprKind::definition && !functions_[node.first]) {
      functions_[node.first] = true;
      const ExprId value = program_.functions[node.first].value;
      if (value != none) expression(value);
    }
    if (node.kind != ExprKind::property) return;
    const ExprNode& fallback = program_.nodes[program_.children[node.children]];
    const bool any_symbol = fallback.kind == ExprKind::constant &&
                            program_.constants[fallback.first].type == Type::symbol;
    if (!any_symbol) return;  // a footprint can name any symbol there
    for (uint32_t symbol = 0; symbol < program_.symbols.size(); ++symbol) push(style_, symbol);
  });
}

void Reach::constant(const Value& value) {
  if (value.type == Type::symbol) {
    push(value.size > 0 ? static_cast<uint16_t>(value.size - 1) : style_, value.symbol);
  }
  if (value.type != Type::list) return;
  for (const Value& item : value.list()) constant(item);
}

/// Symbols among the `@choice` of a variable are meant to be given to it.
void Reach::variable(uint32_t slot) {
  if (variables_[slot]) return;
  variables_[slot] = true;
  const VariableSlot& v = program_.variables[slot];
  if (v.value != none) expression(v.value);
  for (const syntax::Annotation& annotation : v.binding->syntax->pre.annotations) {
    if (annotation.name.text != "choice") continue;
    for (const syntax::Arg& arg : annotation.args) {
      if (!arg.value.value) continue;
      const auto symbol = program_.symbols.find(arg.value.value->at.text());
      if (symbol) push(style_, *symbol);
    }
  }
}

namespace {

/// Marks what one production emits, save its own symbol.
struct Emissions {
  const Program& program;
  std::vector<std::vector<bool>>& found;
  uint16_t style;
  uint32_t own;

  void mark(uint16_t where, uint32_t symbol) {
    if (where != style || symbol != own) found[where][symbol] = true;
  }
  void step(const Step& step) {
    if (step.kind == StepKind::emit && step.style_of == none) {
      mark(step.style == 0xffff ? style : step.style, step.what);
    }
  }
  void expression(ExprId expr) {
    walk_nodes(program, expr, [this](const ExprNode& node) {
      if (node.kind != ExprKind::constant) return;
      const Value& value = program.constants[node.first];
      if (value.type != Type::symbol) return;
      mark(value.size > 0 ? static_cast<uint16_t>(value.size - 1) : style, value.symbol);
    });
  }
};

}  // namespace

std::vector<std::vector<bool>> emitted_by_others(const Program& program) {
  std::vector<std::vector<bool>> found(program.styles.size(),
                                       std::vector<bool>(program.symbols.size(), false));
  for (uint16_t style = 0; style < style_count(program); ++style) {
    for (uint32_t symbol = 0; symbol < program.symbols.size(); ++symbol) {
      Emissions emissions{program, found, style, symbol};
      uint32_t set = program.styles[style].rules[symbol];
      for (; set != none; set = program.rule_sets[set].super) {
        const RuleSet& rules = program.rule_sets[set];
        for (uint32_t i = 0; i < rules.count; ++i) {
          walk_production(program, program.productions[rules.first + i], emissions);
        }
      }
    }
  }
  return found;
}

}  // namespace mansard
