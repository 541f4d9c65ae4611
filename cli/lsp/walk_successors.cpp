// Words in successors and expressions.
#include <algorithm>

#include "cli/lsp/walk.hpp"

namespace mansard::lsp {

void Walk::body(const syntax::Body& body) {
  for (const syntax::Element& made : body) element(made);
}

void Walk::element(const syntax::Element& element) {
  if (const auto* made = std::get_if<syntax::Emit>(&element.is)) return emit(*made);
  if (const auto* push = std::get_if<syntax::Push>(&element.is)) return body(push->body);
  if (std::holds_alternative<syntax::Super>(element.is)) {
    add(Site::super, {element.at.text(), element.at});
    return;
  }
  for (const syntax::IfArm& arm : std::get<syntax::If>(element.is).arms) {
    expression(arm.condition);
    body(arm.body);
  }
}

void Walk::emit(const syntax::Emit& emit) {
  const Operation* operation = nullptr;
  if (emit.style || emit.style_of) {
    if (emit.style) add(Site::style_use, emit.style);
    if (emit.style_of) {
      add_text(Site::style_use, emit.style_of);
      expression(emit.style_of);
    }
    Word& word = add(Site::symbol_use, emit.name);
    word.of = emit.style.text;
    word.any_style = emit.style_of != nullptr;
  } else {
    operation = find_operation(emit.name.text);
    add(operation ? Site::operation : Site::emit, emit.name);
  }
  arguments(emit, operation);
  expression(emit.index);
  if (emit.parts) parts(emit.parts->parts, operation);
}

void Walk::arguments(const syntax::Emit& emit, const Operation* operation) {
  if (!emit.args) return;
  for (std::size_t place = 0; place < emit.args->size(); ++place)
    argument((*emit.args)[place], operation, place);
}

void Walk::argument(const syntax::Arg& arg, const Operation* operation, std::size_t place) {
  if (operation && arg.name) {
    add(Site::argument, arg.name).of = operation->name;
    for (place = 0; place < operation->count; ++place) {
      if (operation->parameter_name(place) == arg.name.text) break;
    }
  }
  if (operation && place < operation->count) {
    const bool chooses = operation->parameters[place].type == ArgType::edges ||
                         (operation->rule == PartRule::selectors && place == 0);
    if (chooses) add_texts(Site::selector, arg.value.value);
    const std::string_view name = operation->parameter_name(place);
    if (name == "mesh" || name == "file") add_text(Site::file, arg.value.value);
  }
  expression(arg.value.value);
}

void Walk::parts(const std::vector<syntax::Part>& all, const Operation* operation) {
  for (const syntax::Part& part : all) {
    if (part.label) label(*part.label, operation);
    body(part.body);
    parts(part.group, operation);
  }
}

void Walk::label(const syntax::Size& label, const Operation* operation) {
  const auto* word = label.value ? std::get_if<syntax::Reference>(&label.value->is) : nullptr;
  const bool plain =
      word && !word->style && word->names.size() == 1 && label.kind == syntax::SizeKind::absolute;
  if (plain && operation && operation->rule == PartRule::named) {
    add(Site::part, word->names[0]).of = operation->name;
  } else if (plain && operation && operation->rule == PartRule::selectors) {
    add(Site::selector, word->names[0]);
  } else {
    expression(label.value);
  }
}

// ---- expressions

void Walk::expression(const syntax::ExprPtr& expr) {
  if (!expr) return;
  std::visit([&](const auto& made) { is(*expr, made); }, expr->is);
}

void Walk::is(const syntax::Expr&, const syntax::Reference& reference) {
  if (reference.style) {
    add(Site::style_use, reference.style);
    add(Site::symbol_use, reference.names.back()).of = reference.style.text;
  } else if (reference.names.size() == 2) {
    add(Site::block_use, reference.names[0]).of = reference.names[1].text;
    add(Site::member_use, reference.names[1]).of = reference.names[0].text;
  } else if (reference.names.size() == 1) {
    add(Site::value, reference.names[0]);
  }
}

namespace {

/// A text that is the name of a symbol: group.any(…, "ROW"), made("WINDOW").
bool names_symbol(const syntax::Reference& callee, std::size_t argument) {
  const std::string_view name = callee.names.back().text;
  if (callee.names.size() == 1) return name == "made" && argument == 0;
  return callee.names[0].text == "group" && argument == 1;
}

}  // namespace

void Walk::is(const syntax::Expr&, const syntax::Call& call) {
  const syntax::Reference& callee = call.callee;
  if (callee.names.size() == 2) add(Site::block_use, callee.names[0]);
  if (callee.names.size() <= 2 && !callee.style)
    add(Site::call, callee.names.back()).of =
        callee.names.size() == 2 ? callee.names[0].text : std::string_view{};
  for (std::size_t i = 0; i < call.args.size(); ++i) {
    if (names_symbol(callee, i)) add_text(Site::symbol_use, call.args[i].value.value);
    expression(call.args[i].value.value);
  }
}

void Walk::is(const syntax::Expr&, const syntax::List& list) {
  for (const syntax::ExprPtr& item : list.items) expression(item);
}

void Walk::is(const syntax::Expr&, const syntax::Subscript& subscript) {
  expression(subscript.list);
  expression(subscript.index);
}

void Walk::is(const syntax::Expr&, const syntax::Unary& unary) { expression(unary.operand); }

void Walk::is(const syntax::Expr&, const syntax::Chain& chain) {
  for (const syntax::ExprPtr& operand : chain.operands) expression(operand);
}

void Walk::is(const syntax::Expr&, const syntax::Conditional& conditional) {
  expression(conditional.condition);
  expression(conditional.then);
  expression(conditional.otherwise);
}

}  // namespace mansard::lsp
