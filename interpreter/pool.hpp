// Objects that keep their memory from building to building.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

namespace mansard {

/// Addresses are stable; reset() makes all free again without giving their memory back.
template <class T>
class Pool {
 public:
  uint32_t take() {
    if (used_ == items_.size()) items_.emplace_back();
    return used_++;
  }
  T& operator[](uint32_t i) { return items_[i]; }
  const T& operator[](uint32_t i) const { return items_[i]; }
  uint32_t size() const { return used_; }
  /// The one taken last.
  void give_back() { --used_; }
  void reset() { used_ = 0; }

 private:
  std::deque<T> items_;
  uint32_t used_ = 0;
};

/// Values of the current building, in blocks that never move.
template <class T>
class Arena {
 public:
  T* take(std::size_t n) {
    while (block_ < blocks_.size() && blocks_[block_].size() - at_ < n) ++block_, at_ = 0;
    if (block_ == blocks_.size()) blocks_.emplace_back(n > block_size ? n : block_size);
    T* const result = blocks_[block_].data() + at_;
    at_ += n;
    return result;
  }
  void reset() { block_ = 0, at_ = 0; }

 private:
  static constexpr std::size_t block_size = 1024;
  std::deque<std::vector<T>> blocks_;
  std::size_t block_ = 0, at_ = 0;
};

}  // namespace mansard
