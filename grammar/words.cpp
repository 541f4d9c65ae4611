// Which words are keywords, and what a name is.
#include <algorithm>
#include <array>

#include "grammar/parse.hpp"

namespace mansard {

namespace {

constexpr std::array<std::string_view, 14> all{"style",    "class", "import",   "var",  "def",
                                               "abstract", "final", "override", "if",   "then",
                                               "else",     "super", "true",     "false"};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::span<const std::string_view> keywords() { return all; }

bool is_name(std::string_view text) {
  return !text.empty() && is_letter(text[0]) &&
         std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

}  // namespace mansard
