// The names that a rule, variable or function speaks of, as written: whose they are is not asked.
#pragma once

#include <string_view>
#include <vector>

#include "grammar/syntax.hpp"

namespace mansard {

enum class MentionKind : uint8_t {
  value,  ///< `Width`, `Tile.Width`, `BRICK` in an expression
  call,   ///< `width(…)` in an expression
  emit,   ///< `TILE`, `Infill`: a symbol in a successor, or a variable that holds one
  apply,  ///< `Tower(…)`, `extrude(…)`: a symbol or an operation
  set     ///< the variable that a `set(Tile.Width, …)` names
};

struct Mention {
  MentionKind kind = MentionKind::value;
  std::string_view block;  ///< before the dot; empty when there is none
  std::string_view name;
  Span at;     ///< with the block
  Span value;  ///< what a set() gives; else nowhere
};

/// In text order. The parameters of the rule or function are left out, and what belongs to another
/// style (`Other::WALL`).
std::vector<Mention> mentions_of(const syntax::Rule& rule);
std::vector<Mention> mentions_of(const syntax::Variable& variable);
std::vector<Mention> mentions_of(const syntax::Function& function);

}  // namespace mansard
