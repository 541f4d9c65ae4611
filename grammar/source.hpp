// Source text and places in it. A Source owns its text and never moves; everything else holds
// spans.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace mansard {

class Source {
 public:
  /// A longer text is refused by parse() and counts as one line.
  static constexpr std::size_t max_bytes = 4 << 20;

  Source(std::string name, std::string text);
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }

  struct Position {
    uint32_t line = 1;    ///< from 1
    uint32_t column = 1;  ///< from 1, in characters (UTF-8 code points)
  };
  Position position(uint32_t offset) const;
  uint32_t line_of(uint32_t offset) const;
  /// Without its line end; line counts from 1.
  std::string_view line(uint32_t line) const;
  uint32_t line_begin(uint32_t line) const { return line_begins_[line - 1]; }

 private:
  std::string name_, text_;
  std::vector<uint32_t> line_begins_;
};

/// A half-open range of characters of a source. An empty span (no source) means "nowhere".
struct Span {
  const Source* source = nullptr;
  uint32_t begin = 0, end = 0;

  explicit operator bool() const { return source != nullptr; }
  std::string_view text() const {
    return source ? source->text().substr(begin, end - begin) : std::string_view{};
  }
  friend bool operator==(const Span&, const Span&) = default;
};

/// From the start of a to the end of b, of the same source.
inline Span join(Span a, Span b) { return a ? Span{a.source, a.begin, b.end} : b; }

/// Owns sources at stable addresses.
class Sources {
 public:
  const Source& add(std::string name, std::string text) {
    return all_.emplace_back(std::move(name), std::move(text));
  }

 private:
  std::deque<Source> all_;
};

}  // namespace mansard
