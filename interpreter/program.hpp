// Styles compiled for derivation: names are numbers, expressions flat nodes, rules flat tables. All
// of inheritance and name resolution is done; what is left is arithmetic and geometry.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "geometry/mesh.hpp"
#include "interpreter/material.hpp"
#include "interpreter/names.hpp"
#include "interpreter/value.hpp"
#include "styles/style.hpp"

namespace mansard {

struct Operation;
struct Function;

using ExprId = uint32_t;
using BodyId = uint32_t;
inline constexpr uint32_t none = 0xffffffff;

enum class ExprKind : uint8_t {
  constant,   ///< first: number in constants
  attribute,  ///< aux: Attribute
  parameter,  ///< aux: which
  variable,   ///< first: slot
  property,   ///< first: property slot, child 0: default
  input,      ///< aux: Input
  fits,       ///< first: split call
  list,
  subscript,
  negate,
  invert,
  add,
  subtract,
  multiply,
  divide,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  unequal,
  and_,
  or_,
  conditional,
  call,        ///< aux: row of the function table
  definition,  ///< first: slot of a `def`; children are the arguments
};

enum class Attribute : uint8_t {
  width,
  height,
  depth,
  tx,
  ty,
  tz,
  area,
  volume,
  perimeter,
  inradius,
  edges,
  is_rectangle,
  is_convex,
  is_planar,
  facing,
  slope,
  elevation,
  split_index,
  split_count,
  split_round,
  comp_index,
  comp_count,
  comp_name,
  corner_left,
  corner_right,
  level,
  index,
  symbol,
  seed
};
enum class Input : uint8_t { height, levels, name, use };

struct ExprNode {
  ExprKind kind = ExprKind::constant;
  uint8_t aux = 0;
  uint16_t salt = 0;  ///< place among the random calls of its rule or variable
  uint32_t first = 0;
  uint32_t children = 0;  ///< first in Program::children
  uint32_t count = 0;
};

/// `value` with what kind of size it is; an absent one has no value.
struct SizeExpr {
  syntax::SizeKind kind = syntax::SizeKind::absolute;
  ExprId value = none;
};

enum class StepKind : uint8_t { emit, emit_value, operation, push, super, branch };

/// One element of a successor.
struct Step {
  StepKind kind = StepKind::emit;
  uint16_t style = 0xffff;  ///< of `Other::SYMBOL`; 0xffff: the current
  uint32_t what = 0;        ///< symbol, call, body, branch, or the expression that gives the symbol
  ExprId style_of = none;   ///< style(expr)::
  ExprId index = none;
  uint32_t arguments = 0;  ///< first in Program::arguments
  uint32_t argument_count = 0;
  Span at;
};

struct Body {
  uint32_t first = 0, count = 0;  ///< in Program::steps
};

struct BranchArm {
  ExprId condition = none;  ///< none: else
  BodyId body = 0;
};
struct Branch {
  std::vector<BranchArm> arms;
};

struct CallPart {
  uint32_t name = none;  ///< label as a name (symbol number), or
  SizeExpr size;         ///< label as a size or a number
  bool labelled = false;
  BodyId body = 0;
  std::vector<CallPart> group;  ///< of a repeated group
  uint64_t stream = 0;          ///< of what it emits, where a size of the split is ':'
  Span at;
};

/// An operation as a rule wrote it.
struct Call {
  const Operation* operation = nullptr;
  std::vector<SizeExpr> args;  ///< one a parameter, absent ones without value; rest behind
  std::vector<CallPart> parts;
  std::vector<uint32_t> part_of;  ///< for operations with named parts: which of `parts`, or none
  bool has_parts = false;
  bool starred = false;
  bool measures = false;      ///< a size is ':'
  bool parts_repeat = false;  ///< several pieces may come to one part
  uint64_t salt = 0;
  uint32_t setting = none;  ///< for set(): variable slot key
  Span at, args_at, parts_at;
};

struct Production {
  ExprId guard = none;
  bool is_else = false;
  bool asks_fits = false;   ///< its condition does
  bool joins_else = false;  ///< same `else` as the production before it: they are alternatives
  ExprId index_test = none;
  ExprId probability = none;
  BodyId body = 0;
  uint8_t index_parameter = 0xff;  ///< parameter that binds the index
  std::optional<uint16_t> stage;   ///< @stage
  const syntax::Rule* syntax = nullptr;
  Origin from;
};

/// Groups are asked when all that waits for stage 1 has been derived, so that nobody is missing.
inline constexpr uint16_t usual_stage = 1, group_stage = 2, last_stage = 1000;

struct RuleSet {
  uint32_t first = 0, count = 0;  ///< in Program::productions
  uint32_t super = none;          ///< rule set that `super` means
  uint8_t parameters = 0;
  bool tests_index = false;
  bool always = false;  ///< one production without conditions
  bool waits = false;   ///< it asks about other shapes, or has a stage
  uint16_t stage = usual_stage;
};

struct VariableSlot {
  ExprId value = none;
  bool reads_shape = false;
  bool settable = false;  ///< some rule says set() for it
  uint64_t salt = 0;      ///< of its own random stream
  enum class Per : uint8_t { building, shape, symbol } per = Per::building;
  uint32_t per_symbol = none;
  uint32_t setting = none;  ///< key under which set() stores it
  std::string name;         ///< "Block.Name" or "Name"
  const VariableBinding* binding = nullptr;
  bool from_command_line = false;
};

struct FunctionSlot {
  ExprId value = none;
  uint8_t parameters = 0;
  std::string name;  ///< "Block.name" or "name"
  const FunctionBinding* binding = nullptr;
};

/// Alternatives of an element or a material with their running weights.
struct ElementTable {
  struct Choice {
    std::vector<const Mesh*>
        meshes;  ///< by level of detail, nearest first; null: could not be read
    std::vector<std::vector<uint32_t>>
        materials;  ///< the program's numbers of each mesh's own materials
    double weight = 1;
  };
  std::vector<Choice> choices;
  double total = 0;
};
struct MaterialTable {
  std::vector<uint32_t> materials;
  std::vector<double> weights;
  double total = 0;
  VariableSlot::Per per = VariableSlot::Per::shape;
  uint32_t per_symbol = none;
  uint64_t salt = 0;
};

struct CompiledStyle {
  std::string_view name;
  const LinkedStyle* linked = nullptr;
  uint32_t start = 0;
  std::vector<uint32_t> rules;      ///< by symbol: rule set or none
  std::vector<uint32_t> elements;   ///< by symbol: element table or none
  std::vector<uint32_t> materials;  ///< by symbol: material table or none
  std::vector<bool> placeable;      ///< by symbol; see placeable.hpp
};

struct Program {
  Program();
  ~Program();

