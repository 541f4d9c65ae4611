// UTF-8: what a byte sequence stands for, and how wide a terminal draws it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace mansard {

struct CodePoint {
  char32_t value = 0;  ///< U+FFFD for an invalid byte
  uint32_t bytes = 1;  ///< how many it took; 1 for an invalid byte
  bool valid = true;
};

/// The character at `at`, which must be inside the text. Overlong forms, surrogates and values
/// above U+10FFFF are invalid.
CodePoint decode(std::string_view text, std::size_t at);

/// Appends a character that decode() would return.
void encode(char32_t character, std::string& text);

/// Columns of a terminal: 0 for combining marks, 2 for East Asian wide characters and emoji.
int columns(char32_t character);

}  // namespace mansard
