#include "cli/lsp/positions.hpp"

#include <algorithm>

#include "grammar/utf8.hpp"

namespace mansard::lsp {

Json json(Position position) {
  return Json::object({{"line", position.line}, {"character", position.character}});
}

Json json(const Range& range) {
  return Json::object({{"start", json(range.start)}, {"end", json(range.end)}});
}

Lines::Lines(std::string_view text, Encoding encoding)
    : text_(text), encoding_(encoding), begins_{0} {
  for (std::size_t at = text.find_first_of("\r\n"); at != text.npos;
       at = text.find_first_of("\r\n", at)) {
    at += text.substr(at, 2) == "\r\n" ? 2 : 1;
    begins_.push_back(static_cast<uint32_t>(at));
  }
}

std::string_view Lines::line(uint32_t number) const {
  if (number >= begins_.size()) return {};
  const std::size_t end = number + 1 < begins_.size() ? begins_[number + 1] : text_.size();
  std::string_view line = text_.substr(begins_[number], end - begins_[number]);
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
  return line;
}

uint32_t Lines::offset(Position position) const {
  if (position.line >= begins_.size()) return static_cast<uint32_t>(text_.size());
  const std::string_view text = line(position.line);
  std::size_t at = 0;
  for (uint32_t passed = 0; at < text.size();) {
    const CodePoint c = decode(text, at);
    passed += units(text.substr(at, c.bytes));
    if (passed > position.character) break;
    at += c.bytes;
  }
  return begins_[position.line] + static_cast<uint32_t>(at);
}

Position Lines::position(uint32_t offset) const {
  offset = std::min(offset, static_cast<uint32_t>(text_.size()));
  const auto after = std::upper_bound(begins_.begin(), begins_.end(), offset);
  const auto number = static_cast<uint32_t>(after - begins_.begin()) - 1;
  return {number, units(text_.substr(begins_[number], offset - begins_[number]))};
}

uint32_t Lines::units(std::string_view text) const {
  if (encoding_ == Encoding::utf8) return static_cast<uint32_t>(text.size());
  uint32_t count = 0;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint c = decode(text, at);
    count += c.value > 0xFFFF ? 2 : 1;
    at += c.bytes;
  }
  return count;
}

}  // namespace mansard::lsp
