// The pattern of split(axis) { 1 : A | { ~2 : B | 1r : C }* }, laid out (CGA's full pattern).
#pragma once

#include <optional>
#include <vector>

#include "interpreter/axes.hpp"
#include "interpreter/machine.hpp"

namespace mansard {

/// Its parts one after the other, with the round of their group.
struct Pattern {
  std::vector<SizeValue> sizes;
  std::vector<const CallPart*> parts;
  std::vector<std::size_t> rounds;
};

/// Groups repeat round(room / their natural length) times in `whole` metres; without an axis along
/// a diagonal.
Pattern pattern_of(Context& c, std::optional<Axis> axis, double whole);

}  // namespace mansard
