// Many small records of bytes: in memory while they are few, beyond that in a file without a name.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mansard {

/// Memory grows by eight bytes a record. The file lies where temporary files do. Throws Failure
/// when that can not be written or read.
class RecordFile {
 public:
  RecordFile() = default;
  ~RecordFile();
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  /// Its number is the size() of before.
  void add(std::string_view record);
  std::size_t size() const { return ends_.size(); }
  /// Replaces `record`, whose memory is used again. Any number of threads at a time, but not while
  /// one adds.
  void read(std::size_t number, std::string& record) const;

 private:
  void flush();

  static constexpr std::size_t capacity = 2 << 20;
  std::string last_;            ///< the records that are not in the file
  std::vector<uint64_t> ends_;  ///< one past the last byte of each
  uint64_t flushed_ = 0;
  int file_ = -1;
};

}  // namespace mansard
