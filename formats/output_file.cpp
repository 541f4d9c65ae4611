#include "formats/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>

#include "grammar/diagnostic.hpp"

namespace mansard {

namespace fs = std::filesystem;

OutputFile::OutputFile(const std::string& path)
    : path_(path), buffer_(new char[capacity]), at_(buffer_.get()) {
  struct stat status;
  const bool exists = stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && access(path.c_str(), W_OK) != 0) fail(errno);
  regular_ = !exists || S_ISREG(status.st_mode);
  if (!regular_) {
    file_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) fail(errno);
    return;
  }
  // A link stays a link: what it points to is replaced.
  std::error_code unresolved;
  if (exists) mode_ = status.st_mode & 0777;
  target_ = exists ? fs::canonical(path, unresolved).string() : path;
  if (unresolved) target_ = path;
  static std::atomic<unsigned> count = 0;
  temporary_ = target_ + "." + std::to_string(getpid()) + "-" + std::to_string(count++) + ".part";
  open_temporary();
}

/// Without a name where the file system can: then not even a killed program leaves a file behind.
void OutputFile::open_temporary() {
  const fs::path folder = fs::path(target_).parent_path();
  if (access("/proc/self/fd", X_OK) == 0) {
    file_ = open(folder.empty() ? "." : folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
    nameless_ = file_ >= 0;
  }
  if (!nameless_) file_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file_ < 0) {
    temporary_.clear();
    fail(errno);
  }
  if (mode_ >= 0) fchmod(file_, static_cast<mode_t>(mode_));
}

OutputFile::~OutputFile() {
  if (file_ >= 0) close(file_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::put(std::string_view text) {
  if (text.empty()) return;
  if (text.size() <= block) {
    char* const to = room(text.size());
    std::memcpy(to, text.data(), text.size());
    return advance(to + text.size());
  }
  flush();
  write_out(text);
}

uint64_t OutputFile::copy_from(int file, uint64_t bytes) {
  flush();
  off_t at = 0;
  for (uint64_t left = bytes; left > 0; left = bytes - static_cast<uint64_t>(at)) {
    const ssize_t copied = copy_file_range(file, &at, file_, nullptr, left, 0);
    if (copied < 0 && errno == EINTR) continue;
    if (copied <= 0) break;
    flushed_ += static_cast<std::size_t>(copied);
  }
  return static_cast<uint64_t>(at);
}

void OutputFile::commit() {
  flush();
  if (nameless_) {
    const std::string open_file = "/proc/self/fd/" + std::to_string(file_);
    if (linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) != 0)
      fail(errno);
  }
  const int closed = close(file_);
  file_ = -1;
  if (closed != 0) fail(errno);
  if (!temporary_.empty() && rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void OutputFile::flush() {
  write_out({buffer_.get(), std::size_t(at_ - buffer_.get())});
  at_ = buffer_.get();
}

void OutputFile::write_out(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(written < 0 ? errno : ENOSPC);
    text.remove_prefix(static_cast<std::size_t>(written));
    flushed_ += static_cast<std::size_t>(written);
  }
}

void OutputFile::fail(int error) const {
  Diagnostic d;
  d.text = "can not write '" + path_ + "': " + std::strerror(error);
  if (error == ENOENT) d.help = "make the folder first";
  throw Failure(std::move(d));
}

}  // namespace mansard
