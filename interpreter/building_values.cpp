#include "interpreter/building_values.hpp"

#include <set>
#include <unordered_map>
#include <utility>

#include "interpreter/compiler.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/messages.hpp"

namespace mansard {

namespace {

std::string property_text(const PropertyValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* number = std::get_if<double>(&value)) return number_text(*number);
  return std::get<bool>(value) ? "true" : "false";
}

/// Follows an expression through variables and functions.
class DependenceWalk {
 public:
  explicit DependenceWalk(const Program& program) : program_(program) {}

  Dependence found;

  void variable(uint32_t slot) {
    if (!variables_.insert(slot).second) return;
    const VariableSlot& v = program_.variables[slot];
    if (v.binding && !v.binding->syntax->value && !v.from_command_line) found.abstract = true;
    if (v.settable && !v.from_command_line) found.set = true;
    const bool outer = std::exchange(once_a_building_, v.per == VariableSlot::Per::building);
    expression(v.value);
    once_a_building_ = outer;
  }

  void expression(ExprId id) {
    if (id == none) return;
    const ExprNode& node = program_.nodes[id];
    switch (node.kind) {
      case ExprKind::attribute:
      case ExprKind::fits:
        found.shape = true;
        break;
      case ExprKind::property:
      case ExprKind::input:
        found.footprint = true;
        break;
      case ExprKind::call:
        if (functions()[node.aux].random) draw();
        if (functions()[node.aux].asks != Asks::nothing) found.shape = true;
        break;
      case ExprKind::variable:
        variable(node.first);
        break;
      case ExprKind::definition:
        if (functions_.emplace(node.first, once_a_building_).second)
          expression(program_.functions[node.first].value);
        break;
      default:
        break;
    }
    for (uint32_t i = 0; i < node.count; ++i) expression(program_.children[node.children + i]);
  }

 private:
  /// What `@per` makes another draw for each shape, is another value for each shape.
  void draw() {
    found.random = true;
    if (!once_a_building_) found.shape = true;
  }

  const Program& program_;
  std::set<uint32_t> variables_;
  std::set<std::pair<uint32_t, bool>> functions_;  ///< and how often they draw
  bool once_a_building_ = true;
};

DeriveOptions seeded(uint64_t seed) {
  DeriveOptions options;
  options.seed = seed;
  return options;
}

}  // namespace

class BuildingValues::Evaluator {
 public:
  Evaluator(const Program& program, const Footprint& footprint, uint64_t seed)
      : program_(program), machine_(program, meshes_, seeded(seed)) {
    machine_.reset(footprint, building_);
    const CompiledStyle& main = program.styles[program.main_style];
    for (uint32_t i = 0; i < program.variables.size(); ++i) {
      const VariableSlot& v = program.variables[i];
      if (v.binding && main.linked->find_variable(v.binding->block, v.binding->name) == v.binding)
        slots_.emplace(v.name, i);
    }
    for (const uint32_t top : main.rules) {
      for (uint32_t set = top; set != none; set = program.rule_sets[set].super) {
        const RuleSet& rules = program.rule_sets[set];
        for (uint32_t i = rules.first; i < rules.first + rules.count; ++i)
          productions_.emplace(program.productions[i].syntax, i);
      }
    }
  }

  std::optional<VariableValue> variable(std::string_view block, std::string_view name) {
    const auto found = slots_.find(qualified(block, name));
    if (found == slots_.end()) return std::nullopt;
    const uint32_t slot = found->second;
    const VariableSlot& v = program_.variables[slot];
    VariableValue result;
    result.settable = v.settable && !v.from_command_line;
    DependenceWalk walk(program_);
    walk.variable(slot);
    result.dependence = walk.found;
    result.property = property_named(v.name);
    if (v.from_command_line) {
      result.giver = VariableValue::Giver::command_line;
      const Span at = program_.spans[v.value];
      result.command_line = at ? std::string(at.source->text()) : std::string();
    } else if (result.property) {
      return given_by_property(slot, std::move(result));
    }
    if (!result.dependence.shape && !result.dependence.abstract) evaluate(slot, result);
    return result;
  }

  std::optional<double> weight(const syntax::Rule& rule) {
    const auto found = productions_.find(&rule);
    if (found == productions_.end()) return std::nullopt;
    const ExprId id = program_.productions[found->second].probability;
    if (id == none) return 1;
    DependenceWalk walk(program_);
    walk.expression(id);
    if (walk.found.shape || walk.found.random) return std::nullopt;
    try {
      return machine_.number(id, Env{});
    } catch (const Failure&) {
      return std::nullopt;
    }
  }

 private:
  std::optional<std::string> property_named(const std::string& name) const {
    const Property* property = machine_.footprint->find(name);
    return property ? std::optional(property_text(property->value)) : std::nullopt;
  }

  /// What a property says takes the type of the style's own value, or is not taken.
  VariableValue given_by_property(uint32_t slot, VariableValue result) {
    result.giver = VariableValue::Giver::property;
    if (result.dependence.shape) {
      result.value = result.property;
    } else {
      const std::size_t warned = building_.warnings.size();
      evaluate(slot, result);
      if (building_.warnings.size() > warned) {
        result.giver = VariableValue::Giver::style;
        const Type type = machine_.variable(slot, Env{}, program_.variables[slot].value).type;
        result.problem = "property '" + program_.variables[slot].name + "' is \"" +
                         *result.property + "\", not " + std::string(described(type)) +
                         ": it is not taken";
        return result;
      }
    }
    result.dependence = {.footprint = true, .set = result.settable};
    return result;
  }

  void evaluate(uint32_t slot, VariableValue& result) {
    try {
      const Value value = machine_.variable(slot, Env{}, program_.variables[slot].value);
      result.value = script_text(program_, value);
    } catch (const Failure& failure) {
      result.problem = failure.diagnostic.text;
    }
  }

  const Program& program_;
  NoMeshes meshes_;
  Building building_;
  Machine machine_;
  std::unordered_map<std::string, uint32_t> slots_;  ///< of the main style's variables
  std::unordered_map<const syntax::Rule*, uint32_t> productions_;
};

BuildingValues::BuildingValues(const Program& program, const Footprint& footprint, uint64_t seed)
    : evaluator_(std::make_unique<Evaluator>(program, footprint, seed)) {}
BuildingValues::~BuildingValues() = default;

std::optional<VariableValue> BuildingValues::variable(std::string_view block,
                                                      std::string_view name) {
  return evaluator_->variable(block, name);
}

std::optional<double> BuildingValues::weight(const syntax::Rule& rule) {
  return evaluator_->weight(rule);
}

}  // namespace mansard
