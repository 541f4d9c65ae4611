// What a mesh file may cost and what it may open: such files come from anywhere.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace mansard {

struct MeshLimits {
  /// The file and all that it names lie in one of these, links followed. Empty: anywhere.
  std::vector<std::string> folders;
  uint64_t megabytes = 256;  ///< of one file
  // Of what Assimp reads:
  uint64_t memory = 4096;  ///< megabytes of the process
  double seconds = 30;     ///< of the processor
};

/// Coordinates beyond this, in metres, are refused.
constexpr double furthest_point = 1e9;

/// Why `path` is not to be opened, in a few words ("no such file"); empty where it is.
std::string refusal(const std::string& path, const MeshLimits& limits);

/// The whole content of a file that is not refused; else empty, and `problem` says why.
std::string content_within(const std::string& path, const MeshLimits& limits, std::string& problem);

/// The picture `name` that a mesh in `folder` names, where there is one; else empty. One that is
/// refused for another reason than that it is missing is a problem of the mesh.
std::string named_picture(const std::filesystem::path& folder, const std::string& name,
                          const MeshLimits& limits, std::string& problem);

}  // namespace mansard
