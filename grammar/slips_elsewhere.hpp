// What people write who know other languages, or see this one for the first time.
#pragma once

#include <string>

#include "grammar/slips.hpp"

namespace mansard {

/// How it is written here, in the user's own words; empty when this is no such habit.
std::string explain_habit(const Stuck& stuck);

}  // namespace mansard
