// The pictures of textures.
#pragma once

#include <optional>
#include <string>

#include "interpreter/program.hpp"

namespace mansard {

struct FoundPicture {
  std::string path;                   ///< empty when there is no such file, or no picture in it
  std::optional<Diagnostic> problem;  ///< W020, at the name of the file
};

/// Looks beside the script that names the picture at `at`, then in the style path.
FoundPicture find_picture(std::string_view file, Span at, const Program& program,
                          MeshSource& source);

}  // namespace mansard
