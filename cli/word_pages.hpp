// What `mansard help WORD` says of a word that has no page of its own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mansard {

/// All that a word is: keyword, attribute, selector, part or argument of operations, annotation,
/// flag, sign, a text that an argument takes; each with where more is said. Empty for none of
/// these. Forms count as they are written: `1r`, `~1.2`, `@range`, `--camera`, `"gable"`.
std::string word_page(std::string_view word);

/// The words that have such a page, for suggestions.
std::vector<std::string_view> words_with_pages();

}  // namespace mansard
