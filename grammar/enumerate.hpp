// Several words in a sentence.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace mansard {

/// "A", "A or B", "A, B or C".
inline std::string enumerate(std::span<const std::string> words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " " + std::string(last) + " " : ", ";
    text += words[i];
  }
  return text;
}

}  // namespace mansard
