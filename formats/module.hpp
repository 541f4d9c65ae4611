// Parts that are loaded when they are needed, so that the program starts in a few milliseconds:
// GDAL alone brings a hundred shared libraries.
#pragma once

#include <string>

namespace mansard {

/// The function `symbol` of the module `name` (its file without folder and ending), looked for
/// beside the program, in ../lib/mansard from there, and where it was built. On failure null, and
/// `problem` says why. A module stays loaded.
void* module_symbol(const std::string& name, const char* symbol, std::string& problem);

/// The program `name`, looked for in the same places; on failure empty.
std::string program_beside(const std::string& name, std::string& problem);

}  // namespace mansard
