// W019: a variable whose value is not what its annotations say it is meant to be.
#include <algorithm>

#include "interpreter/lint/linting.hpp"
#include "interpreter/material.hpp"
#include "styles/annotations.hpp"

namespace mansard {

namespace {

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

/// The variable as one style writes it.
const syntax::Variable* written_by(const Origin& origin, std::string_view name) {
  const syntax::Variable* found = nullptr;
  const auto look = [&](const auto& member) {
    const auto* variable = std::get_if<syntax::Variable>(&member);
    if (variable && variable->name.text == name) found = variable;
  };
  if (origin.block) {
    for (const auto& item : origin.block->items) look(item);
  } else {
    for (const auto& member : origin.style->members) look(member);
  }
  return found;
}

/// A child's variable keeps the annotations of those that it overrides, save what it says anew.
const syntax::Annotation* annotation_of(const VariableBinding& variable, std::string_view name) {
  if (const auto* own = find_annotation(variable.syntax->pre, name)) return own;
  for (const Origin& origin : variable.overrides) {
    const syntax::Variable* const hidden = written_by(origin, variable.name);
    const auto* inherited = hidden ? find_annotation(hidden->pre, name) : nullptr;
    if (inherited) return inherited;
  }
  return nullptr;
}

class Default {
 public:
  Default(Linting& linting, const VariableSlot& slot)
      : linting_(linting), slot_(slot), variable_(*slot.binding) {}

  void check() {
    const ExprNode& node = linting_.program.nodes[slot_.value];
    if (node.kind != ExprKind::constant) return;
    const Value& value = linting_.program.constants[node.first];
    if (const auto* range = annotation_of(variable_, "range")) check_range(*range, value);
    if (const auto* choice = annotation_of(variable_, "choice")) check_choice(*choice, value);
    if (const auto* color = annotation_of(variable_, "color")) check_color(*color, value);
  }

 private:
  void check_range(const syntax::Annotation& annotation, const Value& value) {
    const auto range = range_of(annotation);
    if (!range) return;
    if (value.type != Type::number) {
      return complain(annotation,
                      "is " + std::string(described(value.type)) + ", and a range is of numbers");
    }
    if (value.number >= range->least && value.number <= range->most) return;
    complain(annotation, "lies outside its range");
  }

  void check_choice(const syntax::Annotation& annotation, const Value& value) {
    const bool known = std::ranges::any_of(annotation.args, [&](const syntax::Arg& arg) {
      return arg.value.value && is(value, *arg.value.value);
    });
    if (!known) complain(annotation, "is not among its choices");
  }

  bool is(const Value& value, const syntax::Expr& choice) const {
    if (const auto number = number_literal(choice)) {
      return value.type == Type::number && value.number == *number;
    }
    if (const auto* text = std::get_if<syntax::Text>(&choice.is)) {
      return value.type == Type::string && value.string() == text->value;
    }
    if (const auto* truth = std::get_if<syntax::Boolean>(&choice.is)) {
      return value.type == Type::boolean && value.boolean == truth->value;
    }
    return value.type == Type::symbol && linting_.program.symbols[value.symbol] == choice.at.text();
  }

  void check_color(const syntax::Annotation& annotation, const Value& value) {
    Vec3 color;
    if (value.type == Type::string && parse_color(value.string(), color)) return;
    complain(annotation, "is no colour");
  }

  void complain(const syntax::Annotation& annotation, const std::string& what) {
    linting_.warn("W019",
                  variable_.syntax->value ? variable_.syntax->value->at : variable_.syntax->name.at,
                  "the value of " + quoted(variable_.name) + " " + what,
                  "change the value, or what the annotation says",
                  {{"the annotation is here", annotation.at}});
  }

  Linting& linting_;
  const VariableSlot& slot_;
  const VariableBinding& variable_;
};

}  // namespace

void warn_of_defaults(Linting& linting) {
  for (const VariableSlot& slot : linting.program.variables) {
    const bool told = slot.value == none || slot.from_command_line ||
                      !linting.here(slot.binding->syntax->at) || !slot.binding->syntax->value;
    if (!told) Default(linting, slot).check();
  }
}

}  // namespace mansard
