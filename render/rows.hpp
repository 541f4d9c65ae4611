// Rows shared out among threads. What a row computes must not depend on the thread that does it.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace mansard {

/// The number of threads that an option of 0 (all) or more asks for.
inline int thread_count(int asked) {
  const int all = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return std::clamp(asked > 0 ? asked : all, 1, 256);
}

/// Calls f(row) once for every row of [0, rows), in any order, on up to `threads` threads.
template <class F>
void for_each_row(int rows, int threads, F f) {
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int row = next++; row < rows; row = next++) f(row);
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < std::min(threads, rows); ++i) others.emplace_back(work);
  work();
}

}  // namespace mansard
