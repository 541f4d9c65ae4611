// --set NAME=VALUE.
#include "interpreter/compiler.hpp"

namespace mansard {

void Compiler::apply_settings() {
  for (const auto& [name, value] : options_.settings) apply_setting(name, value);
}

/// --set Block.Name=v or Style::Block.Name=v; a bare word is a string.
void Compiler::apply_setting(const std::string& full, const std::string& value) {
  std::string style, name = full;
  if (const auto colons = full.find("::"); colons != std::string::npos) {
    style = full.substr(0, colons);
    name = full.substr(colons + 2);
  }
  std::vector<uint32_t> slots;
  std::vector<std::string_view> names;
  for (uint32_t i = 0; i < program_.variables.size(); ++i)
    names.push_back(program_.variables[i].name);
  for (const auto& [key, slot] : variable_slots_) {
    if (key.second == name && (style.empty() || program_.styles[key.first].name == style))
      slots.push_back(slot);
  }
  if (slots.empty()) {
    Diagnostic d;
    d.text = "--set " + full + ": no variable of that name";
    d.help = meant(name, names);
    return diagnostics_.add(std::move(d));
  }
  const Source& source = library_.sources().add("--set " + full, value);
  Diagnostics quiet;
  const syntax::ExprPtr parsed = parse_expression(source, quiet);
  const Span all{&source, 0, static_cast<uint32_t>(value.size())};
  uint16_t salt = 0;
  ExprId id = none;
  try {
    NameScope scope{program_.main_style, {}, {}, none, false, false, &salt};
    if (parsed) id = expression(*parsed, scope);
  } catch (const Failure&) {
    id = none;
  }
  if (id == none)
    id = constant(Value::of(std::string_view(program_.texts.emplace_back(value))), all);
  for (const uint32_t slot : slots) {
    program_.variables[slot].value = id;
    program_.variables[slot].from_command_line = true;
  }
}

}  // namespace mansard
