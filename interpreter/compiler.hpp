// From linked styles to a program. Private to the interpreter.
#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "interpreter/function.hpp"
#include "interpreter/operation.hpp"
#include "interpreter/program.hpp"

namespace mansard {

class VariableGraph;

/// What names mean where an expression stands.
struct NameScope {
  uint16_t style = 0;
  std::string_view block;  ///< empty: style-wide
  std::vector<std::string_view> parameters;
  uint32_t fits_call = none;  ///< split that `fits` asks about
  bool in_guard = false;
  bool symbols = false;      ///< a bare unknown name in capitals is a symbol
  uint16_t* salt = nullptr;  ///< counts random calls
  bool body_failed = false;  ///< so `fits` may ask about a split that is not known
  bool asked_fits = false;   ///< `fits` stands in the guard
  bool in_function = false;  ///< of a `def` with parameters
};

class Compiler {
 public:
  Compiler(Program& program, Library& library, MeshSource& meshes, const CompileOptions& options,
           Diagnostics& diagnostics);

  /// False when there were errors.
  bool run();

 private:
  // compile.cpp
  const syntax::Style* main_style();
  /// Styles reached by any name are passed over while something abstract is missing.
  enum class Reach : uint8_t { named, any };
  std::optional<uint16_t> style_number(std::string_view name, Reach reach = Reach::named);
  void compile_pending();
  void check_start(const CompiledStyle& style);
  void reach_all();
  void compile_style(uint16_t number);
  void declare_rules(uint16_t style);
  void declare_variables(uint16_t style);
  void check_rule_name(uint16_t style, const SymbolRules& symbol);
  void check_function_name(uint16_t style, const FunctionBinding& binding);
  bool is_checked(Span at) const;
  void compile_variables(uint16_t style);
  void compile_functions(uint16_t style);
  void compile_rules(uint16_t style);
  void compile_production(Production& production, uint16_t style);
  void per_of(const syntax::Preamble& pre, VariableSlot& slot);
  void apply_settings();
  void apply_setting(const std::string& name, const std::string& value);
  Diagnostic unknown_setting(const std::string& full, std::string_view style,
                             std::string_view name) const;
  void warn_unguarded(uint16_t style);
  void warn_no_start(const CompiledStyle& style, const syntax::Style& main);

  // symbols.cpp
  void collect_symbols();
  void collect(const syntax::Body& body);

  // compile_expression.cpp
  ExprId expression(const syntax::Expr& expr, NameScope& scope);
  ExprId node(ExprKind kind, Span at, std::vector<ExprId> children = {}, uint32_t first = 0,
              uint8_t aux = 0);
  ExprId constant(Value value, Span at);
  ExprId chain(const syntax::Chain& chain, Span at, NameScope& scope);
  ExprId reference(const syntax::Reference& reference, Span at, NameScope& scope);
  ExprId symbol_elsewhere(const syntax::Reference& reference, Span at);
  [[noreturn]] static void refuse_elsewhere(const syntax::Reference& reference, Span at,
                                            std::string_view what);
  ExprId plain_name(const syntax::Name& name, NameScope& scope);
  ExprId dotted_name(const syntax::Reference& reference, Span at, NameScope& scope);
  ExprId call(const syntax::Call& call, Span at, NameScope& scope);
  ExprId function_call(const Function& function, const syntax::Call& call, Span at,
                       NameScope& scope);
  ExprId question(const syntax::Call& call, Span at, NameScope& scope);
  ExprId group_question(const syntax::Call& call, Span at, NameScope& scope);
  ExprId attribute_call(const syntax::Call& call, Span at, NameScope& scope);
  ExprId plain_argument(const syntax::Arg& arg, NameScope& scope);
  uint32_t variable_slot(uint16_t style, std::string_view block, std::string_view name) const;
  [[noreturn]] void unknown_name(const syntax::Name& name, const NameScope& scope);
  bool looks_like_symbol(std::string_view name) const;

  // compile_body.cpp
  BodyId body(const syntax::Body& body, NameScope& scope);
  void element(const syntax::Element& element, NameScope& scope, std::vector<Step>& steps);
  void emit(const syntax::Emit& emit, Span at, NameScope& scope, std::vector<Step>& steps);
  void emit_symbol(const syntax::Emit& emit, Span at, NameScope& scope, std::vector<Step>& steps);
  void emit_elsewhere(const syntax::Emit& emit, Span at, NameScope& scope,
                      std::vector<Step>& steps);
  void arguments(const syntax::Emit& emit, NameScope& scope, Step& step);
  void branch(const syntax::If& chain, Span at, NameScope& scope, std::vector<Step>& steps);
  [[noreturn]] void not_an_operation(const syntax::Emit& emit, uint16_t style);

  // compile_call.cpp
  uint32_t operation_call(const Operation& operation, const syntax::Emit& emit, Span at,
                          NameScope& scope);
  void call_arguments(Call& call, const syntax::Emit& emit, NameScope& scope);
  std::size_t argument_place(const Operation& operation, const syntax::Arg& arg,
                             std::size_t position);
  SizeExpr size_argument(const Operation& operation, std::size_t place, const syntax::Arg& arg,
                         NameScope& scope);
  SizeExpr unmeasured(Span at);
  bool name_streams(std::vector<CallPart>& parts);
  uint64_t first_symbol(BodyId body) const;
  void refuse_compared_name(const Operation& operation, const syntax::Arg& arg,
                            const NameScope& scope);
  void setting_argument(Call& call, const syntax::Arg& arg, NameScope& scope);
  void call_parts(Call& call, const syntax::Emit& emit, NameScope& scope);
  CallPart call_part(const Operation& operation, const syntax::Part& part, NameScope& scope);
  void part_label(const Operation& operation, const syntax::Part& part, CallPart& out,
                  NameScope& scope);
  void name_parts(Call& call, const syntax::Emit& emit);
  void check_part_count(const Call& call, const syntax::Emit& emit);
  uint32_t first_split(BodyId body) const;

