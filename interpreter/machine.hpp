// The derivation at work: the stack of shapes, the pools, the evaluation of expressions. Private to
// the interpreter; the rest of the house sees derivation.hpp.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "interpreter/building.hpp"
#include "interpreter/derivation.hpp"
#include "interpreter/group.hpp"
#include "interpreter/operation.hpp"
#include "interpreter/placer.hpp"
#include "interpreter/pool.hpp"
#include "interpreter/program.hpp"
#include "interpreter/random.hpp"
#include "interpreter/shape.hpp"
#include "interpreter/sizes.hpp"
#include "interpreter/snap_lines.hpp"
#include "interpreter/snap_planes.hpp"
#include "interpreter/uv_frame.hpp"
#include "interpreter/world.hpp"

namespace mansard {

/// What expressions are evaluated in.
struct Env {
  const Shape* shape = nullptr;       ///< null where no shape may be read
  const Value* parameters = nullptr;  ///< of the rule or function
  uint64_t draws = 0;                 ///< random stream
  const Scope* frame = nullptr;       ///< scope at the start of the rule or part, for center()
};

/// A polygon of the pool: coordinates run from 0 to `natural`; a scope of another size stretches
/// it.
struct PooledPolygon {
  Polygon polygon;
  Vec2 natural;
};

/// A mesh of the pool, its own or borrowed from the mesh source; `low` is its lowest corner.
struct PooledMesh {
  Mesh own;
  const Mesh* borrowed = nullptr;
  Vec3 low, natural;
  const Mesh& mesh() const { return borrowed ? *borrowed : own; }
};

/// A value given by set(), newest first.
struct SettingEntry {
  uint32_t setting;
  uint32_t next;
  Value value;
};

class Measurer;

class Machine {
 public:
  Machine(const Program& program, MeshSource& meshes, const DeriveOptions& options);
  ~Machine();

  void derive(const Footprint& footprint, Building& building);

  // ---- expressions (evaluate.cpp, variables.cpp)
  Value evaluate(ExprId expr, const Env& env);
  bool condition(ExprId expr, const Env& env);
  double number(ExprId expr, const Env& env);
  Value property(uint32_t slot, const Value& fallback, uint32_t node);
  Value variable(uint32_t slot, const Env& env, uint32_t node);
  Value input(Input which);
  bool fits(uint32_t call, const Env& env);
  double attribute_number(Attribute attribute, const Shape& shape);
  const Value* keep(std::span<const Value> values);
  std::string_view keep(std::string_view text);

  // ---- shapes
  /// An empty polygon of the pool, as the shape's geometry.
  PooledPolygon& new_polygon(Shape& shape);
  const PooledPolygon& polygon_of(const Shape& shape) const { return polygons_[shape.geometry]; }
  /// Takes polygon as the shape's geometry: the scope becomes its bounds within the old scope.
  void adopt(Shape& shape, Polygon&& polygon);
  /// Takes a mesh in the scope's coordinates as the shape's geometry, which becomes a solid.
  void adopt(Shape& shape, Mesh&& mesh);
  uint32_t add_mesh(Mesh&& mesh);
  uint32_t borrow_mesh(const Mesh& mesh);
  const PooledMesh& mesh_of(const Shape& shape) const { return meshes_[shape.geometry]; }
  void frame_uvs(Shape& shape);
  void add_frame(Shape& shape, UvFrame frame);
  UvFrame frame_on(const Scope& face) const;
  /// The number of a material of the table, drawn for the shape.
  uint32_t draw_material(uint32_t table, const Shape& shape);

  // ---- derivation
  void run(BodyId body, Shape& shape, const Env& env);
  /// Draws it as a terminal of its symbol.
  void finish(Shape& shape);
  /// Draws a piece of the rule being derived as a terminal of that rule's symbol (levels of
  /// detail).
  void finish_early(Shape& piece);
  void draw(const Shape& shape, uint32_t symbol);
  void check_reach(const Shape& shape, uint32_t symbol);

  // ---- questions about other shapes (rounds.cpp)
  /// A solid that hides others enters the world and becomes the one that its parts come from.
  void show(Shape& shape, bool active);
  /// The same for a solid that no symbol stands for, unless the world has it.
  void show_apart(Shape& shape);
  void note_answer(uint32_t node, const Shape& shape, std::string_view answer,
                   const std::string& why);
  uint32_t rules_of(const Shape& shape) const;
  /// The node of the nearest ancestor of a symbol, or none.
  uint32_t ancestor(const Shape& shape, uint32_t symbol) const;
  /// What an expression of the current rule is for another shape of its group.
  double value_for(const Shape& shape, ExprId expr, Gather how);

