// The seam to the disk, faked in tests.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mansard {

class Files {
 public:
  virtual ~Files() = default;
  /// Whole content, or nothing when the file can not be read.
  virtual std::optional<std::string> read(const std::string& path) = 0;
  virtual bool exists(const std::string& path) = 0;
  /// Names of the files in a folder that end in .style, in order; for suggestions, so none where
  /// that can not be told.
  virtual std::vector<std::string> scripts(const std::string& folder);
  /// One spelling for all paths of one file, so that it is read once. Here: `.` and `..` resolved.
  virtual std::string identity(const std::string& path);
};

/// The real disk. Reads regular files and pipes, refuses directories.
class DiskFiles final : public Files {
 public:
  std::optional<std::string> read(const std::string& path) override;
  bool exists(const std::string& path) override;
  std::vector<std::string> scripts(const std::string& folder) override;
  /// Absolute, links resolved.
  std::string identity(const std::string& path) override;
};

}  // namespace mansard
