// Where the file is that a script names.
#pragma once

#include <optional>
#include <string>

#include "cli/lsp/project.hpp"

namespace mansard::lsp {

/// Of a word at Site::file: beside the script, then in the style path; of meshes also under the
/// endings .obj and .glb, as the compiler looks for them.
std::optional<std::string> find_file(Project& project, const Word& word);

}  // namespace mansard::lsp