  std::vector<std::string> mesh_folders;  ///< where insert() and texture() look after the script's
                                          ///< own folder
  Names symbols;                          ///< also names of parts
  Names properties;                       ///< names that attr() and variables read
  std::vector<uint64_t> symbol_hashes;

  std::vector<CompiledStyle> styles;
  std::unordered_map<std::string_view, uint16_t> style_numbers;
  uint16_t main_style = 0;

  std::vector<ExprNode> nodes;
  std::vector<uint32_t> children;
  std::vector<Span> spans;       ///< one a node
  std::vector<uint16_t> depths;  ///< one a node: levels of nodes below and with it
  std::vector<Value> constants;
  std::deque<std::string> texts;  ///< owned by constants
  std::deque<std::vector<Value>> lists;

  std::vector<Body> bodies;
  std::vector<Step> steps;
  std::vector<ExprId> arguments;
  std::vector<Branch> branches;
  std::deque<Call> calls;

  std::vector<RuleSet> rule_sets;
  std::vector<Production> productions;
  std::vector<VariableSlot> variables;
  std::vector<FunctionSlot> functions;
  std::vector<ElementTable> element_tables;
  std::vector<MaterialTable> material_tables;
  std::vector<Material> materials;  ///< [0] is the plain one
  std::unordered_map<std::string, std::vector<uint32_t>> variables_by_property;  ///< slots
  std::deque<LinkedStyle> linked;
  // ---- of stains; `none` and empty when no rule asks for them
  uint32_t stain_look = none;        ///< in materials
  uint32_t stain_symbol = none;      ///< of what they draw
  std::vector<uint8_t> sheds_rain;   ///< by symbol: a sill or a ledge by its name
  std::vector<uint8_t> stays_clean;  ///< by symbol: glass, a door
  bool asks = false;                 ///< some rule asks about other shapes
  bool reads_corners = false;        ///< corner.left or corner.right
  bool snaps = false;                ///< some split snaps, which asks, too

  /// Where a value was written, in a script or on the command line; nowhere when it was computed.
  Span origin(const Value& value) const;
};

inline constexpr uint32_t nil_symbol = 0;
/// Of one symbol in one style.
inline constexpr uint32_t most_productions = 256;

/// Meshes of elements and insert(), read once, and pictures of textures. Implemented where files of
/// models may be touched.
class MeshSource {
 public:
  virtual ~MeshSource() = default;
  /// Null when it can not be read; `problem` says why. Safe to call from several threads. The mesh
  /// lives as long as the source.
  virtual const Mesh* mesh(const std::string& path, std::string& problem) = 0;
  /// Whether there is such a file to texture with. Safe to call from several threads.
  virtual bool has_picture(const std::string& path) = 0;
  /// Why a picture that is there can not be used, in a few words; empty when it can. Safe to call
  /// from several threads.
  virtual std::string picture_problem(const std::string&) { return {}; }
};

/// For work that draws nothing: no mesh can be read, every picture is there.
class NoMeshes final : public MeshSource {
 public:
  const Mesh* mesh(const std::string&, std::string& problem) override {
    problem = "no meshes here";
    return nullptr;
  }
  bool has_picture(const std::string&) override { return true; }
};

struct CompileOptions {
  std::vector<std::pair<std::string, std::string>> settings;  ///< --set NAME=VALUE
  std::string style;          ///< --style; empty: the last of the file
  bool all_styles = false;    ///< check every style of the library, not only those that are reached
  bool abstract_too = false;  ///< the style may be one that waits for a child to complete it
};

/// Links and compiles the style and all it can reach. Errors and warnings go to `diagnostics`; null
/// when there were errors. The library and the mesh source must outlive the program.
std::unique_ptr<Program> compile(Library& library, MeshSource& meshes,
                                 const CompileOptions& options, Diagnostics& diagnostics);

}  // namespace mansard
