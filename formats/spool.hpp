// A file without a name, for parts of a model that can only be put together at its end.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "formats/output_file.hpp"

namespace mansard {

/// Lies in the folder of the model, so that memory stays flat and the space is where it will be
/// needed anyway; gone with the object. Throws Failure as OutputFile does.
class Spool {
 public:
  explicit Spool(std::string model);
  ~Spool();
  Spool(const Spool&) = delete;
  Spool& operator=(const Spool&) = delete;

  void put(const void* bytes, std::size_t count);
  void put(std::string_view text) { put(text.data(), text.size()); }
  /// Zeros up to a multiple of four.
  void align();
  uint64_t bytes() const { return flushed_ + at_; }
  /// Appends all that was put here.
  void copy_to(OutputFile& out);

 private:
  void flush();
  [[noreturn]] void fail(int error) const;

  static constexpr std::size_t capacity = 1 << 18;
  std::string model_;
  std::unique_ptr<char[]> buffer_;
  std::size_t at_ = 0;
  uint64_t flushed_ = 0;
  int file_ = -1;
};

}  // namespace mansard
