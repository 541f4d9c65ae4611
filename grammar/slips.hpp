// Slips that people make, told from the place where the grammar got stuck.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/reading.hpp"

namespace mansard {

/// What stands at `at`, as the user would cut it into words: a name, a number, a string, a sign.
std::string_view found_at(std::string_view text, std::size_t at);

/// The brackets between two places of a script, strings and comments passed over.
struct Brackets {
  Brackets(std::string_view text, std::size_t begin, std::size_t end);
  bool has(std::string_view text, char bracket) const;

  std::vector<std::size_t> open;               ///< still open at the end
  std::size_t last_group = std::string::npos;  ///< the '{' whose '}' was met last
};

/// Where reading failed.
struct Stuck {
  std::string_view text;                    ///< the whole script
  std::size_t at = 0;                       ///< offset of the furthest place
  std::string_view found;                   ///< what stands there; empty at the end of the file
  std::span<const std::string_view> wants;  ///< what would have been right
  std::size_t member = 0;                   ///< offset of the member
  std::string_view word;                    ///< the first of the member
  char open = '{';                          ///< innermost bracket
  Level level = Level::file;
  uint32_t brief_variable_end = 0;  ///< of the last `var X 1`

  bool wanted(std::string_view want) const;
};

/// What was probably meant, as the help of a message; empty when nobody can tell.
std::string explain_slip(const Stuck& stuck);

}  // namespace mansard
