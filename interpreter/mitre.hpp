// Bands on walls whose ends meet those of the walls beside in the plane that halves the corner.
#pragma once

#include <optional>

#include "interpreter/machine.hpp"

namespace mansard {

/// The face drawn out by `depth`, left open at its back and where it ends in a corner. Nothing
/// where neither end is mitred: walls end square where they go straight on, are not upright, or
/// meet at less than 30 or more than 330 degrees.
std::optional<Shape> mitred(Machine& machine, const Shape& face, double depth);

}  // namespace mansard
