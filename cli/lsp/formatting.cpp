// The one layout of a script, as edits of the lines that differ.
#include <algorithm>

#include "cli/lsp/features.hpp"
#include "grammar/format.hpp"

namespace mansard::lsp {

namespace {

/// Whole lines that two texts begin with, in bytes.
std::size_t shared_begin(std::string_view a, std::string_view b) {
  const auto [end, other] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  const auto same = a.substr(0, static_cast<std::size_t>(end - a.begin()));
  const auto line = same.rfind('\n');
  return line == same.npos ? 0 : line + 1;
}

/// Whole lines that they end with.
std::size_t shared_end(std::string_view a, std::string_view b) {
  const auto [end, other] = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend());
  const auto length = static_cast<std::size_t>(end - a.rbegin());
  const auto line = a.substr(a.size() - length).find('\n');
  return line == a.npos ? 0 : length - line - 1;
}

}  // namespace

/// None for a text with syntax errors: they are shown as problems already.
Json formatting(Project& project, const Params& params) {
  const Cursor at = project.whole(params);
  const Source& source = *at.file->source;
  Diagnostics unheard;
  const std::optional<std::string> made = format(source, unheard);
  if (!made) return nullptr;
  std::string_view old_text = source.text(), new_text = *made;
  if (old_text == new_text) return Json::array({});
  const std::size_t begin = shared_begin(old_text, new_text);
  const std::size_t end = shared_end(old_text.substr(begin), new_text.substr(begin));
  const Range range = at.view->lines(source).range(static_cast<uint32_t>(begin),
                                                   static_cast<uint32_t>(old_text.size() - end));
  return Json::array(
      {Json::object({{"range", json(range)},
                     {"newText", new_text.substr(begin, new_text.size() - end - begin)}})});
}

}  // namespace mansard::lsp
