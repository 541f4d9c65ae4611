#include "styles/files.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace mansard {

namespace fs = std::filesystem;

std::string Files::identity(const std::string& path) {
  return fs::path(path).lexically_normal().string();
}

std::vector<std::string> Files::scripts(const std::string&) { return {}; }

// Devices are refused with the directories: /dev/zero has no end.
std::optional<std::string> DiskFiles::read(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error || !(fs::is_regular_file(status) || fs::is_fifo(status))) return std::nullopt;

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) return std::nullopt;
  std::string content;
  std::array<char, 1 << 16> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    content.append(buffer.data(), count);
  }
  if (std::ferror(file.get()) != 0) return std::nullopt;
  return content;
}

bool DiskFiles::exists(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error);
}

std::vector<std::string> DiskFiles::scripts(const std::string& folder) {
  constexpr std::size_t most = 200;
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end && names.size() < most;
       it.increment(error)) {
    if (it->path().extension() == ".style") names.push_back(it->path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

std::string DiskFiles::identity(const std::string& path) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? Files::identity(path) : canonical.string();
}

}  // namespace mansard
