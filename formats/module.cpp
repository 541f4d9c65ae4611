#include "formats/module.hpp"

#include <dlfcn.h>

#include <array>
#include <filesystem>

namespace mansard {
namespace {

namespace fs = std::filesystem;

void* load(const std::string& file, std::string& problem) {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const std::array folders{program, program / "../lib/mansard", fs::path(MANSARD_MODULE_FOLDER)};
  for (const fs::path& folder : folders) {
    const fs::path path = folder / file;
    if (!fs::exists(path, ignored)) continue;
    if (void* module = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL)) return module;
    problem = dlerror();
    return nullptr;
  }
  problem = "'" + file + "' is neither beside the program nor in ../lib/mansard";
  return nullptr;
}

}  // namespace

void* module_symbol(const std::string& name, const char* symbol, std::string& problem) {
  void* module = load(name + ".so", problem);  // dlopen itself remembers what is loaded
  if (module == nullptr) return nullptr;
  void* found = dlsym(module, symbol);
  if (found == nullptr) problem = "'" + name + ".so' has no '" + symbol + "'";
  return found;
}

}  // namespace mansard
