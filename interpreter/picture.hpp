// The pictures of textures.
#pragma once

#include <string>

#include "interpreter/program.hpp"

namespace mansard {

/// The path of a picture: beside the script that names it at `at`, else in the style path. Empty
/// when there is no such file.
std::string find_picture(std::string_view file, Span at, const Program& program,
                         MeshSource& source);
/// W020, at the name of the file.
Diagnostic missing_picture(std::string_view file, Span at);

}  // namespace mansard
