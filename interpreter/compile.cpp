#include <algorithm>

#include "interpreter/compiler.hpp"
#include "interpreter/lint.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/placeable.hpp"
#include "interpreter/random.hpp"
#include "interpreter/selectors.hpp"

namespace mansard {

std::unique_ptr<Program> compile(Library& library, MeshSource& meshes,
                                 const CompileOptions& options, Diagnostics& diagnostics) {
  auto program = std::make_unique<Program>();
  Compiler compiler(*program, library, meshes, options, diagnostics);
  if (!compiler.run()) return nullptr;
  return program;
}

void refuse(Span at, std::string text, std::string help, std::vector<Note> notes) {
  Diagnostic d;
  d.at = at;
  d.text = std::move(text);
  d.help = std::move(help);
  d.notes = std::move(notes);
  throw Failure(std::move(d));
}

std::string qualified(std::string_view block, std::string_view name) {
  return block.empty() ? std::string(name) : std::string(block) + "." + std::string(name);
}

std::string meant(std::string_view word, std::span<const std::string_view> candidates) {
  const auto near = nearest(word, candidates);
  return near ? "did you mean '" + std::string(*near) + "'?" : std::string();
}

namespace {

/// "A, B, C", no more than twenty of them.
std::string listed_names(std::span<const std::string_view> names) {
  constexpr std::size_t most = 20;
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < most; ++i) {
    text += (i == 0 ? "" : ", ") + std::string(names[i]);
  }
  return names.size() > most ? text + ", ..." : text;
}

}  // namespace

Compiler::Compiler(Program& program, Library& library, MeshSource& meshes,
                   const CompileOptions& options, Diagnostics& diagnostics)
    : program_(program),
      library_(library),
      meshes_(meshes),
      options_(options),
      diagnostics_(diagnostics) {
  program_.mesh_folders = library_.style_path();
  program_.symbols.intern("NIL");
  for (const std::string_view word : selector_words) program_.symbols.intern(word);
  program_.materials.push_back({"plain", {0.8, 0.8, 0.8}, 1, {}, {1, 1}});
}

bool Compiler::run() {
  collect_symbols();
  const syntax::Style* const main = main_style();
  if (!main) return false;
  const auto number = style_number(main->name.text);
  if (!number) {
    if (options_.all_styles) reach_all();  // what is wrong with the others is said, too
    return false;
  }
  program_.main_style = *number;
  if (options_.all_styles) {
    reach_all();
  } else {
    warn_no_start(program_.styles[*number], *main);
  }
  compile_pending();
  apply_settings();
  compile_pending();  // a setting can name a style that nothing else does
  intern_texts();
  prepare_stains();
  for (CompiledStyle& style : program_.styles) {
    style.rules.resize(program_.symbols.size(), none);
    style.elements.resize(program_.symbols.size(), none);
    style.materials.resize(program_.symbols.size(), none);
  }
  for (uint32_t i = 0; i < program_.symbols.size(); ++i) {
    program_.symbol_hashes.push_back(hash_of(program_.symbols[i]));
  }
  mark_settable();
  const std::size_t errors = diagnostics_.errors();
  find_shape_readers();
  if (diagnostics_.errors() > errors) return false;  // variables in a ring have no type
  fold_constants();
  check_types();
  check_constants();
  check_questions();
  check_snapping();
  if (diagnostics_.has_errors()) return false;  // what was refused has no body to look through
  find_waiting();
  if (diagnostics_.has_errors()) return false;
  find_placeable();
  if (options_.all_styles && library_.main_file()) {
    lint(program_, *library_.main_file(), diagnostics_);
  }
  return true;
}

void Compiler::find_placeable() {
  std::vector<std::vector<bool>> placeable = placeable_symbols(program_);
  for (std::size_t i = 0; i < placeable.size(); ++i) {
    program_.styles[i].placeable = std::move(placeable[i]);
  }
}

void Compiler::compile_pending() {
  while (!pending_.empty()) {
    const uint16_t next = pending_.back();
    pending_.pop_back();
    compile_style(next);
  }
}

