// What a golden file shows of a linked style: everything that a derivation would use.
#pragma once

#include <string>

#include "styles/style.hpp"

namespace mansard {

/// Name and order.
std::string dump_head(const LinkedStyle& style);
/// All else; the same for a style and for an empty heir of it.
std::string dump_body(const LinkedStyle& style);

/// All diagnostics as the command line prints them.
std::string dump(Diagnostics& diagnostics);

}  // namespace mansard