  // ---- alternatives (trial.cpp)
  /// Derives a part to its end on the side and gives the score of what came of it.
  double try_part(Context& c, std::size_t i, ExprId score);
  void note_choice(const Call& call, std::size_t part, const std::string& why);
  /// Whether the score of an alternative is being evaluated.
  bool scores() const { return scoring_; }
  /// Whether shapes of the rule being derived waited, so that a split of it may snap.
  bool has_waited() const { return program.rule_sets[current_rules_].waits; }

  // ---- sizes ':' (measure.hpp)
  Measurer& measurer();
  bool measuring = false;  ///< shapes are of unknown size along an axis (NaN), and nothing is drawn
  uint32_t reads = 0;      ///< what was looked at, as read_bits; see Measurer and Placer

  /// How the shapes that the rule emits are numbered.
  struct Siblings {
    bool apart = false;
    uint64_t seed = 0;      ///< of those that are numbered apart
    std::size_t first = 0;  ///< in sibling_counts_
    uint32_t splits = 0;    ///< with sizes ':', so far
  };
  /// While it lives, what is emitted is numbered apart from the other shapes of the rule. So it has
  /// the same random stream when it is measured as when it is derived, whatever comes of the rest.
  class Apart {
   public:
    Apart(Machine& machine, uint64_t seed);
    ~Apart();
    Apart(const Apart&) = delete;
    Apart& operator=(const Apart&) = delete;

   private:
    Machine& machine_;
    Siblings before_;
  };
  /// Of the parts of the split with sizes ':' that comes next in the rule.
  uint64_t stream_of_split() const;
  void count_split() { ++siblings_.splits; }

  // ---- looks
  const Material& material(uint32_t number) const;
  uint32_t add_material(const Material& material);

  // ---- what went wrong
  [[noreturn]] void fail(Span at, std::string text, std::string help = {});
  /// Once a place and building.
  void warn(std::string_view code, Span at, std::string text, std::string help = {});
  void warn(Diagnostic warning);

  const Program& program;
  const DeriveOptions options;
  MeshSource& mesh_source;
  Building* building = nullptr;
  const Footprint* footprint = nullptr;
  const Production* production = nullptr;  ///< being derived
  uint32_t expanding = none;               ///< node being derived
  std::vector<SettingEntry> settings;
  std::vector<UvFrame> uv_frames;
  std::vector<Shape> scratch_shapes;     ///< a stack: users shrink it back
  std::vector<double> scratch_sizes;     ///< likewise
  std::vector<uint32_t> scratch_counts;  ///< likewise
  std::vector<SizeValue> size_values;    ///< of the split being solved
  double base_elevation = 0;
  World world;  ///< empty unless the program asks
  LastCover last_cover;
  Meeting* meeting = nullptr;  ///< the round that is being answered
  int lod = 3;                 ///< level of detail to derive at
  bool keeps_tree = false;
  SnapPlanes planes;                 ///< empty unless the program snaps
  std::vector<SnapLine> snap_lines;  ///< of the split being solved

  /// Holds a number of levels of evaluation; too many are an error of the style's.
  class Deeper {
   public:
    Deeper(Machine& machine, uint32_t node, int levels);
    ~Deeper() { machine_.depth_ -= levels_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;

   private:
    Machine& machine_;
    int levels_;
  };

  std::size_t parts = 0;    ///< made by operations in this building
  std::size_t emitted = 0;  ///< shapes emitted by the rule being derived

 private:
  struct Node {
    uint32_t parent, symbol;
    uint64_t seed;
  };
  struct Count {
    uint32_t node = none, count = 0;
  };

  void reset(const Footprint& footprint, Building& result);
  Shape footprint_shape();
  void expand(Shape& shape);
  void replace(Shape& shape);
  /// Expands the shape, and all that comes of it, now.
  void derive_below(Shape& shape);
  void derive_all();
  void answer_round();
  void mark_active(const Shape& shape);
  const Production* choose(const RuleSet& rules, const Shape& shape, Env& env);
  void rewrite(const RuleSet& rules, uint32_t rule_set, Shape& shape, Env& env);
  void step(const Step& step, Shape& shape, const Env& env);
  void emit(const Step& step, uint32_t symbol, uint32_t style, const Shape& shape, const Env& env);
  Value emitted_symbol(const Step& step, const Env& env);
  void make_child(const Step& step, uint32_t symbol, uint32_t style, const Env& env, Shape& child);
  uint64_t next_seed(uint32_t symbol);
  void run_super(Shape& shape, const Env& env);
  void check_arguments(const Step& step, const RuleSet& rules, const Shape& child);
  void no_candidate(const RuleSet& rules, const Shape& shape);
  Diagnostic why_no_candidate(const RuleSet& rules, const Shape& shape) const;
  uint16_t style_named(const Value& name, Span at) const;
  void bind_index(const Production& chosen, const RuleSet& rules, const Shape& shape, Env& env);
  void explain(Diagnostic& diagnostic);