const syntax::Style* Compiler::main_style() {
  if (!options_.style.empty()) {
    if (const syntax::Style* found = library_.find(options_.style)) return found;
    std::vector<std::string_view> names;
    for (const syntax::Style* s : library_.styles()) names.push_back(s->name.text);
    Diagnostic d;
    d.text = "no style '" + options_.style + "' in this file";
    d.help = meant(options_.style, names);
    if (d.help.empty() && !names.empty()) d.help = "there are " + listed_names(names);
    diagnostics_.add(std::move(d));
    return nullptr;
  }
  if (library_.default_style()) return library_.default_style();
  if (!diagnostics_.has_errors()) {
    Diagnostic d;
    const syntax::File* const file = library_.main_file();
    d.text = "there is no style in " + (file ? "'" + file->source->name() + "'" : "this file");
    d.help = "begin with: style Name { ... }";
    diagnostics_.add(std::move(d));
  }
  return nullptr;
}

std::optional<uint16_t> Compiler::style_number(std::string_view name, Reach reach) {
  if (const auto it = program_.style_numbers.find(name); it != program_.style_numbers.end())
    return it->second;
  const syntax::Style* const syntax = library_.find(name);
  if (!syntax) return std::nullopt;
  Diagnostics found;
  auto linked = link(library_, *syntax, found);
  for (const Diagnostic& d : found.all()) {
    if (d.severity == Severity::error || is_checked(d.at)) diagnostics_.add(d);
  }
  if (!linked) return std::nullopt;
  const bool incomplete = !linked->missing.empty() && !options_.all_styles;
  if (incomplete && reach == Reach::any) return std::nullopt;
  const auto number = static_cast<uint16_t>(program_.styles.size());
  const LinkedStyle& kept = program_.linked.emplace_back(std::move(*linked));
  CompiledStyle& style = program_.styles.emplace_back();
  style.name = syntax->name.text;
  style.linked = &kept;
  style.start = program_.symbols.intern(kept.start);
  program_.style_numbers.emplace(style.name, number);
  for (const Diagnostic& missing : kept.missing) {
    // check and explain are content with abstract styles
    if (!options_.all_styles && !options_.abstract_too) diagnostics_.add(missing);
  }
  pending_.push_back(number);
  declare_rules(number);
  declare_variables(number);
  return number;
}

/// Warnings of a check speak of the script that is checked, not of what it imports.
bool Compiler::is_checked(Span at) const {
  const syntax::File* const file = library_.main_file();
  return !options_.all_styles || !file || !at || at.source == file->source;
}

/// Every style that can be derived; one that waits for a child to complete it can not.
void Compiler::reach_all() {
  for (const syntax::Style* style : library_.styles()) {
    style_number(style->name.text, Reach::any);
  }
}

void Compiler::declare_rules(uint16_t number) {
  CompiledStyle& style = program_.styles[number];
  for (const SymbolRules& symbol : style.linked->symbols) {
    check_rule_name(number, symbol);
    const uint32_t id = program_.symbols.intern(symbol.name);
    if (style.rules.size() <= id) style.rules.resize(id + 1, none);
    uint32_t next = none;
    for (auto g = symbol.generations.rbegin(); g != symbol.generations.rend(); ++g) {
      RuleSet set;
      set.first = static_cast<uint32_t>(program_.productions.size());
      set.count = static_cast<uint32_t>(g->productions.size());
      set.super = next;
      set.parameters = static_cast<uint8_t>(g->productions[0]->params.size());
      for (std::size_t i = 0; i < g->productions.size(); ++i) {
        Production p;
        p.syntax = g->productions[i];
        p.from = g->origins[i];
        program_.productions.push_back(p);
      }
      next = static_cast<uint32_t>(program_.rule_sets.size());
      program_.rule_sets.push_back(set);
    }
    style.rules[id] = next;
  }
}

void Compiler::declare_variables(uint16_t number) {
  const LinkedStyle& linked = *program_.styles[number].linked;
  for (const VariableBinding& binding : linked.variables) {
    VariableSlot slot;
    slot.name = qualified(binding.block, binding.name);
    slot.binding = &binding;
    slot.salt = hash_of(slot.name);
    const auto id = static_cast<uint32_t>(program_.variables.size());
    variable_slots_[{number, slot.name}] = id;
    program_.properties.intern(slot.name);
    program_.variables_by_property[slot.name].push_back(id);
    slot.setting =
        setting_keys_.emplace(slot.name, static_cast<uint32_t>(setting_keys_.size())).first->second;
    program_.variables.push_back(std::move(slot));
  }
  for (const FunctionBinding& binding : linked.functions) {
    function_slots_[{number, qualified(binding.block, binding.name)}] =
        static_cast<uint32_t>(program_.functions.size());
    check_function_name(number, binding);
    FunctionSlot slot;
    slot.parameters = static_cast<uint8_t>(binding.syntax->params.size());
    slot.name = qualified(binding.block, binding.name);
    slot.binding = &binding;
    program_.functions.push_back(std::move(slot));
  }
}

