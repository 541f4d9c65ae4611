#include "interpreter/picture.hpp"

namespace mansard {

std::string find_picture(std::string_view file, Span at, const Program& program,
                         MeshSource& source) {
  const std::string name(file), folder = Library::folder_of(at);
  const bool absolute = name.starts_with('/');
  std::string beside = absolute || folder.empty() ? name : folder + "/" + name;
  if (source.has_picture(beside)) return beside;
  if (absolute) return {};
  for (const std::string& other : program.mesh_folders) {
    if (source.has_picture(other + "/" + name)) return other + "/" + name;
  }
  return {};
}

Diagnostic missing_picture(std::string_view file, Span at) {
  Diagnostic d;
  d.severity = Severity::warning;
  d.code = "W020";
  d.at = at;
  d.text = "there is no picture \"" + std::string(file) + "\"";
  d.help = "it is looked for beside the script, then in each --style-path";
  return d;
}

}  // namespace mansard
