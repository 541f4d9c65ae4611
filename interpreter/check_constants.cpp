// Constant arguments that are wrong for every shape, so that nobody has to derive one to hear of
// it.
#include <algorithm>
#include <span>

#include "interpreter/compiler.hpp"
#include "interpreter/messages.hpp"

namespace mansard {

std::optional<double> Compiler::constant_number(ExprId id) const {
  if (id == none || program_.nodes[id].kind != ExprKind::constant) return std::nullopt;
  const Value& value = program_.constants[program_.nodes[id].first];
  return value.type == Type::number ? std::optional(value.number) : std::nullopt;
}

void Compiler::check_constants() {
  for (const Call& call : program_.calls) {
    attempt_anywhere([&] { check_axis(call); });
    attempt_anywhere([&] { check_roof(call); });
    attempt_anywhere([&] { check_stain(call); });
    check_components(call, call.parts);
  }
  for (const Production& production : program_.productions) {
    attempt_anywhere([&] {
      const auto probability = constant_number(production.probability);
      if (probability && *probability < 0) {
        refuse(program_.spans[production.probability], "a probability can not be negative");
      }
    });
  }
  for (const CompiledStyle& style : program_.styles) check_symbols_of_draws(style);
  for (const Step& step : program_.steps) {
    if (step.style_of != none) attempt_anywhere([&] { check_style_named(step.style_of); });
    if (step.index != none) attempt_anywhere([&] { check_index(step.index); });
  }
}

/// `FLOOR["ground"]`.
void Compiler::check_index(ExprId id) const {
  const auto type = static_type(id);
  if (!type || *type == Type::number) return;
  Diagnostic d;
  d.at = program_.spans[id];
  d.text = "an index is a number, not " + std::string(described(*type));
  add_writer(d, id);
  throw Failure(std::move(d));
}

std::string Compiler::style_meant(std::string_view name, Span at) const {
  std::vector<std::string_view> names;
  for (const syntax::Style* style : library_.styles()) names.push_back(style->name.text);
  const std::string help = meant(name, names);
  return help.empty() ? library_.how_to_import(name, at) : help;
}

void Compiler::refuse_style(const syntax::Name& name) const {
  refuse(name.at, "no style '" + std::string(name.text) + "' is loaded",
         style_meant(name.text, name.at));
}

/// `style("Terrace")::FOOTPRINT`.
void Compiler::check_style_named(ExprId id) {
  const ExprNode& node = program_.nodes[id];
  if (node.kind != ExprKind::constant) return warn_of_styles(id, 20);
  const Value& value = program_.constants[node.first];
  if (value.type != Type::string || library_.find(value.string())) return;
  refuse(program_.spans[id], "no style '" + std::string(value.string()) + "' is loaded",
         style_meant(value.string(), program_.spans[id]));
}

/// W022: names among which footprints, conditions and draws choose; `""` stands for none.
void Compiler::warn_of_styles(ExprId id, int levels) {
  const ExprNode& node = program_.nodes[id];
  const auto children = std::span(program_.children).subspan(node.children, node.count);
  if (node.kind == ExprKind::constant) return warn_of_style(program_.constants[node.first]);
  if (levels == 0) return;
  if (node.kind == ExprKind::variable)
    return warn_of_styles(program_.variables[node.first].value, levels - 1);
  const bool chooses = node.kind == ExprKind::call && functions()[node.aux].name == "choose";
  if (!chooses && node.kind != ExprKind::property && node.kind != ExprKind::conditional &&
      node.kind != ExprKind::list && node.kind != ExprKind::subscript)
    return;
  const bool skips = node.kind == ExprKind::conditional;  // its condition
  for (const ExprId child : children.subspan(skips ? 1 : 0)) warn_of_styles(child, levels - 1);
}

void Compiler::warn_of_style(const Value& name) {
  if (name.type == Type::list) {
    for (const Value& item : name.list()) warn_of_style(item);
  }
  if (name.type != Type::string || name.string().empty() || library_.find(name.string())) return;
  Diagnostic d;
  d.severity = Severity::warning;
  d.code = "W022";
  d.at = program_.origin(name);
  d.text = "no style '" + std::string(name.string()) + "' is loaded";
  d.help = style_meant(name.string(), d.at);
  if (is_checked(d.at)) diagnostics_.add(std::move(d));
}

void Compiler::check_axis(const Call& call) {
  if (call.args.empty() || call.operation->parameter_name(0) != "axis") return;
  check_axis_word(call);
  const auto angle = constant_number(call.args[0].value);
  if (angle && !is_angle(*angle)) {
    refuse(program_.spans[call.args[0].value], wrong_angle(*angle), "0 runs along the face, 90 up");
  }
}

void Compiler::check_components(const Call& call, const std::vector<CallPart>& parts) {
  if (call.operation->rule != PartRule::selectors) return;
  for (const CallPart& part : parts) {
    const auto number = constant_number(part.size.value);
    if (!number || is_component_number(*number)) continue;
    attempt_anywhere([&] {
      refuse(program_.spans[part.size.value], wrong_component(*number), "they are numbered from 0");
    });
  }
}

/// `@per("SYMBOL")` and `per "SYMBOL"`: nothing would ever be drawn anew for a misspelt one. A
/// style that is only mixed in may speak of symbols that its heirs have.
void Compiler::check_symbols_of_draws(const CompiledStyle& style) {
  const LinkedStyle& linked = *style.linked;
  if (!linked.missing.empty() || !linked.find_symbol(linked.start)) return;
  const auto check = [&](const syntax::Expr& expr, std::string_view block) {
    const auto* text = std::get_if<syntax::Text>(&expr.is);
    if (!text || text->value == "shape" || text->value == "building") return;
    if (known_symbols_.contains(text->value)) return;
    attempt(program_.style_numbers.at(style.name), block, [&] {
      const std::vector<std::string_view> names(known_symbols_.begin(), known_symbols_.end());
      const std::string help = meant(text->value, names);
      refuse(expr.at, "there is no symbol '" + text->value + "'",
             help.empty() ? "\"shape\", \"building\" or the name of a symbol" : help);
    });
  };
  for (const VariableBinding& variable : linked.variables) {
    for (const syntax::Annotation& annotation : variable.syntax->pre.annotations) {
      if (annotation.name.text != "per" || annotation.args.size() != 1) continue;
      if (const auto& value = annotation.args[0].value.value) check(*value, variable.block);
    }
  }
  for (const MaterialBinding& material : linked.materials) {
    if (material.entry && material.entry->per) check(*material.entry->per, "Materials");
  }
}

}  // namespace mansard
