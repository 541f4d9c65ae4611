// Between bytes of a text and the lines and characters that editors count.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "cli/lsp/json.hpp"

namespace mansard::lsp {

/// What an editor counts along a line: UTF-16 units unless it agreed on bytes.
enum class Encoding : uint8_t { utf16, utf8 };

/// From 0, as the protocol counts.
struct Position {
  uint32_t line = 0, character = 0;
  friend auto operator<=>(const Position&, const Position&) = default;
};
struct Range {
  Position start, end;
  friend auto operator<=>(const Range&, const Range&) = default;
};

Json json(Position position);
Json json(const Range& range);

/// The lines of a text, which must outlive it. Lines end with "\n", "\r\n" or "\r".
class Lines {
 public:
  Lines(std::string_view text, Encoding encoding);

  /// Behind the end of a line is its end, behind the last line the end of the text.
  uint32_t offset(Position position) const;
  Position position(uint32_t offset) const;
  Range range(uint32_t begin, uint32_t end) const { return {position(begin), position(end)}; }
  /// Without its line end; empty when there is no such line.
  std::string_view line(uint32_t number) const;

 private:
  uint32_t units(std::string_view text) const;

  std::string_view text_;
  Encoding encoding_;
  std::vector<uint32_t> begins_;
};

}  // namespace mansard::lsp
