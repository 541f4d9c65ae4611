// A file that appears whole or not at all.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

namespace mansard {

/// Writes beside `path` and renames at commit(); destroyed before, it removes what it wrote. A file
/// that is replaced keeps its permissions, a link stays a link. A path
/// that names something else than a file (/dev/stdout, a pipe) is written straight to. Throws
/// Failure with the path and the system's words.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Room for at least `bytes` (at most `block`) more; what is put there counts with advance().
  char* room(std::size_t bytes) {
    if (std::size_t(buffer_.get() + capacity - at_) < bytes) flush();
    return at_;
  }
  void advance(char* end) { at_ = end; }
  /// Much of it goes straight to the system.
  void put(std::string_view text);
  /// Appends the first bytes of an open file, as many of these as the system copies by itself
  /// (none, where one of the two is no file or they lie too far apart), and returns how many.
  uint64_t copy_from(int file, uint64_t bytes);
  void commit();
  std::size_t bytes() const { return flushed_ + (at_ - buffer_.get()); }
  bool is_regular() const { return regular_; }

  static constexpr std::size_t block = 1 << 16;

 private:
  void open_temporary();
  void flush();
  void write_out(std::string_view text);
  [[noreturn]] void fail(int error) const;

  static constexpr std::size_t capacity = 2 << 20;
  std::string path_, target_, temporary_;
  std::unique_ptr<char[]> buffer_;
  char* at_ = nullptr;
  std::size_t flushed_ = 0;
  int file_ = -1;
  int mode_ = -1;  ///< permissions of the file that is replaced
  bool regular_ = true;
  bool nameless_ = false;  ///< has no name before commit()
};

}  // namespace mansard
