#include "cli/lsp/find_file.hpp"

#include <filesystem>

namespace mansard::lsp {

std::optional<std::string> find_file(Project& project, const Word& word) {
  namespace fs = std::filesystem;
  std::vector<std::string> folders{Library::folder_of(word.at)};
  folders.insert(folders.end(), project.style_path().begin(), project.style_path().end());
  const std::string named(word.text), stem = named.substr(0, named.rfind('.'));
  for (const std::string& name : {named, stem + ".obj", stem + ".glb"}) {
    for (const std::string& folder : folders) {
      const std::string path = (fs::path(folder) / name).lexically_normal().string();
      if (project.documents().exists(path)) return path;
    }
  }
  return std::nullopt;
}

}  // namespace mansard::lsp
