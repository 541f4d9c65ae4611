#include <algorithm>

#include "interpreter/attribute_table.hpp"
#include "interpreter/compiler.hpp"
#include "interpreter/messages.hpp"

namespace mansard {
namespace {

ExprKind kind_of(syntax::Infix op) {
  using enum syntax::Infix;
  switch (op) {
    case add:
      return ExprKind::add;
    case subtract:
      return ExprKind::subtract;
    case multiply:
      return ExprKind::multiply;
    case divide:
      return ExprKind::divide;
    case less:
      return ExprKind::less;
    case less_equal:
      return ExprKind::less_equal;
    case greater:
      return ExprKind::greater;
    case greater_equal:
      return ExprKind::greater_equal;
    case equal:
      return ExprKind::equal;
    case unequal:
      return ExprKind::unequal;
    case and_:
      return ExprKind::and_;
    case or_:
      return ExprKind::or_;
  }
  return ExprKind::add;
}

}  // namespace

ExprId Compiler::node(ExprKind kind, Span at, std::vector<ExprId> children, uint32_t first,
                      uint8_t aux) {
  ExprNode n;
  n.kind = kind;
  n.aux = aux;
  n.first = first;
  n.children = static_cast<uint32_t>(program_.children.size());
  n.count = static_cast<uint32_t>(children.size());
  program_.children.insert(program_.children.end(), children.begin(), children.end());
  std::size_t depth = 1;
  for (const ExprId child : children)
    depth = std::max<std::size_t>(depth, program_.depths[child] + 1u);
  if (depth > 1000) refuse(at, "an expression more than 1000 deep", "divide it up with variables");
  program_.depths.push_back(static_cast<uint16_t>(depth));
  program_.nodes.push_back(n);
  program_.spans.push_back(at);
  return static_cast<ExprId>(program_.nodes.size() - 1);
}

ExprId Compiler::constant(Value value, Span at) {
  const auto number = static_cast<uint32_t>(program_.constants.size());
  const ExprId id = node(ExprKind::constant, at, {}, number);
  program_.constants.push_back(value.from(id));
  return id;
}

ExprId Compiler::expression(const syntax::Expr& expr, NameScope& scope) {
  struct Visitor {
    Compiler& self;
    const syntax::Expr& expr;
    NameScope& scope;

    ExprId operator()(const syntax::Number& n) {
      return self.constant(Value::of(n.value), expr.at);
    }
    ExprId operator()(const syntax::Text& t) {
      return self.constant(Value::of(std::string_view(self.program_.texts.emplace_back(t.value))),
                           expr.at);
    }
    ExprId operator()(const syntax::Boolean& b) {
      return self.constant(Value::of(b.value), expr.at);
    }
    ExprId operator()(const syntax::List& list) {
      std::vector<ExprId> items;
      for (const auto& item : list.items) items.push_back(self.expression(*item, scope));
      return self.node(ExprKind::list, expr.at, std::move(items));
    }
    ExprId operator()(const syntax::Reference& r) { return self.reference(r, expr.at, scope); }
    ExprId operator()(const syntax::Call& c) { return self.call(c, expr.at, scope); }
    ExprId operator()(const syntax::Subscript& s) {
      const ExprId list = self.expression(*s.list, scope), index = self.expression(*s.index, scope);
      return self.node(ExprKind::subscript, expr.at, {list, index});
    }
    ExprId operator()(const syntax::Unary& u) {
      ExprId id = self.expression(*u.operand, scope);
      for (auto op = u.operators.rbegin(); op != u.operators.rend(); ++op) {
        id = self.node(*op == syntax::Prefix::minus ? ExprKind::negate : ExprKind::invert, expr.at,
                       {id});
      }
      return id;
    }
    ExprId operator()(const syntax::Chain& c) { return self.chain(c, expr.at, scope); }
    ExprId operator()(const syntax::Conditional& c) {
      const ExprId condition = self.expression(*c.condition, scope);
      const ExprId then = self.expression(*c.then, scope),
                   otherwise = self.expression(*c.otherwise, scope);
      return self.node(ExprKind::conditional, expr.at, {condition, then, otherwise});
    }
  };
  return std::visit(Visitor{*this, expr, scope}, expr.is);
}

ExprId Compiler::chain(const syntax::Chain& chain, Span, NameScope& scope) {
  ExprId left = expression(*chain.operands[0], scope);
  for (std::size_t i = 0; i < chain.operators.size(); ++i) {
    const ExprId right = expression(*chain.operands[i + 1], scope);
    const Span whole = join(chain.operands[0]->at, chain.operands[i + 1]->at);
    left = node(kind_of(chain.operators[i]), whole, {left, right});
  }
  return left;
}

uint32_t Compiler::variable_slot(uint16_t style, std::string_view block,
                                 std::string_view name) const {
  const auto it = variable_slots_.find({style, qualified(block, name)});
  return it == variable_slots_.end() ? none : it->second;
}

/// `Other::SYMBOL`: of another style a symbol, and nothing else.
ExprId Compiler::symbol_elsewhere(const syntax::Reference& r, Span at) {
  const auto style = style_number(r.style.text);
  if (!style) refuse_style(r.style);
  const std::string_view name = r.names[0].text;
  const bool is_variable =
      !known_symbols_.contains(name) &&
      std::ranges::find(program_.styles[*style].linked->variables, name, &VariableBinding::name) !=
          program_.styles[*style].linked->variables.end();
  if (r.names.size() > 1 || is_variable) refuse_elsewhere(r, at, "variables");
  return constant(Value::of_symbol(program_.symbols.intern(name), *style + 1u), at);
}

void Compiler::refuse_elsewhere(const syntax::Reference& r, Span at, std::string_view what) {
  const std::string style(r.style.text);
  refuse(at,
         "'" + std::string(at.text()) + "' is no symbol: " + std::string(what) +
             " of another style can not be used here",
         "only a style that inherits from '" + style + "' sees its " + std::string(what) + "; '" +
             style + "::NAME' is a symbol");
}

ExprId Compiler::reference(const syntax::Reference& r, Span at, NameScope& scope) {
  if (r.style) return symbol_elsewhere(r, at);
  return r.names.size() == 1 ? plain_name(r.names[0], scope) : dotted_name(r, at, scope);
}

ExprId Compiler::plain_name(const syntax::Name& name, NameScope& scope) {
  const auto parameter = std::ranges::find(scope.parameters, name.text);
  if (parameter != scope.parameters.end()) {
    return node(ExprKind::parameter, name.at, {}, 0,
                static_cast<uint8_t>(parameter - scope.parameters.begin()));
  }
  for (const std::string_view block : {scope.block, std::string_view{}}) {
    if (const uint32_t slot = variable_slot(scope.style, block, name.text); slot != none) {
      return node(ExprKind::variable, name.at, {}, slot);
    }
  }
  if (name.text == "fits") {
    if (!scope.in_guard) refuse(name.at, "'fits' stands only in the condition of a rule");
    scope.asked_fits = true;
    if (scope.fits_call == none && scope.body_failed) {
      return constant(Value::of(true), name.at);
    }
    if (scope.fits_call == none) {
      refuse(name.at, "'fits' asks about a split, and this rule has none",
             "use subdiv, repeat or split, or another condition");
    }
    return node(ExprKind::fits, name.at, {}, scope.fits_call);
  }
  if (const AttributeRow* row = find_attribute(name.text))
    return node(ExprKind::attribute, name.at, {}, 0, static_cast<uint8_t>(row->attribute));
  if (const InputRow* row = find_input(name.text))
    return node(ExprKind::input, name.at, {}, 0, static_cast<uint8_t>(row->input));
  if (known_symbols_.contains(name.text) || (scope.symbols && looks_like_symbol(name.text))) {
    return constant(Value::of_symbol(program_.symbols.intern(name.text)), name.at);
  }
  unknown_name(name, scope);
}

void Compiler::unknown_name(const syntax::Name& name, const NameScope& scope) {
  std::vector<std::string_view> known(scope.parameters.begin(), scope.parameters.end());
  const LinkedStyle& linked = *program_.styles[scope.style].linked;
  for (const VariableBinding& v : linked.variables) {
    if (v.block == scope.block || v.block.empty()) known.push_back(v.name);
  }
  for (const AttributeRow& a : attributes()) known.push_back(a.name);
  for (const InputRow& i : inputs()) known.push_back(i.name);
  for (const std::string_view word : {"fits", "else", "true", "false"}) {
    if (scope.in_guard || word == "true" || word == "false") known.push_back(word);
  }
  std::string help = meant(name.text, known);
  for (const VariableBinding& v : linked.variables) {
    if (v.name == name.text)
      help = "write '" + qualified(v.block, v.name) + "': it belongs to another block";
  }
  const auto is_slip = [&](const Diagnostic& d) {
    return d.code == "W016" && d.at && d.at.text() == scope.block;
  };
  if (std::ranges::any_of(diagnostics_.all(), is_slip))
    help = "it is known where '" + std::string(scope.block) + "' is written as the warning says";
  if (find_function(name.text))
    help = "it is a function: write " + std::string(name.text) + "(...)";
  refuse(name.at, "unknown variable '" + std::string(name.text) + "'", help);
}

ExprId Compiler::dotted_name(const syntax::Reference& r, Span at, NameScope& scope) {
  const std::string_view first = r.names[0].text, second = r.names[1].text;
  if (first == "Shape") {
    const std::string text(at.text());
    refuse(at, "'" + text + "' asks about nothing", "write " + text + "(\"all\")");
  }
  if (r.names.size() == 2) {
    const std::string full = qualified(first, second);
    if (const AttributeRow* row = find_attribute(full))
      return node(ExprKind::attribute, at, {}, 0, static_cast<uint8_t>(row->attribute));
    if (const uint32_t slot = variable_slot(scope.style, first, second); slot != none) {
      return node(ExprKind::variable, at, {}, slot);
    }
  }
  std::vector<std::string_view> known;
  for (const VariableSlot& v : program_.variables) known.push_back(v.name);
  for (const AttributeRow& a : attributes()) known.push_back(a.name);
  const auto full = std::string(at.text());
  refuse(at, "unknown variable '" + full + "'", meant(full, known));
}

ExprId Compiler::plain_argument(const syntax::Arg& arg, NameScope& scope) {
  if (arg.name) refuse(arg.name.at, "arguments of functions have no names");
  if (arg.value.kind != syntax::SizeKind::absolute) {
    refuse(arg.at, "'" + std::string(arg.at.text()) + "' is a size, here stands a value");
  }
  return expression(*arg.value.value, scope);
}

ExprId Compiler::call(const syntax::Call& call, Span at, NameScope& scope) {
  const syntax::Name& name = call.callee.names.back();
  if (call.callee.style) refuse_elsewhere(call.callee, at, "functions");
  if (call.callee.names.size() == 1) {
    if (name.text == "attr") return attribute_call(call, at, scope);
    if (const Function* function = find_function(name.text))
      return function_call(*function, call, at, scope);
  }
  if (call.callee.names.size() == 2 && call.callee.names[0].text == "Shape")
    return question(call, at, scope);
  if (call.callee.names.size() == 2 && call.callee.names[0].text == "group")
    return group_question(call, at, scope);
  if (is_later_operation(name.text)) refuse_later(at);
  const std::string_view own =
      call.callee.names.size() == 2 ? call.callee.names[0].text : scope.block;
  for (const std::string_view block : {own, std::string_view{}}) {
    const auto it = function_slots_.find({scope.style, qualified(block, name.text)});
    if (it == function_slots_.end()) continue;
    const uint8_t expected = program_.functions[it->second].parameters;
    if (call.args.size() != expected) {
      refuse(at, "'" + std::string(name.text) + "' takes " + count_text(expected, "argument") +
                     ", not " + std::to_string(call.args.size()));
    }
    std::vector<ExprId> args;
    for (const syntax::Arg& arg : call.args) args.push_back(plain_argument(arg, scope));
    const ExprId id = node(ExprKind::definition, at, std::move(args), it->second);
    program_.nodes[id].salt = scope.salt ? (*scope.salt)++ : 0;
    return id;
  }
  std::vector<std::string_view> known{"attr"};
  for (const Function& f : functions()) known.push_back(f.name);
  for (const FunctionBinding& f : program_.styles[scope.style].linked->functions)
    known.push_back(f.name);
  std::string help = meant(name.text, known);
  for (const std::string_view prefix : {"Shape.", "group."}) {
    const std::string whole = std::string(prefix) + std::string(name.text);
    if (find_function(whole)) help = "write " + whole + "(...)";
  }
  refuse(name.at, "unknown function '" + std::string(name.text) + "'", help);
}

ExprId Compiler::function_call(const Function& function, const syntax::Call& call, Span at,
                               NameScope& scope) {
  const std::size_t n = call.args.size();
  if (n < function.required || (n > function.count && !function.variadic)) {
    refuse(at, "'" + std::string(function.name) + "(" + std::string(function.args) + ")' got " +
                   count_text(n, "argument"));
  }
  std::vector<ExprId> args;
  for (const syntax::Arg& arg : call.args) args.push_back(plain_argument(arg, scope));
  const auto row = static_cast<uint8_t>(&function - functions().data());
  const ExprId id = node(ExprKind::call, at, std::move(args), 0, row);
  if (function.random && scope.salt) program_.nodes[id].salt = (*scope.salt)++;
  return id;
}

ExprId Compiler::attribute_call(const syntax::Call& call, Span at, NameScope& scope) {
  if (call.args.size() != 2) {
    refuse(at,
           "'attr' takes the name of a property and a default, it got " +
               count_text(call.args.size(), "argument"),
           "attr(\"height\", 9)");
  }
  const syntax::ExprPtr& name = call.args[0].value.value;
  const auto* text = name ? std::get_if<syntax::Text>(&name->is) : nullptr;
  if (!text) refuse(call.args[0].at, "the name of a property is a string in quotes");
  const uint32_t slot = program_.properties.intern(text->value);
  const ExprId fallback = plain_argument(call.args[1], scope);
  return node(ExprKind::property, at, {fallback}, slot);
}

}  // namespace mansard
