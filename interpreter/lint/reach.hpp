// Which symbols a derivation can come to. Private to the warnings of `check`.
#pragma once

#include <utility>
#include <vector>

#include "interpreter/program.hpp"

namespace mansard {

class Reach {
 public:
  /// From the start of every style that can be derived.
  explicit Reach(const Program& program);

  /// Goes on from a symbol as if it were reached.
  void go_on_from(uint16_t style, uint32_t symbol);

  bool reached(uint16_t style, uint32_t symbol) const { return reached_[style][symbol]; }
  /// Whether anything is derived under this style.
  bool live(uint16_t style) const { return live_[style]; }

  // For Walk.
  void step(const Step& step);
  void expression(ExprId expr);

 private:
  void push(uint16_t style, uint32_t symbol);
  void run();
  void expand(uint16_t style, uint32_t symbol);
  void constant(const Value& value);
  void variable(uint32_t slot);

  const Program& program_;
  std::vector<std::vector<bool>> reached_;  ///< by style and symbol
  std::vector<bool> live_, variables_, functions_;
  std::vector<std::pair<uint16_t, uint32_t>> pending_;
  uint16_t style_ = 0;  ///< whose rules are being walked
};

/// For every style and symbol: whether a rule of another symbol emits it.
std::vector<std::vector<bool>> emitted_by_others(const Program& program);

}  // namespace mansard
