// Runs the program as a user does: what it printed and how it ended.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mansard::test {

struct Run {
  int status = 0;  ///< of exit; 128 + the signal that ended it
  std::string out, err;
};

/// `mansard` with these arguments, started in `folder`, with `input` on its standard input.
Run run(const std::vector<std::string>& arguments, const std::filesystem::path& folder = ".",
        const std::string& input = {});

std::string contents(const std::filesystem::path& path);

/// An empty folder of its own, removed with all that is in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// A file of this name and text in the folder: its path.
std::string written(const TemporaryFolder& folder, const std::string& name,
                    const std::string& text);
std::size_t files_in(const TemporaryFolder& folder);

}  // namespace mansard::test
