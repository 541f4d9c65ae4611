#include "cli/progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace mansard {

Progress::Progress(std::size_t total, bool quiet)
    : total_(total),
      shown_(!quiet && isatty(STDERR_FILENO) == 1),
      last_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::step() {
  ++done_;
  const auto now = std::chrono::steady_clock::now();
  if (!shown_ || now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  draw();
}

void Progress::draw() {
  constexpr std::size_t width = 40;
  const std::size_t filled = total_ > 0 ? width * done_ / total_ : width;
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
  std::fprintf(stderr, "\r[%s] %zu of %zu", bar.c_str(), done_, total_);
  std::fflush(stderr);
}

}  // namespace mansard
