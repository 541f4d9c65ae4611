// What `mansard check` warns of in a script that has no errors: what nothing reads, reaches or
// chooses, what hides something else, and names that look misspelt.
#pragma once

#include "grammar/diagnostic.hpp"
#include "grammar/syntax.hpp"
#include "interpreter/program.hpp"

namespace mansard {

/// Speaks of members written in `file` only. `program` holds every style that is loaded and can be
/// linked (CompileOptions::all_styles). A style is judged by the heirs that can be derived: of one
/// that is only mixed in elsewhere nothing is known, so nothing is said.
void lint(const Program& program, const syntax::File& file, Diagnostics& diagnostics);

}  // namespace mansard
