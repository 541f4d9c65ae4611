// Splits that snap, and snap(): what is wrong with them for every shape, and which rules wait for
// their planes.
#include <algorithm>

#include "interpreter/axes.hpp"
#include "interpreter/compiler.hpp"
#include "interpreter/messages.hpp"

namespace mansard {
namespace {

/// subdiv, repeat and split, not mirror.
bool has_axis(const Call& call) {
  return call.operation->parameter_name(0) == "axis" &&
         call.operation->find_parameter("tolerance") < call.operation->count;
}

}  // namespace

const Value* Compiler::constant_value(ExprId id) const {
  if (id == none || program_.nodes[id].kind != ExprKind::constant) return nullptr;
  return &program_.constants[program_.nodes[id].first];
}

/// The text of an argument that is constant.
std::optional<std::string_view> Compiler::constant_text(ExprId id) const {
  const Value* const value = constant_value(id);
  return value && value->type == Type::string ? std::optional(value->string()) : std::nullopt;
}

/// By call. An axis that is computed snaps if the script has the word for one that does.
std::vector<bool> Compiler::snapping_calls() const {
  const bool said = std::ranges::any_of(program_.constants, [](const Value& value) {
    return value.type == Type::string && is_snapping_axis(value.string());
  });
  std::vector<bool> snaps;
  for (const Call& call : program_.calls) {
    const auto word = has_axis(call) ? constant_text(call.args[0].value) : std::nullopt;
    snaps.push_back(said && has_axis(call) &&
                    (word ? is_snapping_axis(*word) : !constant_value(call.args[0].value)));
  }
  return snaps;
}

void Compiler::check_snapping() {
  std::vector<std::string_view> labels;
  bool computed = false;
  for (const Call& call : program_.calls) {
    const bool names = call.operation->name == "snap" || call.operation->name == "label";
    if (!names || call.args.back().value == none) continue;
    const auto text = constant_text(call.args.back().value);
    text ? labels.push_back(*text) : void(computed = true);
  }
  for (const Call& call : program_.calls) {
    if (call.operation->name == "snap") attempt_anywhere([&] { check_planes(call); });
    if (!has_axis(call)) continue;
    attempt_anywhere([&] { check_snap_options(call); });
    if (!computed) attempt_anywhere([&] { check_snap_label(call, labels); });
  }
}

void Compiler::check_planes(const Call& call) {
  const auto planes = constant_text(call.args[0].value);
  if (planes && !normals_named(*planes))
    refuse(program_.spans[call.args[0].value], wrong_planes(*planes), std::string(planes_help));
}

void Compiler::check_axis_word(const Call& call) {
  const auto word = has_axis(call) ? constant_text(call.args[0].value) : std::nullopt;
  if (word && !axis_named(*word))
    refuse(program_.spans[call.args[0].value], wrong_axis(*word), axis_help(*word));
}

/// `to` and `tolerance` belong to an axis with an S.
void Compiler::check_snap_options(const Call& call) {
  const Operation& operation = *call.operation;
  const ExprId tolerance = call.args[operation.find_parameter("tolerance")].value;
  if (const auto metres = constant_number(tolerance); metres && !is_tolerance(*metres))
    refuse(program_.spans[tolerance], wrong_tolerance(*metres));
  const Value* const axis = constant_value(call.args[0].value);
  if (!axis || (axis->type == Type::string && is_snapping_axis(axis->string()))) return;
  for (const std::string_view name : {"to", "tolerance"}) {
    const ExprId given = call.args[operation.find_parameter(name)].value;
    if (given == none) continue;
    const auto word = constant_text(call.args[0].value);
    refuse(program_.spans[given],
           "'" + std::string(name) + "' is for splits that snap, and this axis does not",
           word ? "write \"" + std::string(*word) + "S\" to snap"
                : "an axis at an angle can not snap");
  }
}

void Compiler::check_snap_label(const Call& call, std::span<const std::string_view> labels) {
  const ExprId to = call.args[call.operation->find_parameter("to")].value;
  const auto word = constant_text(to);
  if (!word || std::ranges::find(labels, *word) != labels.end()) return;
  const std::string help = meant(*word, labels);
  refuse(program_.spans[to], "\"" + std::string(*word) + "\" is no label of a plane or a mass",
         help.empty() ? "snap(\"XZ\", \"" + std::string(*word) +
                            "\") records planes of this label, label() names masses"
                      : help);
}

}  // namespace mansard
