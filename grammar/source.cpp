#include "grammar/source.hpp"

#include <algorithm>
#include <cstring>

namespace mansard {

// A text over the limit is never parsed; its lines are not looked for, so that a hundred megabytes
// of line ends cost nothing.
Source::Source(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)), line_begins_{0} {
  if (text_.size() > max_bytes) return;
  const char* const begin = text_.data();
  const char* const end = begin + text_.size();
  for (const char* at = begin; at < end; ++at) {
    at = static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
    if (!at) break;
    line_begins_.push_back(static_cast<uint32_t>(at + 1 - begin));
  }
}

uint32_t Source::line_of(uint32_t offset) const {
  const auto after = std::upper_bound(line_begins_.begin(), line_begins_.end(), offset);
  return static_cast<uint32_t>(after - line_begins_.begin());
}

Source::Position Source::position(uint32_t offset) const {
  offset = std::min(offset, static_cast<uint32_t>(std::min<std::size_t>(text_.size(), UINT32_MAX)));
  const uint32_t line = line_of(offset);
  const auto characters =
      std::count_if(text_.begin() + line_begin(line), text_.begin() + offset,
                    [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  return {line, static_cast<uint32_t>(characters) + 1};
}

std::string_view Source::line(uint32_t line) const {
  const std::size_t begin = line_begin(line);
  const std::size_t end = line < line_begins_.size() ? line_begins_[line] - 1 : text_.size();
  std::string_view text = std::string_view(text_).substr(begin, end - begin);
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return text;
}

}  // namespace mansard
