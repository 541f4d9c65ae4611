// The value of a variable as far as the script alone decides it.
#pragma once

#include <optional>
#include <string>

#include "cli/lsp/meaning.hpp"

namespace mansard::lsp {

/// Of a variable in the style that looks at it, late bound: sums, products and the like of numbers
/// and of other variables. Nothing when it is written as a plain number, reads the shape or draws.
std::optional<std::string> known_value(const Meanings& meanings, const Meaning& variable);

}  // namespace mansard::lsp
