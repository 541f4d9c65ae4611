#include "cli/lsp/frames.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <utility>

namespace mansard::lsp {

namespace {

constexpr std::string_view length_word = "content-length:";
constexpr std::string_view type_word = "content-type:";
constexpr std::size_t longest_header = 4096;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::size_t find_word(std::string_view text, std::string_view word, std::size_t from) {
  const auto found =
      std::search(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(), word.begin(),
                  word.end(), [](char a, char b) { return lower(a) == b; });
  return found == text.end() ? text.npos : static_cast<std::size_t>(found - text.begin());
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

}  // namespace

FrameReader::Frame FrameReader::next(int milliseconds) {
  for (;;) {
    if (auto frame = take()) return *std::move(frame);
    if (ended_) return {Got::end, {}};
    if (!fill(milliseconds) && timed_out_) return {Got::nothing, {}};
  }
}

void FrameReader::give_back(std::string_view text) {
  const std::size_t at = find_word(text, length_word, 0);
  if (at == text.npos) return;
  buffer_.replace(0, begin_, text.substr(at));
  begin_ = 0;
}

// What stands in the buffer, if it is whole.
std::optional<FrameReader::Frame> FrameReader::take() {
  const std::size_t drop = std::min(discard_, buffer_.size() - begin_);
  begin_ += drop;
  discard_ -= drop;
  const std::size_t header = find_word(buffer_, length_word, begin_);
  if (header == buffer_.npos) {
    const std::size_t waiting = buffer_.size() - begin_;
    if (waiting <= longest_header) return std::nullopt;
    return broken(waiting - length_word.size(), "there is no Content-Length");
  }
  const std::string_view before = std::string_view(buffer_).substr(begin_, header - begin_);
  if (!is_blank(before) && find_word(before, type_word, 0) != 0)
    return broken(before.size(), "there is text between messages");
  return take_body(header);
}

std::optional<FrameReader::Frame> FrameReader::take_body(std::size_t header) {
  const std::string_view rest = std::string_view(buffer_).substr(header);
  std::size_t end = rest.find("\r\n\r\n"), gap = 4;
  if (const std::size_t bare = rest.find("\n\n"); bare < end) end = bare, gap = 2;
  if (end == rest.npos || end > longest_header) {
    if (rest.size() <= longest_header) return std::nullopt;
    return broken(header + length_word.size() - begin_, "the header does not end");
  }
  const char* at = rest.data() + length_word.size();
  while (*at == ' ' || *at == '\t') ++at;
  std::size_t length = 0;
  const auto [after, error] = std::from_chars(at, rest.data() + end, length);
  if (error != std::errc() || (*after != '\r' && *after != '\n' && *after != ' '))
    return broken(header + end + gap - begin_, "Content-Length is no number");
  const std::size_t body = header + end + gap;
  if (length > max_bytes) {
    discard_ = length;
    return broken(body - begin_, "a message is longer than 64 MB");
  }
  if (buffer_.size() - body < length) return std::nullopt;
  Frame frame{Got::message, buffer_.substr(body, length)};
  begin_ = body + length;
  complained_ = false;
  return frame;
}

FrameReader::Frame FrameReader::broken(std::size_t skip, std::string why) {
  begin_ += skip;
  if (std::exchange(complained_, true)) return {Got::nothing, {}};  // once for a stretch of it
  return {Got::broken, std::move(why)};
}

// False when nothing came: at the end, or in this time.
bool FrameReader::fill(int milliseconds) {
  if (begin_ > 0) {
    buffer_.erase(0, begin_);
    begin_ = 0;
  }
  timed_out_ = false;
  pollfd waiting{in_, POLLIN, 0};
  const int ready = poll(&waiting, 1, milliseconds);
  if (ready < 0 && errno == EINTR) return false;
  if (ready == 0) {
    timed_out_ = true;
    return false;
  }
  std::array<char, 1 << 16> chunk;
  const ssize_t count = read(in_, chunk.data(), chunk.size());
  if (count < 0 && errno == EINTR) return false;
  if (count <= 0) {
    ended_ = true;
    return false;
  }
  buffer_.append(chunk.data(), static_cast<std::size_t>(count));
  return true;
}

bool write_frame(int out, std::string_view text) {
  std::string frame = "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n";
  frame += text;
  for (std::size_t written = 0; written < frame.size();) {
    const ssize_t count = write(out, frame.data() + written, frame.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    written += static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace mansard::lsp
