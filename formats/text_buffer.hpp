// Text in memory that is kept for the next text.
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <string_view>

namespace mansard {

class TextBuffer {
 public:
  /// Room for `bytes` more; what is put there counts with advance().
  char* room(std::size_t bytes) {
    if (std::size_t(end_ - at_) < bytes) grow(bytes);
    return at_;
  }
  void advance(char* end) { at_ = end; }
  void put(std::string_view text) {
    if (text.empty()) return;
    char* const to = room(text.size());
    std::memcpy(to, text.data(), text.size());
    advance(to + text.size());
  }
  void clear() { at_ = begin_.get(); }
  std::size_t size() const { return std::size_t(at_ - begin_.get()); }
  std::string_view text() const { return {begin_.get(), size()}; }

 private:
  void grow(std::size_t bytes) {
    const std::size_t used = size();
    const std::size_t capacity = std::max(2 * std::size_t(end_ - begin_.get()), used + bytes);
    auto larger = std::make_unique_for_overwrite<char[]>(capacity);
    if (used > 0) std::memcpy(larger.get(), begin_.get(), used);
    begin_ = std::move(larger);
    at_ = begin_.get() + used;
    end_ = begin_.get() + capacity;
  }

  std::unique_ptr<char[]> begin_;
  char *at_ = nullptr, *end_ = nullptr;
};

}  // namespace mansard
