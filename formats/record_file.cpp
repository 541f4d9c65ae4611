#include "formats/record_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "formats/nameless_file.hpp"
#include "grammar/diagnostic.hpp"

namespace mansard {
namespace {

[[noreturn]] void fail(const std::string& folder, int error) {
  Diagnostic d;
  d.text = "can not keep footprints in '" + folder + "': " + std::strerror(error);
  d.help = "TMPDIR=FOLDER before the command names another place for temporary files";
  throw Failure(std::move(d));
}

std::string folder_of_temporaries() {
  std::error_code none;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(none);
  return none ? "." : folder.string();
}

}  // namespace

RecordFile::~RecordFile() {
  if (file_ >= 0) close(file_);
}

void RecordFile::add(std::string_view record) {
  if (!last_.empty() && last_.size() + record.size() > capacity) flush();
  last_.reserve(capacity);
  last_ += record;
  ends_.push_back(flushed_ + last_.size());
}

void RecordFile::flush() {
  const std::string folder = folder_of_temporaries();
  if (file_ < 0) file_ = open_nameless(folder);
  if (file_ < 0) fail(folder, errno);
  for (std::size_t done = 0; done < last_.size();) {
    const ssize_t written = write(file_, last_.data() + done, last_.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(folder, written < 0 ? errno : ENOSPC);
    done += static_cast<std::size_t>(written);
  }
  flushed_ += last_.size();
  last_.clear();
}

void RecordFile::read(std::size_t number, std::string& record) const {
  const uint64_t begin = number == 0 ? 0 : ends_[number - 1];
  const std::size_t bytes = ends_[number] - begin;
  if (begin >= flushed_) {
    record.assign(last_, begin - flushed_, bytes);
    return;
  }
  record.resize(bytes);
  for (std::size_t done = 0; done < bytes;) {
    const ssize_t got =
        pread(file_, record.data() + done, bytes - done, static_cast<off_t>(begin + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail(folder_of_temporaries(), got < 0 ? errno : EIO);
    done += static_cast<std::size_t>(got);
  }
}

}  // namespace mansard
