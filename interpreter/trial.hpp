// Alternatives that are derived on the side, scored and forgotten, so that the best can be derived
// in earnest: best(score) { A | B } (CGA++, Schwarz and Mueller 2015, without the trees as values).
#pragma once

#include <string_view>

#include "interpreter/function.hpp"

namespace mansard {

/// How many terminals of the symbol the alternative has.
double made(const FunctionCall& call, std::string_view symbol);
/// The sum of the numbers that it reported under the key.
double reported(const FunctionCall& call, std::string_view key);

}  // namespace mansard
