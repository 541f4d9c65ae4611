#include "interpreter/solid_set.hpp"

#include <algorithm>

namespace mansard {

SolidSet::SolidSet(const Machine& machine, const Shape& asking, std::string_view word)
    : machine_(machine), asking_(asking) {
  kind_ = static_cast<Kind>(std::ranges::find(occluder_sets, word) - occluder_sets.begin());
  if (kind_ == Kind::label) label_ = machine.program.symbols.find(word).value_or(Shape::none);
}

bool SolidSet::has(uint32_t solid) const {
  const Occluder& occluder = machine_.world[solid];
  switch (kind_) {
    case Kind::all:
      return true;
    case Kind::noparent:
      return !machine_.world.is_above(solid, asking_.solid);
    case Kind::active:
      return occluder.active;
    case Kind::neighbours:
      return false;
    case Kind::label:
      return label_ != Shape::none && occluder.shape.label == label_;
  }
  return false;
}

}  // namespace mansard
