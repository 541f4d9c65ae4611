// How high a building stands by what its footprint says.
#pragma once

#include "interpreter/footprint.hpp"

namespace mansard {

/// Metres: `min_height`, 0 without.
double base_of(const Footprint& footprint);
/// BUILDING_HEIGHT, what stands above the base, so that the top comes out at `height`: the property
/// height less the base, else 3 m for each of building:levels, else 9.
double height_of(const Footprint& footprint);
/// A property read as a number, finite, else the fallback.
double number_or(const Footprint& footprint, std::string_view name, double fallback);

}  // namespace mansard