  // compile_looks.cpp
  void compile_elements(uint16_t style);
  void compile_materials(uint16_t style);
  const Mesh* element_mesh(const std::string& path, Span at);
  void element_choice(const ElementChoice& alternative, ElementTable& table);
  double weight(const syntax::ExprPtr& weight, uint16_t style);
  uint32_t material_number(const MaterialChoice& choice, std::string_view symbol);

  // compile_surface.cpp
  /// The path of a texture's picture; empty, and a warning, when it can not be used.
  std::string picture(std::string_view file, Span at);
  Material material_of(const syntax::MaterialAlternative& alternative, std::string name);
  const Value& literal(const syntax::Arg& arg);

  // variable_order.cpp
  void find_shape_readers();
  void refuse_ring(const VariableGraph& graph, uint32_t slot);

  // questions.cpp
  void intern_texts();
  void find_waiting();
  void find_placeable();
  void check_questions();
  void check_question(ExprId id, std::span<const std::string_view> labels);
  void check_cover_word(const ExprNode& comparison);
  // check_groups.cpp
  void check_group(ExprId id);
  void check_outcome(ExprId id);
  void check_symbol_word(ExprId id, std::string_view what);
  std::optional<uint16_t> stage_of(const syntax::Rule& rule);
  [[noreturn]] void refuse_two_stages(const RuleSet& set, uint16_t stage,
                                      const Production& production) const;

  // compile_snapping.cpp
  std::vector<bool> snapping_calls() const;
  void check_snapping();
  void check_planes(const Call& call);
  void check_axis_word(const Call& call);
  void check_snap_options(const Call& call);
  void check_snap_label(const Call& call, std::span<const std::string_view> labels);
  const Value* constant_value(ExprId id) const;
  std::optional<std::string_view> constant_text(ExprId id) const;

  // check_constants.cpp
  void check_constants();
  void check_axis(const Call& call);
  void check_roof(const Call& call);
  void check_rivals(const Call& call, std::string_view one, std::string_view other);
  void check_roof_kind(const Call& call);
  void check_dormer_kind(const Call& call);
  void check_components(const Call& call, const std::vector<CallPart>& parts);
  void check_symbols_of_draws(const CompiledStyle& style);
  void check_style_named(ExprId id);
  void check_index(ExprId id) const;
  void warn_of_style(const Value& name);
  void warn_of_styles(ExprId id, int levels);
  std::string style_meant(std::string_view name, Span at) const;
  [[noreturn]] void refuse_style(const syntax::Name& name) const;
  std::optional<double> constant_number(ExprId id) const;

  // analyse.cpp
  void mark_settable();
  std::vector<bool> conditional_nodes() const;
  void fold_constants();
  void check_types();
  std::optional<Type> static_type(ExprId id) const;
  std::optional<Type> static_type_of_node(ExprId id) const;
  void check_call_types(const Call& call);
  void check_setting_type(const Call& call);
  std::optional<Type> declared_type(ExprId id) const;
  void add_writer(Diagnostic& d, ExprId id) const;
  void check_sizes(const Call& call);
  void check_picture(const Call& call);
  void check_material(const Call& call);
  void prepare_stains();
  void check_stain(const Call& call);

  /// Runs f; a Failure becomes a diagnostic with a note of where we are.
  template <class F>
  void attempt(uint16_t style, std::string_view block, F f);
  /// The same where no style is at hand: the note names the one that the error stands in.
  template <class F>
  void attempt_anywhere(F f);
  void add_failure(Failure& failure, std::optional<uint16_t> style, std::string_view block);
  std::string_view style_at(Span at) const;

  Program& program_;
  Library& library_;
  MeshSource& meshes_;
  const CompileOptions& options_;
  Diagnostics& diagnostics_;
  std::set<std::string_view> known_symbols_;
  std::map<std::pair<uint16_t, std::string>, uint32_t> variable_slots_, function_slots_;
  std::map<const syntax::MaterialAlternative*, uint32_t> material_numbers_;
  std::map<std::string, uint32_t> setting_keys_;
  std::set<uint32_t> set_somewhere_;
  std::size_t failures_ = 0;  ///< told or not
  std::vector<uint16_t> pending_;
  mutable std::unordered_map<uint32_t, std::optional<Type>> static_types_;  ///< by variable
  int rings_ = 0;  ///< of variables, that were complained of
};

/// What a node that is a call asks by itself.
Asks asked_by(const ExprNode& node);
bool is_question(const ExprNode& node);
/// Questions that a later version brings.
[[noreturn]] void refuse_later(Span at);
[[noreturn]] void refuse(Span at, std::string text, std::string help = {},
                         std::vector<Note> notes = {});
/// No style of this name is among those that are loaded.
std::string qualified(std::string_view block, std::string_view name);
/// "did you mean 'x'?" or nothing.
std::string meant(std::string_view word, std::span<const std::string_view> candidates);

template <class F>
void Compiler::attempt_anywhere(F f) {
  try {
    f();
  } catch (Failure& failure) {
    add_failure(failure, std::nullopt, {});
  }
}

template <class F>
void Compiler::attempt(uint16_t style, std::string_view block, F f) {
  try {
    f();
  } catch (Failure& failure) {
    add_failure(failure, style, block);
  }
}

}  // namespace mansard
