#include "formats/module.hpp"

#include <dlfcn.h>

#include <array>
#include <filesystem>

namespace mansard {
namespace {

namespace fs = std::filesystem;

/// Where it is, else empty.
std::string find(const std::string& file, std::string& problem) {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const std::array folders{program, program / "../lib/mansard", fs::path(MANSARD_MODULE_FOLDER)};
  for (const fs::path& folder : folders) {
    const fs::path path = folder / file;
    if (fs::exists(path, ignored)) return path.string();
  }
  problem = "'" + file + "' is neither beside the program nor in ../lib/mansard";
  return {};
}

void* load(const std::string& file, std::string& problem) {
  const std::string path = find(file, problem);
  if (path.empty()) return nullptr;
  void* const module = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (module == nullptr) problem = dlerror();
  return module;
}

}  // namespace

void* module_symbol(const std::string& name, const char* symbol, std::string& problem) {
  void* module = load(name + ".so", problem);  // dlopen itself remembers what is loaded
  if (module == nullptr) return nullptr;
  void* found = dlsym(module, symbol);
  if (found == nullptr) problem = "'" + name + ".so' has no '" + symbol + "'";
  return found;
}

std::string program_beside(const std::string& name, std::string& problem) {
  return find(name, problem);
}

}  // namespace mansard
