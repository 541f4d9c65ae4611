#include "formats/mesh_limits.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace mansard {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t megabyte = 1ULL << 20;

bool lies_in(const fs::path& file, const std::string& folder) {
  std::error_code error;
  const fs::path outer = fs::canonical(folder.empty() ? "." : folder, error);
  if (error) return false;
  return std::mismatch(outer.begin(), outer.end(), file.begin(), file.end()).first == outer.end();
}

std::string too_large(uint64_t bytes, const MeshLimits& limits) {
  return "has " + std::to_string(bytes / megabyte) + " MB, and at most " +
         std::to_string(limits.megabytes) + " MB are read: make it coarser";
}

}  // namespace

std::string refusal(const std::string& path, const MeshLimits& limits) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return "no such file";
  if (!limits.folders.empty()) {
    const fs::path file = fs::canonical(path, error);
    if (error || std::ranges::none_of(limits.folders, [&](const std::string& folder) {
          return lies_in(file, folder);
        })) {
      return "lies outside the folders of the scripts, of --style-path and of the library";
    }
  }
  if (fs::is_directory(status)) return "is a folder";
  if (!fs::is_regular_file(status)) return "is a device or a pipe";
  const uint64_t bytes = fs::file_size(path, error);
  if (error) return error.message();
  return bytes > limits.megabytes * megabyte ? too_large(bytes, limits) : "";
}

std::string content_within(const std::string& path, const MeshLimits& limits,
                           std::string& problem) {
  problem = refusal(path, limits);
  if (!problem.empty()) return {};
  std::error_code error;
  std::string text(fs::file_size(path, error), '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in || error) {
    problem = std::strerror(errno);
    return {};
  }
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

std::string named_picture(const fs::path& folder, const std::string& name, const MeshLimits& limits,
                          std::string& problem) {
  std::string path = (folder / name).string();
  const std::string why = refusal(path, limits);
  if (why.empty()) return path;
  if (why != "no such file" && why != "is a folder" && problem.empty())
    problem = "it has the picture '" + path + "', which " + why;
  return {};
}

}  // namespace mansard