  // evaluate.cpp
  Value infix(const ExprNode& node, uint32_t id, const Env& env);
  Value compare(const ExprNode& node, uint32_t id, const Value& a, const Value& b);
  Value attribute(Attribute which, const Shape* shape, uint32_t id);
  Value subscript(const ExprNode& node, const Env& env);
  Value call_function(const ExprNode& node, uint32_t id, const Env& env);
  Value define(const ExprNode& node, uint32_t id, const Env& env);
  void count_call(uint32_t id);
  double measure(Attribute which, const Shape& shape);

  // draw.cpp
  void draw_rectangle(const Scope& scope, const UvFrame& frame, uint32_t look);
  void draw_polygon(const Shape& shape, uint32_t look, double along, bool reversed);
  void draw_box(const Shape& shape, uint32_t look);
  void draw_prism(const Shape& shape, uint32_t look);
  void draw_mesh(const Shape& shape, uint32_t look, const PooledMesh& mesh,
                 std::span<const uint32_t> own_looks);
  std::span<const uint32_t> own_looks(const Mesh& mesh);
  static const ElementTable::Choice& choose_element(const ElementTable& table, const Shape& shape);
  bool draw_element(const Shape& shape, uint32_t table);
  UvFrame texture_frame(const Shape& shape, const Scope& face, uint32_t look) const;
  UvFrame texture_frame(const Shape& shape, std::span<const Vec3> loop, Vec3 normal,
                        uint32_t look) const;
  void push_polygon(std::span<const Vec3> loop, const Shape& shape, uint32_t look);
  void push_face(std::span<const Vec3> loop, Vec3 normal, const UvFrame& frame, uint32_t look);
  void close_run(uint32_t symbol, uint32_t material);
  /// Polygons up to `end` look the same.
  void add_run(uint32_t symbol, uint32_t material, uint32_t end);
  uint32_t look_of(const Shape& shape, uint32_t symbol);

  // stains.cpp
  double stain_rate(const Shape& shape, uint32_t symbol) const;
  void note_drip(const Shape& shape, uint32_t symbol);
  bool takes_stains(const Surface::Run& run) const;
  void draw_stains();

  uint64_t stream_of(VariableSlot::Per per, uint32_t symbol, const Shape& shape,
                     uint64_t salt) const;

  uint32_t parent_of(const Shape& shape) const { return nodes_[shape.node].parent; }
  /// A hash of its arguments and of what set() gave it and its ancestors.
  uint64_t inherited_values(const Shape& shape) const;

  std::vector<Shape> stack_;
  std::vector<Shape> waiting_;
  Pool<Meeting> meetings_;
  Pool<Building> trials_;
  bool scoring_ = false, explained_ = false;
  std::size_t tried_ = 0;  ///< shapes of alternatives that were tried in this building
  std::vector<Node> nodes_;
  std::vector<Count> counts_;  ///< by symbol: how many the current rule has emitted
  Siblings siblings_;
  std::vector<std::pair<uint32_t, uint32_t>> sibling_counts_;  ///< symbol and how many, a stack
  std::unique_ptr<Measurer> measurer_;                         ///< once it is needed
  Placer placer_;
  Pool<PooledPolygon> polygons_;
  Pool<PooledMesh> meshes_;
  Arena<Value> values_;
  Arena<char> characters_;
  std::vector<Vec3> loop_;
  std::vector<uint32_t> looks_;

  std::vector<Value> variable_values_;
  std::vector<uint32_t> variable_known_;  ///< building number for which the value holds
  std::vector<bool> variable_varies_;     ///< whether that value is this building's own
  std::vector<const PropertyValue*> property_values_;
  std::vector<uint32_t> property_known_;
  std::vector<uint32_t> overridden_;         ///< variables that a property overrides
  std::vector<uint32_t> variable_property_;  ///< property number that overrides, or none
  uint32_t building_number_ = 0;
  uint64_t building_seed_ = 0;
  uint32_t current_rules_ = none;
  int depth_ = 0;  ///< levels of expressions being evaluated in functions and variables
  int super_depth_ = 0;
  std::size_t without_chance_ = 0;  ///< candidates of probability 0, when nothing else was found
  std::size_t rounds_ = 0;          ///< of questions, in this building
  std::size_t calls_ = 0;           ///< of functions, and of variables by others, in this building

  friend class BuildingValues;
  friend class Trial;
  friend class Measurer;
  friend class Placer;
  friend class Context;
};

}  // namespace mansard
