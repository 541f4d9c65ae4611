// Indices that heads test: `FLOOR[2] -> ...`.
#pragma once

#include <string>

#include "grammar/diagnostic.hpp"
#include "interpreter/program.hpp"

namespace mansard {

/// The number that the production's head tests; nothing when it tests none.
std::optional<double> tested_index(const Program& program, const Production& production);
/// Whether one of them stands open to this index, whatever its conditions say. NaN: it is not set.
bool takes_index(const Program& program, const RuleSet& rules, double index);
/// "F[1]", "F[2]" and so on, the nearest one and what to write, for an index that none of them
/// takes.
Diagnostic untaken_index(const Program& program, const RuleSet& rules, double index);

}  // namespace mansard
