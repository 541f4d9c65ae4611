#include "cli/lsp/workspace.hpp"

#include <algorithm>
#include <filesystem>

#include "cli/lsp/tokens.hpp"

namespace mansard::lsp {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_scripts = 5000;
constexpr std::size_t most_entries = 100'000;
constexpr int deepest_folder = 12;

bool is_passed_over(const std::string& folder) {
  return folder.starts_with('.') || folder.starts_with("build") || folder == "out" ||
         folder == "node_modules";
}

bool is_below(const std::string& path, const std::string& folder) {
  return path.starts_with(folder) &&
         (path.size() == folder.size() || folder.ends_with('/') || path[folder.size()] == '/');
}

}  // namespace

void Workspace::add_folder(const std::string& path) {
  folders_.insert(documents_.identity(path));
  is_known_ = false;
}

void Workspace::remove_folder(const std::string& path) {
  folders_.erase(documents_.identity(path));
  is_known_ = false;
}

bool Workspace::contains(const std::string& identity) const {
  if (documents_.all().contains(identity)) return true;
  const auto holds = [&](const std::string& folder) {
    return is_below(identity, documents_.identity(folder));
  };
  return folders_.empty() ? std::ranges::none_of(style_path_, holds)
                          : std::ranges::any_of(folders_, holds);
}

const std::set<std::string>& Workspace::scripts() {
  if (is_known_) return scripts_;
  is_known_ = true;
  scripts_.clear();
  for (const std::string& folder : folders_) look(folder);
  for (const auto& [identity, document] : documents_.all()) scripts_.insert(identity);
  return scripts_;
}

void Workspace::look(const std::string& folder) {
  std::error_code error;
  std::size_t entries = 0;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (const fs::recursive_directory_iterator end; !error && at != end; at.increment(error)) {
    if (++entries > most_entries || scripts_.size() >= most_scripts) return;
    const std::string name = at->path().filename().string();
    if (at->is_directory(error)) {
      if (at.depth() >= deepest_folder || is_passed_over(name)) at.disable_recursion_pending();
    } else if (name.ends_with(".style")) {
      scripts_.insert(documents_.identity(at->path().string()));
    }
    error.clear();
  }
}

// Found as Library finds them: beside the importing file, then in the style path.
const std::vector<std::string>& Workspace::imports_of(const std::string& identity) {
  Imports& known = imports_[identity];
  const uint64_t stamp = documents_.stamp(identity);
  if (known.stamp == stamp) return known.files;
  known = {stamp, {}};
  const auto text = documents_.read(identity);
  if (!text) return known.files;
  for (const std::string& path : imported_paths(*text)) {
    std::vector<std::string> folders{fs::path(identity).parent_path().string()};
    folders.insert(folders.end(), style_path_.begin(), style_path_.end());
    for (const std::string& folder : folders) {
      const std::string candidate = (fs::path(folder) / path).string();
      if (!documents_.exists(candidate)) continue;
      known.files.push_back(documents_.identity(candidate));
      break;
    }
  }
  return known.files;
}

std::vector<std::string> Workspace::tops_above(const std::string& identity) {
  std::map<std::string, std::vector<std::string>> importers;
  for (const std::string& script : scripts()) {
    for (const std::string& imported : imports_of(script)) importers[imported].push_back(script);
  }
  std::vector<std::string> tops, waiting{identity};
  std::set<std::string> seen{identity};
  while (!waiting.empty()) {
    const std::string at = waiting.back();
    waiting.pop_back();
    const std::vector<std::string>& above = importers[at];
    if (above.empty()) tops.push_back(at);
    for (const std::string& script : above) {
      if (seen.insert(script).second) waiting.push_back(script);
    }
  }
  // Scripts that import each other in a ring have no top: each will do.
  return tops.empty() ? std::vector<std::string>(seen.begin(), seen.end()) : tops;
}

}  // namespace mansard::lsp
