// A script as words and signs, with the comments between them: what the formatter lays out.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "grammar/source.hpp"

namespace mansard::layout {

/// Everything between `//` and the line's end, or between `/*` and its `*/`.
struct Comment {
  std::string_view text;      ///< without space behind it
  int width = 0;              ///< columns of its last line
  bool to_line_end = false;   ///< a `//` comment
  bool own_line = false;      ///< first on its line
  bool ends_line = false;     ///< nothing but space follows it on its line
  bool blank_before = false;  ///< a blank line stands before it
  bool many_lines = false;
};

enum class Kind : uint8_t {
  word,    ///< a name, or a keyword where it stands as one
  number,  ///< with its unit: 2.5, 1r, 30%
  text,    ///< a string with its quotes
  sign,
  end  ///< of the file: has no text, only comments before it
};

struct Token {
  std::string_view text;
  uint32_t begin = 0, end = 0;  ///< offsets into the source
  Kind kind = Kind::sign;
  int width = 0;              ///< columns
  uint32_t match = 0;         ///< of a bracket: its partner
  uint32_t comments = 0;      ///< the first of those before it
  uint32_t comments_end = 0;  ///< behind the last of them
  bool keyword = false;
  bool call = false;          ///< a `(` of arguments or parameters, a `[` of an index
  bool prefix = false;        ///< a `-`, `!` or `~` before a value, an `@`
  bool glued = false;         ///< a unit against its parenthesis
  bool line_before = false;   ///< a line ends between the token before and this one
  bool blank_before = false;  ///< a blank line stands before it, behind its comments
};

/// The tokens of a script that parse() reads without errors. `class` is written `style`.
class Tokens {
 public:
  explicit Tokens(const Source& source);

  uint32_t count() const { return static_cast<uint32_t>(all_.size()); }  ///< with the end
  const Token& operator[](uint32_t i) const { return all_[i]; }
  const Comment& comment(uint32_t i) const { return comments_[i]; }
  /// The first that begins at `offset` or behind it.
  uint32_t from(uint32_t offset) const;
  /// The last that ends at `offset` or before it.
  uint32_t until(uint32_t offset) const { return from(offset) - 1; }
  uint32_t first(Span span) const { return from(span.begin); }
  uint32_t last(Span span) const { return until(span.end); }

 private:
  void read_space();
  void read_comment();
  Token read_token();
  uint32_t length_of(char first) const;
  uint32_t number_length() const;
  void classify(Token& token);
  void classify_sign(Token& token);
  void pair(Token& token);

  std::string_view text_;
  uint32_t at_ = 0;
  int line_ends_ = 0;       // since the last token or comment
  bool line_seen_ = false;  // since the last token
  std::vector<uint32_t> open_;
  std::vector<Token> all_;
  std::vector<Comment> comments_;
};

}  // namespace mansard::layout
