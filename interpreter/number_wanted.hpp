// A value on the command line for a variable that holds a number.
#pragma once

#include <string>
#include <string_view>

#include "styles/style.hpp"

namespace mansard {

/// Whether a style gives the variable a plain number.
bool holds_number(const VariableBinding& variable);

/// What is wrong with a value that is none: "decimals have a point: 1.2".
std::string number_help(std::string_view value);

}  // namespace mansard
