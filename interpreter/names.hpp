// Names interned once, so that nothing compares strings while deriving.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace mansard {

class Names {
 public:
  uint32_t intern(std::string_view name) {
    if (const auto it = numbers_.find(name); it != numbers_.end()) return it->second;
    const std::string& kept = names_.emplace_back(name);
    const auto number = static_cast<uint32_t>(names_.size() - 1);
    numbers_.emplace(kept, number);
    return number;
  }
  std::optional<uint32_t> find(std::string_view name) const {
    const auto it = numbers_.find(name);
    return it == numbers_.end() ? std::nullopt : std::optional(it->second);
  }
  std::string_view operator[](uint32_t number) const { return names_[number]; }
  uint32_t size() const { return static_cast<uint32_t>(names_.size()); }

 private:
  std::deque<std::string> names_;
  std::unordered_map<std::string_view, uint32_t> numbers_;
};

}  // namespace mansard
