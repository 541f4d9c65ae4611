// Things that threads take and give back, with the memory that they have grown.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <vector>

namespace mansard {

template <class T>
class Stock {
 public:
  /// On any thread; a new one when all are taken.
  T* take() {
    const std::scoped_lock lock(mutex_);
    if (free_.empty()) return &all_.emplace_back();
    T* const one = free_.back();
    free_.pop_back();
    return one;
  }
  void give_back(T* one) {
    const std::scoped_lock lock(mutex_);
    free_.push_back(one);
  }

 private:
  std::mutex mutex_;
  std::deque<T> all_;
  std::vector<T*> free_;
};

}  // namespace mansard
