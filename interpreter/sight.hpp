// What shapes ask of things that stand apart from them: how far the nearest is, and whether it is
// seen. Shape.visible and nearest.
#pragma once

#include <string_view>

#include "interpreter/function.hpp"

namespace mansard {

/// The word that means the streets, or where there are none lines before the street edges.
inline constexpr std::string_view street_word = "street";

/// Metres from the shape to the nearest solid of the set that it did not itself come from, or, in
/// the plan, to the nearest street; infinity where there is none.
Value ask_nearest(const FunctionCall& call, std::string_view set);

/// Whether the shortest line from the middle of the shape's scope to the nearest solid or street is
/// free: it leaves a face forwards, and no solid takes more than a millimetre of it. A solid that
/// the shape came from may have its middle inside.
Value ask_visible(const FunctionCall& call, std::string_view set);

}  // namespace mansard
