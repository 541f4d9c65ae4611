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
};

/// Keywords, and words that mean something in their place only (`start`, `per`, `Elements`).
std::span<const WordRow> word_rows();
const WordRow* find_word(std::string_view name);

/// "detrude(depth) { inner | reveal }"
std::string usage(const Operation& operation);

}  // namespace mansard
