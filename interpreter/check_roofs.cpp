// What a rule writes out of a roof or dormer can be judged without one.
#include <algorithm>

#include "interpreter/compiler.hpp"
#include "interpreter/roof_words.hpp"

namespace mansard {
void Compiler::check_roof(const Call& call) {
  const std::string_view name = call.operation->name;
  if (name != "roof" && name != "upright") return;
  for (std::size_t i = 0; i < call.args.size(); ++i) {
    const auto number = constant_number(call.args[i].value);
    if (!number) continue;
    if (const auto wrong = wrong_roof_number(call.operation->parameter_name(i), *number))
      refuse(program_.spans[call.args[i].value], wrong->text, wrong->help);
  }
  if (name == "upright") return check_dormer_kind(call);
  check_rivals(call, "pitch", "height");
  check_rivals(call, "break_height", "break_inset");
  check_roof_kind(call);
}

/// Two arguments of which one decides.
void Compiler::check_rivals(const Call& call, std::string_view one, std::string_view other) {
  const ExprId a = call.args[call.operation->find_parameter(one)].value;
  const ExprId b = call.args[call.operation->find_parameter(other)].value;
  if (a == none || b == none) return;
  Diagnostic d;
  d.at = program_.spans[a];
  d.also.push_back(program_.spans[b]);
  d.text = "'" + std::string(one) + "' and '" + std::string(other) + "' are both given";
  d.help = "one follows from the other: leave one of them out";
  throw Failure(std::move(d));
}

void Compiler::check_dormer_kind(const Call& call) {
  const ExprId kind = call.args[0].value;
  if (kind == none || program_.nodes[kind].kind != ExprKind::constant) return;
  const Value& value = program_.constants[program_.nodes[kind].first];
  if (value.type != Type::string) return;
  if (std::ranges::find(dormer_kinds, value.string()) != dormer_kinds.end()) return;
  const WrongWord unknown = unknown_dormer_kind(value.string());
  refuse(program_.spans[kind], unknown.text, unknown.help);
}

/// A kind that a variable holds may have no use for some arguments: others of its values have.
void Compiler::check_roof_kind(const Call& call) {
  const ExprNode& node = program_.nodes[call.args[0].value];
  if (node.kind != ExprKind::constant) return;
  const Value& value = program_.constants[node.first];
  if (value.type != Type::string) return;
  const auto kind = find_roof_kind(value.string());
  if (!kind) {
    const WrongWord unknown = unknown_roof_kind(value.string());
    refuse(program_.spans[call.args[0].value], unknown.text, unknown.help);
  }
  for (std::size_t i = 1; i < call.args.size(); ++i) {
    if (call.args[i].value == none) continue;
    if (const auto idle = idle_roof_argument(call.operation->parameter_name(i), *kind))
      refuse(program_.spans[call.args[i].value], idle->text, idle->help);
  }
}

}  // namespace mansard