void Compiler::compile_style(uint16_t number) {
  attempt(number, {}, [&] { check_start(program_.styles[number]); });
  compile_functions(number);
  compile_variables(number);
  compile_rules(number);
  compile_elements(number);
  compile_materials(number);
  if (options_.all_styles) warn_unguarded(number);
}

void Compiler::check_start(const CompiledStyle& style) {
  const SymbolRules* const rules = style.linked->find_symbol(style.linked->start);
  if (!rules) return;
  const syntax::Rule& rule = *rules->generations[0].productions[0];
  if (rule.params.empty()) return;
  refuse(rule.head,
         "derivation begins at '" + std::string(rules->name) + "', so it can have no parameters",
         "let it emit a symbol that has them");
}

void Compiler::compile_functions(uint16_t number) {
  for (const FunctionBinding& binding : program_.styles[number].linked->functions) {
    attempt(number, binding.block, [&] {
      uint16_t salt = 0;
      NameScope scope{number, binding.block, {}, none, false, false, &salt};
      for (const syntax::Name& p : binding.syntax->params) scope.parameters.push_back(p.text);
      scope.in_function = !scope.parameters.empty();
      const uint32_t slot = function_slots_.at({number, qualified(binding.block, binding.name)});
      const ExprId value = expression(*binding.syntax->value, scope);
      program_.functions[slot].value = value;
    });
  }
}

void Compiler::compile_variables(uint16_t number) {
  for (const VariableBinding& binding : program_.styles[number].linked->variables) {
    const uint32_t slot = variable_slots_.at({number, qualified(binding.block, binding.name)});
    attempt(number, binding.block, [&] {
      per_of(binding.syntax->pre, program_.variables[slot]);
      uint16_t salt = 0;
      NameScope scope{number, binding.block, {}, none, false, true, &salt};
      const ExprId value = binding.syntax->value ? expression(*binding.syntax->value, scope)
                                                 : constant(Value::of(0.0), binding.syntax->at);
      program_.variables[slot].value = value;
    });
  }
}

/// @per("shape") or @per("SYMBOL").
void Compiler::per_of(const syntax::Preamble& pre, VariableSlot& slot) {
  for (const syntax::Annotation& a : pre.annotations) {
    if (a.name.text != "per") continue;
    const auto* text = a.args.size() == 1 && a.args[0].value.value
                           ? std::get_if<syntax::Text>(&a.args[0].value.value->is)
                           : nullptr;
    if (!text || text->value == "building") continue;  // linking has complained
    slot.per = text->value == "shape" ? VariableSlot::Per::shape : VariableSlot::Per::symbol;
    if (slot.per == VariableSlot::Per::symbol)
      slot.per_symbol = program_.symbols.intern(text->value);
  }
}

/// A style that is derived but leaves the footprint as it is; often its first symbol is misspelt.
void Compiler::warn_no_start(const CompiledStyle& style, const syntax::Style& main) {
  const LinkedStyle& linked = *style.linked;
  if (linked.find_symbol(linked.start)) return;
  std::vector<std::string_view> names;
  for (const SymbolRules& rules : linked.symbols) names.push_back(rules.name);
  Diagnostic d;
  d.severity = Severity::warning;
  d.code = "W005";
  d.at = main.name.at;
  d.text = "style '" + std::string(style.name) + "' has no rule for '" + std::string(linked.start) +
           "', with which derivation begins";
  d.help = meant(linked.start, names);
  diagnostics_.add(std::move(d));
}

/// The style whose text holds the place, else the one that is compiled.
std::string_view Compiler::style_at(Span at) const {
  for (const syntax::Style* style : library_.styles()) {
    const bool holds =
        at.source == style->at.source && style->at.begin <= at.begin && at.begin < style->at.end;
    if (at && holds) return style->name.text;
  }
  return program_.styles[program_.main_style].name;
}

void Compiler::add_failure(Failure& failure, std::optional<uint16_t> style,
                           std::string_view block) {
  ++failures_;
  Diagnostic& d = failure.diagnostic;
  const std::string of =
      "style '" + std::string(style ? program_.styles[*style].name : style_at(d.at)) + "'";
  d.notes.push_back({block.empty() ? "while checking " + of
                                   : "while checking block '" + std::string(block) + "' of " + of,
                     {}});
  diagnostics_.add(std::move(d));  // which drops what a parent's words did wrong before
}

}  // namespace mansard
