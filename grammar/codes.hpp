// The table of diagnostics that have a page of their own in `mansard help`.
#pragma once

#include <span>
#include <string_view>

namespace mansard {

struct CodePage {
  std::string_view code;   ///< "W002"
  std::string_view title;  ///< one sentence
  std::string_view page;   ///< why it matters, an example, what to do
};

std::span<const CodePage> code_pages();
const CodePage* find_code(std::string_view code);
/// Whether warnings of one place are told each that says something else, not only the first:
/// properties that can not be read, and what is wrong with roofs.
bool each_text_is_news(std::string_view code);

}  // namespace mansard
