#include <algorithm>

#include "interpreter/compiler.hpp"
#include "interpreter/messages.hpp"
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

void refuse_style(const syntax::Name& name, std::span<const std::string_view> loaded) {
  const std::string help = meant(name.text, loaded);
  refuse(name.at, "no style '" + std::string(name.text) + "' is loaded",
         help.empty() ? "import the file that has it" : help);
}

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
  if (!number) return false;
  program_.main_style = *number;
  if (options_.all_styles) {
    reach_all();
  } else {
    warn_no_start(program_.styles[*number], *main);
  }
  compile_pending();
  apply_settings();
  compile_pending();  // a setting can name a style that nothing else does
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
  return !diagnostics_.has_errors();
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
    diagnostics_.add(std::move(d));
    return nullptr;
  }
  if (library_.default_style()) return library_.default_style();
  if (!diagnostics_.has_errors()) {
    Diagnostic d;
    d.text = "there is no style in this file";
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
  auto linked = link(library_, *syntax, diagnostics_);
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

/// Every style that can be derived; one that waits for a child to complete it can not.
void Compiler::reach_all() {
  for (const syntax::Style* style : library_.styles()) {
    style_number(style->name.text, Reach::any);
  }
}

void Compiler::declare_rules(uint16_t number) {
  CompiledStyle& style = program_.styles[number];
  for (const SymbolRules& symbol : style.linked->symbols) {
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
    FunctionSlot slot;
    slot.parameters = static_cast<uint8_t>(binding.syntax->params.size());
    program_.functions.push_back(slot);
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
    if (!text) refuse(a.at, "@per takes \"shape\", \"building\" or the name of a symbol");
    if (text->value == "building") continue;
    slot.per = text->value == "shape" ? VariableSlot::Per::shape : VariableSlot::Per::symbol;
    if (slot.per == VariableSlot::Per::symbol)
      slot.per_symbol = program_.symbols.intern(text->value);
  }
}

void Compiler::compile_rules(uint16_t number) {
  // Indices, not references: compiling a rule may reach another style and grow the tables.
  std::vector<uint32_t> sets;
  for (const uint32_t top : program_.styles[number].rules) {
    for (uint32_t s = top; s != none; s = program_.rule_sets[s].super) sets.push_back(s);
  }
  for (const uint32_t s : sets) {
    const RuleSet set = program_.rule_sets[s];
    bool tests = false;
    for (uint32_t i = 0; i < set.count; ++i) {
      Production production = program_.productions[set.first + i];
      const std::string_view block = production.from.block ? production.from.block->name.text : "";
      attempt(number, block, [&] {
        if (i == most_productions) {
          refuse(production.syntax->head,
                 "a symbol has " + std::to_string(most_productions) + " productions at most");
        }
        compile_production(production, number);
      });
      tests = tests || production.index_test != none;
      program_.productions[set.first + i] = production;
    }
    const Production& only = program_.productions[set.first];
    program_.rule_sets[s].tests_index = tests;
    program_.rule_sets[s].always = set.count == 1 && only.guard == none && !tests;
  }
}

void Compiler::compile_production(Production& p, uint16_t style) {
  const syntax::Rule& rule = *p.syntax;
  for (const syntax::Annotation& a : rule.pre.annotations) {
    if (a.name.text == "stage") refuse(a.at, "@stage comes with a later version of Mansard");
  }
  uint16_t salt = 1;
  NameScope scope;
  scope.style = style;
  scope.block = p.from.block ? p.from.block->name.text : std::string_view{};
  scope.salt = &salt;
  for (const syntax::Name& name : rule.params) scope.parameters.push_back(name.text);
  if (rule.index) {
    const auto* name = std::get_if<syntax::Reference>(&rule.index->is);
    if (name && name->names.size() == 1 && !name->style) {
      p.index_parameter = static_cast<uint8_t>(scope.parameters.size());
      scope.parameters.push_back(name->names[0].text);
    } else {
      p.index_test = expression(*rule.index, scope);
    }
  }
  p.is_else = rule.guard_else;
  const std::size_t failures = failures_;
  p.body = body(rule.successor, scope);
  if (rule.guard) {
    scope.in_guard = true;
    scope.body_failed = failures_ > failures;
    scope.fits_call = first_split(p.body);
    p.guard = expression(*rule.guard, scope);
    scope.in_guard = false;
  }
  if (rule.probability) p.probability = expression(*rule.probability, scope);
}

void Compiler::warn_unguarded(uint16_t number) {
  const CompiledStyle& style = program_.styles[number];
  for (const uint32_t top : style.rules) {
    if (top == none) continue;
    const RuleSet& set = program_.rule_sets[top];
    const auto* first = &program_.productions[set.first];
    const bool open = std::all_of(first, first + set.count, [](const Production& p) {
      return p.guard != none && !(p.is_else && !p.syntax->guard);
    });
    if (!open) continue;
    Diagnostic d;
    d.severity = Severity::warning;
    d.code = "W002";
    d.at = first[set.count - 1].syntax->head;
    d.text = "'" + std::string(first->syntax->name.text) +
             "' has only productions with conditions: where none holds the shape stays as it is";
    d.help = "add a production with ': else'";
    diagnostics_.add(std::move(d));
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

void Compiler::add_failure(Failure& failure, uint16_t style, std::string_view block) {
  ++failures_;
  Diagnostic& d = failure.diagnostic;
  const std::string of = "style '" + std::string(program_.styles[style].name) + "'";
  d.notes.push_back({block.empty() ? "while checking " + of
                                   : "while checking block '" + std::string(block) + "' of " + of,
                     {}});
  // The same words of a parent are wrong in every child: once is enough.
  for (const Diagnostic& known : diagnostics_.all()) {
    if (known.at == d.at && known.text == d.text) return;
  }
  diagnostics_.add(std::move(d));
}

}  // namespace mansard
