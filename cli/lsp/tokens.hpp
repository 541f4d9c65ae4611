// The tokens of a script, whatever is wrong with it: what completion goes by while a line is being
// written and the parser can not read it yet.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mansard::lsp {

enum class TokenKind : uint8_t { name, number, text, sign, comment };

struct Token {
  TokenKind kind;
  uint32_t begin, end;
  std::string_view text;  ///< of a text with its quotes

  bool is(std::string_view sign) const { return text == sign && kind != TokenKind::text; }
};

/// Every character that is no space belongs to one; `->` and `::` are one sign. A text that is not
/// closed ends with its line, a comment with the file.
std::vector<Token> tokens_of(std::string_view text);

/// The paths of the `import` lines.
std::vector<std::string> imported_paths(std::string_view text);

}  // namespace mansard::lsp
