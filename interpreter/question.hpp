// What a shape asks about others, and the answer: Shape.occ, inside, overlaps, touches.
#pragma once

#include <optional>
#include <string_view>

#include "geometry/occlusion.hpp"
#include "interpreter/function.hpp"

namespace mansard {

/// Before a face, in metres: what covers it lies this far out, so that its own mass and one that
/// only ends in its plane do not.
inline constexpr double contact = 0.001;
/// Party walls are found within this, so neighbours cover a face that is this far from them.
inline constexpr double party = 0.05;
/// Covered or free pieces that are thinner do not count; beside neighbours.
inline constexpr double thinnest_cover = 0.01, thinnest_party = 0.06;

/// `word` is "distance" where there is one.
using Word = std::optional<std::string_view>;

Value ask_cover(const FunctionCall& call, std::string_view set, Word word,
                std::optional<double> distance);
Value ask_inside(const FunctionCall& call, std::string_view set, Word word,
                 std::optional<double> distance);
Value ask_overlaps(const FunctionCall& call, std::string_view set, Word word,
                   std::optional<double> distance);
Value ask_touches(const FunctionCall& call, std::string_view set);

}  // namespace mansard
