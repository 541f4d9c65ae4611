// A bar on a terminal while buildings are made; nothing anywhere else.
#pragma once

#include <chrono>
#include <cstddef>

namespace mansard {

class Progress {
 public:
  Progress(std::size_t total, bool quiet);
  ~Progress();
  void step();

 private:
  void draw();
  std::size_t total_, done_ = 0;
  bool shown_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace mansard
