#include "interpreter/lint/reads.hpp"

#include "interpreter/lint/walk.hpp"

namespace mansard {

namespace {

template <class Set, class Binding>
void add_writers(Set& set, const Binding& binding, const std::string& name) {
  set.emplace(binding.from.style, name);
  for (const Origin& hidden : binding.overrides) set.emplace(hidden.style, name);
}

}  // namespace

Reads::Reads(const Program& program)
    : program_(program),
      read_(program.variables.size(), false),
      called_(program.functions.size(), false) {
  for (const CompiledStyle& style : program.styles) {
    for (const uint32_t top : style.rules) walk_rules(program, top, *this);
  }
  for (reader_ = 0; reader_ < program.variables.size(); ++reader_) {
    const ExprId value = program.variables[reader_].value;
    if (value != none) expression(value);
  }
  reader_ = none;
  for (caller_ = 0; caller_ < program.functions.size(); ++caller_) {
    const ExprId value = program.functions[caller_].value;
    if (value != none) expression(value);
  }
  caller_ = none;
  for (std::size_t slot = 0; slot < read_.size(); ++slot) {
    const VariableSlot& v = program.variables[slot];
    if (read_[slot]) add_writers(variables_, *v.binding, v.name);
  }
  for (std::size_t slot = 0; slot < called_.size(); ++slot) {
    const FunctionSlot& f = program.functions[slot];
    if (called_[slot]) add_writers(functions_, *f.binding, f.name);
  }
}

void Reads::expression(ExprId expr) {
  walk_nodes(program_, expr, [this](const ExprNode& node) {
    if (node.kind == ExprKind::variable && node.first != reader_) read_[node.first] = true;
    if (node.kind == ExprKind::definition && node.first != caller_) called_[node.first] = true;
  });
}

}  // namespace mansard
