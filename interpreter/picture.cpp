#include "interpreter/picture.hpp"

namespace mansard {
namespace {

std::string path_of(std::string_view file, Span at, const Program& program, MeshSource& source) {
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

}  // namespace

FoundPicture find_picture(std::string_view file, Span at, const Program& program,
                          MeshSource& source) {
  FoundPicture found;
  found.path = path_of(file, at, program, source);
  Diagnostic d;
  d.severity = Severity::warning;
  d.code = "W020";
  d.at = at;
  if (found.path.empty()) {
    d.text = "there is no picture \"" + std::string(file) + "\"";
    d.help = "it is looked for beside the script, then in each --style-path";
    found.problem = std::move(d);
  } else if (const std::string why = source.picture_problem(found.path); !why.empty()) {
    d.text = "the picture \"" + std::string(file) + "\" can not be used: " + why;
    d.help = "the surface is drawn without it";
    found.problem = std::move(d);
    found.path.clear();
  }
  return found;
}

}  // namespace mansard
