// The measure pass: how long what is derived from a shape is by itself along an axis, before it is
// known how long the shape will be. Solves sizes ':' of splits, and is what layouts share.
//
// It walks the rules as a derivation would, with the shape's size along the axis unknown (NaN), and
// draws nothing. Fixed sizes count as they are, floats prefer theirs and may be anything, shares
// have none, per cent are of the result, sizes ':' are measured in turn; what lies beside each
// other is as long as the longest; elements and inserted meshes have their mesh's size in metres,
// s() and the like what they say. The contents of parts with a size of their own do not matter. A
// rule that reads the unknown size, or asks about other shapes, is an error.
//
// Rules and elements are drawn as when deriving, since a shape's stream follows from its path
// alone; only of rules that emit a symbol as often as a size demands, and then measure it, the
// count is that of one repetition.
#pragma once

#include <unordered_map>
#include <vector>

#include "interpreter/axes.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/natural_size.hpp"

namespace mansard {

class Measurer {
 public:
  explicit Measurer(Machine& machine);

  /// A new building: what was measured is forgotten.
  void reset();

  /// A part of the split that `c` carries out. `whole` is the shape that is split, with split_index
  /// and its like as the part will have them; `at` is where the size stands. {0, 0, 0} where the
  /// part is empty. Throws Failure where its length depends on itself.
  NaturalSize part(Context& c, const CallPart& part, const Shape& whole, Axis axis, Span at);

  /// A shape of a symbol, its seed and node (its parent's) set, whatever its size along the axis
  /// is.
  NaturalSize shape(const Shape& shape, Axis axis, Span at);

  // ---- what expressions may not ask while shapes are measured
  void check_read(Attribute which, const Shape& shape, uint32_t node);
  void check_call(const Function& function, uint32_t node);

 private:
  /// A shape on its way through a successor. What is found to be n long below it is n * scale +
  /// more long above.
  struct Piece {
    Shape shape;
    double scale = 1, more = 0;
    bool lost = false;  ///< nothing can be said of what is derived from it
  };
  /// What the shapes that a rule or part emits come to.
  struct Result {
    NaturalSize size{0, 0, NaturalSize::unbounded};
    std::size_t emitted = 0, met = 0;  ///< met: but NIL

    void add(const NaturalSize& natural, const Piece& piece);
    NaturalSize all() const;
  };
  /// Sizes of a split along the axis that is measured.
  class Row;
  enum class Effect : uint8_t;

  class Enter;

  Piece unknown(const Shape& whole, Axis axis) const;
  std::optional<Axis> open_axis(const Shape& shape) const;
  NaturalSize extent(const Shape& shape) const;
  NaturalSize symbol(Shape& child, Span at);
  NaturalSize rules(Shape& child, uint32_t rule_set);
  NaturalSize terminal(const Shape& shape, Axis axis);
  void rewrite(uint32_t rule_set, Piece& piece, Env& env, Result& result);
  void body(BodyId body, Piece& piece, const Env& env, Result& result);
  void step(const Step& step, Piece& piece, const Env& env, Result& result);
  void emit(const Step& step, Piece& piece, const Env& env, Result& result);
  void super(Piece& piece, const Env& env, Result& result);
  void deeper(Span at);
  uint64_t key_of(const Shape& shape, Axis axis) const;
  uint64_t read_of(const Shape& shape, uint32_t reads) const;
  [[noreturn]] void refuse_question(Span at) const;
  [[noreturn]] void refuse(Diagnostic diagnostic) const;

  // measure_operations.cpp
  void operation(const Call& call, Piece& piece, const Env& env, Result& result);
  void on_part(Context& c, const CallPart& part, std::size_t i, Piece piece, Result& result);
  double known(ExprId expr, const Env& env);
  void resize(const Call& call, Piece& piece, const Env& env);
  void extrude(const Call& call, Piece& piece, const Env& env);
  void offset(Context& c, Piece& piece, Result& result);
  void turn(const Call& call, Piece& piece, const Env& env);
  void insert(const Call& call, Piece& piece, const Env& env);

  // measure_splits.cpp
  void split(Context& c, Piece& piece, Result& result);
  NaturalSize along_it(Context& c, Axis axis);
  void row_of(Context& c, const std::vector<CallPart>& parts, Axis axis, std::size_t& place,
              Row& row);
  void across(Context& c, Axis axis, const Piece& piece, Result& result);

  Machine& machine_;
  std::vector<Effect> effects_;  ///< by row of the operation table
  Vec3 direction_;               ///< along which is measured, in the world
  Axis letter_ = Axis::x;        ///< as its split wrote it
  std::vector<Span> open_;       ///< sizes ':' being measured, outermost first
  int depth_ = 0;
  std::size_t shapes_ = 0;                            ///< measured in this building
  std::unordered_map<uint64_t, uint32_t> reads_;      ///< what shapes like it read, by key_of
  std::unordered_map<uint64_t, NaturalSize> known_;   ///< by key_of and read_of
  std::unordered_map<const Mesh*, Vec3> mesh_sizes_;  ///< of elements
};

/// A length was asked for that is being measured.
struct UnknownLength : Failure {
  using Failure::Failure;
};

}  // namespace mansard
