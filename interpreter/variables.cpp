// Where a value comes from: set() on the shape, the footprint's properties, the style.
#include <cmath>

#include "interpreter/building_height.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/measure.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/units.hpp"

namespace mansard {

/// Strongest first: --set (compiled in as the value), set() on the shape or an ancestor, a property
/// of the footprint, the style.
Value Machine::variable(uint32_t slot, const Env& env, uint32_t node) {
  const VariableSlot& v = program.variables[slot];
  const auto known = [&]() -> const Value& {
    if (variable_varies_[slot]) reads |= read_bits::building;
    return variable_values_[slot];
  };
  if (!v.settable && variable_known_[slot] == building_number_) return known();
  const Deeper deeper(*this, node, program.depths[v.value] + 1);
  if (v.settable && env.shape && !v.from_command_line) {
    for (uint32_t i = env.shape->settings; i != none; i = settings[i].next) {
      if (settings[i].setting == v.setting) return settings[i].value;
    }
  }
  if (v.reads_shape && variable_property_[slot] == none) {
    if (depth_ > program.depths[v.value] + 1) count_call(node);
    if (measuring && v.per != VariableSlot::Per::building) reads |= read_bits::chance;
    const uint64_t draws = env.shape ? stream_of(v.per, v.per_symbol, *env.shape, v.salt)
                                     : mix(building_seed_, v.salt);
    return evaluate(v.value, Env{env.shape, nullptr, draws, nullptr});
  }
  if (variable_known_[slot] != building_number_) {
    const uint32_t before = std::exchange(reads, 0);
    const Value own =
        evaluate(v.value, Env{env.shape, nullptr, mix(building_seed_, v.salt), nullptr});
    const uint32_t name = variable_property_[slot];
    variable_values_[slot] = name == none ? own : property(name, own, node);
    variable_known_[slot] = building_number_;
    variable_varies_[slot] = (reads & (read_bits::building | read_bits::chance)) != 0;
    reads = before | (reads & ~read_bits::chance);
  }
  return known();
}

uint64_t Machine::stream_of(VariableSlot::Per per, uint32_t symbol, const Shape& shape,
                            uint64_t salt) const {
  if (per == VariableSlot::Per::building) return mix(building_seed_, salt);
  if (per == VariableSlot::Per::symbol) {
    for (uint32_t n = shape.node; n < nodes_.size(); n = nodes_[n].parent) {
      if (nodes_[n].symbol == symbol) return mix(nodes_[n].seed, salt);
    }
    return mix(building_seed_, salt);
  }
  return mix(shape.seed, salt);
}

uint64_t Machine::inherited_values(const Shape& shape) const {
  uint64_t hash = 0;
  const uint32_t rules = rules_of(shape);
  for (uint32_t i = 0; rules != none && i < program.rule_sets[rules].parameters; ++i) {
    hash = mix(hash, content_hash(shape.arguments[i]));
  }
  for (uint32_t i = shape.settings; i != none; i = settings[i].next) {
    hash = mix(mix(hash, settings[i].setting), content_hash(settings[i].value));
  }
  return hash;
}

/// The footprint's property as a value of the fallback's type; the fallback when there is none, or
/// when it can not be read as that type (a warning).
Value Machine::property(uint32_t slot, const Value& fallback, uint32_t node) {
  reads |= read_bits::building;
  if (property_known_[slot] != building_number_) return fallback;
  const PropertyValue& value = *property_values_[slot];
  const auto text = std::get_if<std::string>(&value);
  const auto number = std::get_if<double>(&value);
  const auto truth = std::get_if<bool>(&value);
  switch (fallback.type) {
    case Type::number:
      if (number && std::isfinite(*number)) return Value::of(*number);
      if (text) {
        if (const auto read = read_number(*text)) return Value::of(*read);
      }
      break;
    case Type::boolean:
      if (truth) return Value::of(*truth);
      if (number) return Value::of(*number != 0);
      if (text && (*text == "yes" || *text == "true" || *text == "1")) return Value::of(true);
      if (text && (*text == "no" || *text == "false" || *text == "0")) return Value::of(false);
      break;
    case Type::string:
      if (text) return Value::of(std::string_view(*text));
      if (number) return Value::of(keep(number_text(*number)));
      return Value::of(std::string_view(*truth ? "yes" : "no"));
    case Type::symbol:
      if (text) {
        if (const auto symbol = program.symbols.find(*text)) return Value::of_symbol(*symbol);
      }
      break;
    case Type::list:
      break;
  }
  warn("W012", program.spans[node],
       "property '" + std::string(program.properties[slot]) + "' of footprint '" + footprint->id +
           "'" + (text ? " is \"" + shortened(*text) + "\"," : "") + " not " +
           std::string(described(fallback.type)) + "; the default is used");
  return fallback;
}

namespace {

std::string_view text_or(const Footprint& footprint, std::string_view name,
                         std::string_view fallback) {
  const Property* p = footprint.find(name);
  const std::string* text = p ? std::get_if<std::string>(&p->value) : nullptr;
  return text ? std::string_view(*text) : fallback;
}

}  // namespace

Value Machine::input(Input which) {
  reads |= read_bits::building;
  const double levels = number_or(*footprint, "building:levels", 0);
  const double height = height_of(*footprint);
  switch (which) {
    case Input::height:
      return Value::of(height);
    case Input::levels:
      return Value::of(levels > 0 ? levels : std::max(1.0, std::round(height / 3)));
    case Input::name:
      return Value::of(text_or(*footprint, "name", footprint->id));
    case Input::use: {
      const std::string_view use = text_or(*footprint, "use", "");
      return Value::of(use.empty() ? text_or(*footprint, "building", "yes") : use);
    }
  }
  return {};
}

}  // namespace mansard
