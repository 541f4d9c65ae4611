// The disk of the tests: a map.
#pragma once

#include <map>
#include <string>

#include "styles/files.hpp"

namespace mansard {

class MemoryFiles final : public Files {
 public:
  MemoryFiles(std::initializer_list<std::pair<const std::string, std::string>> files)
      : files_(files) {}
  explicit MemoryFiles(std::string text) { files_["main.style"] = std::move(text); }

  std::optional<std::string> read(const std::string& path) override {
    ++reads[path];
    const auto found = files_.find(identity(path));
    return found == files_.end() ? std::nullopt : std::optional(found->second);
  }
  bool exists(const std::string& path) override { return files_.contains(identity(path)); }

  std::map<std::string, int> reads;

 private:
  std::map<std::string, std::string> files_;
};

}  // namespace mansard
