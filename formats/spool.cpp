#include "formats/spool.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "formats/nameless_file.hpp"
#include "grammar/diagnostic.hpp"

namespace mansard {

Spool::Spool(std::string model) : model_(std::move(model)), buffer_(new char[capacity]) {
  const std::filesystem::path given = std::filesystem::path(model_).parent_path();
  file_ = open_nameless(given.empty() ? "." : given.string());
  if (file_ < 0) fail(errno);
}

Spool::~Spool() { close(file_); }

void Spool::put(const void* bytes, std::size_t count) {
  const char* from = static_cast<const char*>(bytes);
  while (count > 0) {
    if (at_ == capacity) flush();
    const std::size_t part = std::min(count, capacity - at_);
    std::memcpy(buffer_.get() + at_, from, part);
    at_ += part;
    from += part;
    count -= part;
  }
}

void Spool::align() {
  constexpr char zeros[4] = {};
  put(zeros, (4 - bytes() % 4) % 4);
}

void Spool::flush() {
  for (std::size_t done = 0; done < at_;) {
    const ssize_t written = write(file_, buffer_.get() + done, at_ - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(written < 0 ? errno : ENOSPC);
    done += static_cast<std::size_t>(written);
  }
  flushed_ += at_;
  at_ = 0;
}

void Spool::copy_to(OutputFile& out) {
  flush();
  for (uint64_t at = out.copy_from(file_, flushed_); at < flushed_;) {
    char* const room = out.room(OutputFile::block);
    const ssize_t got = pread(file_, room, OutputFile::block, static_cast<off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail(got < 0 ? errno : EIO);
    out.advance(room + got);
    at += static_cast<uint64_t>(got);
  }
}

void Spool::fail(int error) const {
  Diagnostic d;
  d.text = "can not write beside '" + model_ + "': " + std::strerror(error);
  if (error == ENOENT) d.help = "make the folder first";
  throw Failure(std::move(d));
}

}  // namespace mansard
