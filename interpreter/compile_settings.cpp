// --set NAME=VALUE.
#include <algorithm>

#include "grammar/enumerate.hpp"
#include "interpreter/compiler.hpp"
#include "interpreter/number_wanted.hpp"

namespace mansard {

void Compiler::apply_settings() {
  // One that names a style is stronger than one that speaks to all.
  for (const bool of_a_style : {false, true}) {
    for (const auto& [name, value] : options_.settings) {
      if ((name.find("::") != std::string::npos) == of_a_style) apply_setting(name, value);
    }
  }
}

/// Why --set found nothing to set.
Diagnostic Compiler::unknown_setting(const std::string& full, std::string_view style,
                                     std::string_view name) const {
  Diagnostic d;
  if (!style.empty() && !program_.style_numbers.contains(style)) {
    std::vector<std::string_view> styles;
    for (const syntax::Style* s : library_.styles()) styles.push_back(s->name.text);
    const bool loaded = library_.find(style) != nullptr;
    d.text = "--set " + full + ": " + (loaded ? "style '" : "no style '") + std::string(style) +
             (loaded ? "' has no part in this derivation" : "' is loaded");
    d.help = loaded ? "name the style that is derived, or none: --set " + std::string(name)
                    : meant(style, styles);
    return d;
  }
  d.text = "--set " + full + ": no variable of that name";
  std::vector<std::string_view> names;
  std::vector<std::string> of_blocks;
  for (const VariableSlot& variable : program_.variables) {
    names.push_back(variable.name);
    const std::string flag = "--set " + variable.name;
    const bool is_known = std::ranges::find(of_blocks, flag) != of_blocks.end();
    if (variable.binding->name == name && !variable.binding->block.empty() && !is_known)
      of_blocks.push_back(flag);
  }
  d.help = of_blocks.empty()
               ? meant(name, names)
               : (of_blocks.size() == 1 ? "it belongs to a block: " : "it belongs to blocks: ") +
                     enumerate(of_blocks, "or");
  return d;
}

/// --set Block.Name=v or Style::Block.Name=v; a bare word is a string.
void Compiler::apply_setting(const std::string& full, const std::string& value) {
  std::string style, name = full;
  if (const auto colons = full.find("::"); colons != std::string::npos) {
    style = full.substr(0, colons);
    name = full.substr(colons + 2);
  }
  std::vector<uint32_t> slots;
  for (const auto& [key, slot] : variable_slots_) {
    if (key.second == name && (style.empty() || program_.styles[key.first].name == style))
      slots.push_back(slot);
  }
  if (slots.empty()) {
    return diagnostics_.add(unknown_setting(full, style, name));
  }
  const Source& source = library_.sources().add("--set " + full, value);
  Diagnostics quiet;
  const syntax::ExprPtr parsed = parse_expression(source, quiet);
  const Span all{&source, 0, static_cast<uint32_t>(value.size())};
  uint16_t salt = 0;
  ExprId id = none;
  try {
    NameScope scope{program_.main_style, {}, {}, none, false, false, &salt};
    if (parsed && !quiet.has_errors()) id = expression(*parsed, scope);
  } catch (const Failure&) {
    id = none;
  }
  const VariableBinding& variable = *program_.variables[slots.front()].binding;
  if (id == none && holds_number(variable)) {
    Diagnostic d;
    d.text = "--set " + full + "=" + value + ": '" + full + "' is a number";
    d.notes.push_back({"given here", variable.syntax->name.at});
    d.help = number_help(value);
    return diagnostics_.add(std::move(d));
  }
  if (id == none)
    id = constant(Value::of(std::string_view(program_.texts.emplace_back(value))), all);
  for (const uint32_t slot : slots) {
    program_.variables[slot].value = id;
    program_.variables[slot].from_command_line = true;
  }
}

}  // namespace mansard
