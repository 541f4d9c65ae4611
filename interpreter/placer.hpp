// Derive once, place many: what comes of a shape whose place does not matter is derived at the
// origin and moved to where the shape stands; the next shape like it takes a copy. Without the
// copies the same arithmetic happens, so the result is the same to the last bit.
#pragma once

#include <cstdint>
#include <vector>

#include "interpreter/parts.hpp"
#include "interpreter/shape.hpp"
#include "interpreter/uv_frame.hpp"

namespace mansard {

class Machine;

class Placer {
 public:
  explicit Placer(Machine& machine);

  /// A new building. `shares` is whether copies may be taken.
  void reset(bool shares);

  bool takes(const Shape& shape) const;
  /// Derives the shape to its end; takes() must hold.
  void place(Shape& shape);

  // ---- what the derivation tells; of use while something is being placed
  void note_terminal(uint32_t symbol) {
    if (open_ > 0) terminals_.emplace_back(symbol, 1);
  }
  void note_taken(uint32_t production) {
    if (open_ > 0) taken_.emplace_back(production, 1);
  }
  void note_depth(uint32_t depth) {
    if (depth > deepest_) deepest_ = depth;
  }
  /// The polygon drawn last has its texture in the frame, repeated every so many metres.
  void note_polygon(const UvFrame& frame, Vec2 metres) {
    if (open_ == 0) return;
    const bool on_wall = frame.number != Shape::none && frame.number == frame_;
    if (!on_wall && !frame.level) return hung_.add(0);
    hung_.add(hung_.kind(
        {on_wall, frame.level, frame.shift_u * (1 / metres.x), frame.shift_v * (1 / metres.y)}));
  }
  /// It has its texture's coordinates from elsewhere.
  void forget_texture() {
    if (open_ > 0) hung_[hung_.size() - 1] = 0;
  }

 private:
  /// Of a symbol in a style.
  struct Seen {
    uint32_t reads = 0;  ///< all that its shapes ever read
    uint32_t tries = 0, hits = 0;
    bool helps() const { return tries < 64 || 4 * hits >= tries; }
  };
  /// The machine before a part was derived.
  struct Before;
  class Textures;

  Seen& seen(const Shape& shape);
  PartKey key_of(const Shape& shape, uint32_t reads) const;
  uint64_t word_of(const Shape& shape, uint32_t reads) const;
  bool fits(const Part& part, const Shape& shape) const;
  void put(const Part& part, const Shape& shape);
  void put_textures(const Part& part, const Shape& shape, const Moves& moves);
  void derive(Shape& shape);
  void keep(const Shape& shape, const Before& before, uint32_t reads);
  void keep_surface(Part& part, const Before& before);
  void settle(const Shape& shape, const Before& before);
  Moves moves_of(const Shape& shape) const;
  bool stays_on_wall(const Shape& shape) const;
  static void count(std::vector<PartCount>& counts, std::size_t first);

  Machine& machine_;
  PartStore store_;
  std::vector<Seen> seen_;  ///< by style, then symbol
  bool shares_ = true;
  int open_ = 0;  ///< parts being derived, one in the other
  uint32_t deepest_ = 0;
  uint32_t frame_ = Shape::none;  ///< that the innermost of them hangs on
  uint32_t first_polygon_ = 0;    ///< of the outermost of them
  Hangings hung_;                 ///< by polygon since that
  std::vector<PartCount> terminals_, taken_;
};

}  // namespace mansard
