#include "grammar/lonely_brace.hpp"

#include <algorithm>
#include <vector>

namespace mansard {
namespace {

/// Where a line begins, and where its first character stands.
struct Line {
  std::size_t begin, first;
  std::size_t indent() const { return first - begin; }
};

Line line_of(std::string_view text, std::size_t at) {
  const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  return {begin, std::min(text.find_first_not_of(" \t", begin), at)};
}

/// The end of a string or comment that begins here, else the place itself.
std::size_t skipped(std::string_view text, std::size_t at, std::size_t end) {
  if (text[at] == '"') return std::min(text.find_first_of("\"\n", at + 1), end);
  return text.substr(at, 2) == "//" ? std::min(text.find('\n', at), end) : at;
}

}  // namespace

std::size_t lonely_brace(std::string_view text, std::size_t begin, std::size_t end) {
  std::vector<std::size_t> open;
  for (std::size_t at = begin; at < end; ++at) {
    at = skipped(text, at, end);
    if (at >= end) break;
    if (text[at] == '{') open.push_back(at);
    if (text[at] != '}' || open.empty()) continue;
    const Line line = line_of(text, at);
    const auto stands_as = [&](std::size_t brace) {
      return line_of(text, brace).indent() == line.indent();
    };
    // It closes a line's own brace: one further out that stands as far in is its partner.
    if (line.first == at && !stands_as(open.back()) &&
        std::any_of(open.begin(), open.end(), stands_as))
      return open.back();
    open.pop_back();
  }
  return begin;
}

}  // namespace mansard
