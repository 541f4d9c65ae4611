// The words of the language with a sentence on each, for help and editors. Operations, functions,
// attributes and selectors have tables of their own in the interpreter.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "interpreter/operation.hpp"

namespace mansard {

struct WordRow {
  std::string_view name, summary;
  std::string_view topic;  ///< mansard help TOPIC says more
};

/// Keywords, and words that mean something in their place only (`start`, `per`, `Elements`).
std::span<const WordRow> word_rows();
const WordRow* find_word(std::string_view name);
/// "->", "::", "~", "r" (of 1r): the signs of the language.
const WordRow* find_sign(std::string_view sign);

/// "detrude(depth) { inner | reveal }"
std::string usage(const Operation& operation);

}  // namespace mansard
