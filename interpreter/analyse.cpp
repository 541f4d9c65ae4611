// What can be known before any shape is derived: which variables read the shape, what is constant,
// which types can not meet.
#include <algorithm>

#include "interpreter/compiler.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/messages.hpp"

namespace mansard {

void Compiler::mark_settable() {
  for (VariableSlot& v : program_.variables) v.settable = set_somewhere_.contains(v.setting);
}

/// Nodes that are not always evaluated: below a branch or behind && and ||.
std::vector<bool> Compiler::conditional_nodes() const {
  std::vector<bool> conditional(program_.nodes.size(), false);
  for (ExprId id = static_cast<ExprId>(program_.nodes.size()); id-- > 0;) {  // parents first
    const ExprNode& n = program_.nodes[id];
    const bool chooses =
        n.kind == ExprKind::conditional || n.kind == ExprKind::and_ || n.kind == ExprKind::or_;
    for (uint32_t i = 0; i < n.count; ++i) {
      if (conditional[id] || (chooses && i > 0))
        conditional[program_.children[n.children + i]] = true;
    }
  }
  return conditional;
}

/// Children come before their parents, so one pass folds all. What fails when folded fails whenever
/// it is evaluated: an error here, unless it might never be.
void Compiler::fold_constants() {
  const std::vector<bool> conditional = conditional_nodes();
  NoMeshes meshes;
  Machine machine(program_, meshes, {});
  for (ExprId id = 0; id < program_.nodes.size(); ++id) {
    const ExprNode n = program_.nodes[id];
    const bool random = n.kind == ExprKind::call && functions()[n.aux].random;
    if (n.kind < ExprKind::list || n.kind == ExprKind::definition || is_question(n)) continue;
    const bool constant = std::all_of(
        program_.children.begin() + n.children, program_.children.begin() + n.children + n.count,
        [&](ExprId child) { return program_.nodes[child].kind == ExprKind::constant; });
    if (!constant) continue;
    try {
      Value value = machine.evaluate(id, Env{});
      if (random) continue;  // only tried: its arguments are right
      if (value.type == Type::string)
        value.text = program_.texts.emplace_back(value.string()).data();
      if (value.type == Type::list) {
        const auto& kept = program_.lists.emplace_back(value.list().begin(), value.list().end());
        value.items = kept.data();
      }
      program_.nodes[id] = ExprNode{
          ExprKind::constant, 0, 0, static_cast<uint32_t>(program_.constants.size()), 0, 0};
      program_.constants.push_back(value.from(id));
    } catch (Failure& failure) {
      if (!conditional[id]) diagnostics_.add(std::move(failure.diagnostic));
    }
  }
}

std::optional<Type> Compiler::static_type(ExprId id) const {
  if (program_.nodes[id].kind != ExprKind::variable) return static_type_of_node(id);
  // Once a variable: a chain of variables that each read the one before twice is not 2^n long.
  const auto [known, fresh] = static_types_.try_emplace(program_.nodes[id].first);
  if (fresh) {
    const std::optional<Type> type = static_type_of_node(id);
    static_types_[program_.nodes[id].first] = type;
    return type;
  }
  return known->second;
}

std::optional<Type> Compiler::static_type_of_node(ExprId id) const {
  const ExprNode& n = program_.nodes[id];
  switch (n.kind) {
    case ExprKind::constant:
      return program_.constants[n.first].type;
    case ExprKind::attribute: {
      const auto a = static_cast<Attribute>(n.aux);
      if (a == Attribute::is_rectangle || a == Attribute::is_convex || a == Attribute::is_planar)
        return Type::boolean;
      if (a == Attribute::comp_name) return Type::string;
      if (a == Attribute::symbol) return Type::symbol;
      return Type::number;
    }
    case ExprKind::variable: {
      const VariableSlot& v = program_.variables[n.first];
      if (v.settable || v.value == none) return std::nullopt;
      return static_type(v.value);
    }
    case ExprKind::property:
      return static_type(program_.children[n.children]);
    case ExprKind::input:
      return n.aux >= static_cast<uint8_t>(Input::name) ? Type::string : Type::number;
    case ExprKind::list:
      return Type::list;
    case ExprKind::fits:
      return Type::boolean;
    case ExprKind::negate:
    case ExprKind::subtract:
    case ExprKind::multiply:
    case ExprKind::divide:
      return Type::number;
    case ExprKind::add: {
      const auto left = static_type(program_.children[n.children]);
      return left == static_type(program_.children[n.children + 1]) ? left : std::nullopt;
    }
    case ExprKind::conditional:
      return static_type(program_.children[n.children + 1]);
    case ExprKind::parameter:
    case ExprKind::subscript:
    case ExprKind::call:
    case ExprKind::definition:
      return std::nullopt;
    default:
      return Type::boolean;
  }
}

void Compiler::check_types() {
  for (ExprId id = 0; id < program_.nodes.size(); ++id) {
    const ExprNode& n = program_.nodes[id];
    if (n.kind < ExprKind::add || n.kind > ExprKind::unequal) continue;
    const ExprId a = program_.children[n.children], b = program_.children[n.children + 1];
    const auto left = static_type(a), right = static_type(b);
    if (!left || !right) continue;
    attempt_anywhere([&] {
      auto wrong = operand_error(program_, n, *left, *right, a, b);
      if (!wrong) return;
      for (const ExprId side : {a, b}) add_writer(*wrong, side);
      throw Failure(std::move(*wrong));
    });
  }
  for (const Call& call : program_.calls) {
    attempt_anywhere([&] {
      check_call_types(call);
      check_sizes(call);
      check_picture(call);
      check_material(call);
    });
  }
}

namespace {

/// `0,5`: digits stand against both sides of the comma before the number.
bool is_decimal_comma(Span number) {
  if (!number || number.begin < 2) return false;
  const std::string_view text = number.source->text();
  const auto is_digit = [&](std::size_t i) { return text[i] >= '0' && text[i] <= '9'; };
  return text[number.begin - 1] == ',' && is_digit(number.begin - 2) && is_digit(number.begin);
}

}  // namespace

/// A value that set() gives is of the kind that the variable has.
void Compiler::check_setting_type(const Call& call) {
  if (call.setting == none) return;
  const auto variable = std::ranges::find(program_.variables, call.setting, &VariableSlot::setting);
  if (variable == program_.variables.end() || variable->value == none) return;
  const auto wanted = static_type(variable->value);
  for (const SizeExpr& arg : call.args) {
    const auto type = arg.value == none ? std::nullopt : static_type(arg.value);
    if (!type || !wanted || type == wanted) continue;
    refuse(
        program_.spans[arg.value],
        "'" + variable->name + "' is " + std::string(described(*wanted)) + ", not " +
            std::string(described(*type)),
        {},
        {{std::string(described(*wanted)) + " was written here", program_.spans[variable->value]}});
  }
}

void Compiler::check_call_types(const Call& call) {
  const Operation& operation = *call.operation;
  check_setting_type(call);
  for (std::size_t i = 0; i < call.args.size(); ++i) {
    if (call.args[i].value == none) continue;
    const std::size_t known = operation.parameter_of(i);
    const auto type = static_type(call.args[i].value);
    if (!type) continue;
    std::optional<Type> wanted;
    switch (operation.parameters[known].type) {
      case ArgType::sizes:
        if (*type == Type::list) break;
        [[fallthrough]];
      case ArgType::number:
      case ArgType::length:
        wanted = Type::number;
        break;
      case ArgType::string:
        wanted = Type::string;
        break;
      case ArgType::boolean:
        wanted = Type::boolean;
        break;
      default:
        break;
    }
    if (!wanted || *wanted == *type) continue;
    Diagnostic d;
    d.at = program_.spans[call.args[i].value];
    d.text = "'" + std::string(operation.name) + "' expects " + std::string(described(*wanted)) +
             " for '" + std::string(operation.parameter_name(known)) + "', not " +
             std::string(described(*type));
    if (is_decimal_comma(d.at)) d.help = "a decimal point is '.', not ','";
    add_writer(d, call.args[i].value);
    throw Failure(std::move(d));
  }
}

/// Says where the value of a variable was written.
void Compiler::add_writer(Diagnostic& d, ExprId id) const {
  const ExprNode& n = program_.nodes[id];
  const auto type = static_type(id);
  if (n.kind != ExprKind::variable || !type) return;
  note_writer(d, described(*type), program_.spans[program_.variables[n.first].value]);
}

/// Of a texture() that names its file outright; any other is looked for when it is carried out.
void Compiler::check_picture(const Call& call) {
  if (call.operation != find_operation("texture")) return;
  const ExprId file = call.args[0].value;
  if (program_.nodes[file].kind != ExprKind::constant) return;
  picture(program_.constants[program_.nodes[file].first].string(), program_.spans[file]);
}

/// Of a material() that names its entry outright, which from here on is a symbol.
void Compiler::check_material(const Call& call) {
  if (call.operation != find_operation("material")) return;
  const ExprNode& node = program_.nodes[call.args[0].value];
  if (node.kind != ExprKind::constant) return;
  Value& name = program_.constants[node.first];
  if (name.type != Type::string) return;
  const auto symbol = program_.symbols.find(name.string());
  const auto has = [&](const CompiledStyle& style) {
    return std::ranges::find(style.linked->materials, name.string(), &MaterialBinding::symbol) !=
           style.linked->materials.end();
  };
  if (symbol && std::ranges::any_of(program_.styles, has)) {
    name = Value::of_symbol(*symbol);
    return;
  }
  std::vector<std::string_view> names;
  for (const CompiledStyle& style : program_.styles) {
    for (const MaterialBinding& binding : style.linked->materials) names.push_back(binding.symbol);
  }
  const std::string help = meant(name.string(), names);
  refuse(program_.spans[call.args[0].value],
         "there are no materials for '" + std::string(name.string()) + "'",
         help.empty() ? "write them in the block Materials: " + std::string(name.string()) +
                            " : color(\"tan\")"
                      : help);
}

/// Of a variable that set() changes, what it is without.
std::optional<Type> Compiler::declared_type(ExprId id) const {
  const ExprNode& n = program_.nodes[id];
  if (n.kind != ExprKind::variable) return static_type(id);
  const ExprId value = program_.variables[n.first].value;
  return value == none ? std::nullopt : static_type(value);
}

/// subdiv with sizes that are all single: as many as parts.
void Compiler::check_sizes(const Call& call) {
  if (call.operation->rule != PartRule::sizes || call.parts.size() < 2) return;
  std::size_t sizes = 0;
  for (std::size_t i = call.operation->count; i < call.args.size(); ++i) {
    const auto type = declared_type(call.args[i].value);
    if (!type) return;
    const ExprNode& n = program_.nodes[call.args[i].value];
    if (*type == Type::list && n.kind != ExprKind::constant) return;
    sizes += *type == Type::list ? program_.constants[n.first].size : 1;
  }
  if (sizes == call.parts.size()) return;
  throw Failure(size_count_error(call, sizes));
}

}  // namespace mansard
