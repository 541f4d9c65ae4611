// Values that are too long for a line: broken before their loosest operators, behind commas, and
// before `then` and `else`.
#include "grammar/layout.hpp"

namespace mansard::layout {

namespace {

/// The looser, the smaller; 0 for what joins no two values.
int looseness(const Token& token) {
  if (token.kind != Kind::sign || token.prefix) return 0;
  if (token.text == "||") return 1;
  if (token.text == "&&") return 2;
  if (token.text == "+" || token.text == "-") return 4;
  if (token.text == "*" || token.text == "/") return 5;
  for (const std::string_view sign : {"<", "<=", ">", ">=", "==", "!="}) {
    if (token.text == sign) return 3;
  }
  return 0;
}

bool opens(const Token& token) { return token.text == "(" || token.text == "["; }

/// The operators of the loosest kind in a range, brackets passed over.
std::vector<uint32_t> loosest(const Tokens& tokens, Range range) {
  std::vector<uint32_t> found;
  int least = 6;
  for (uint32_t i = range.first; i <= range.last; ++i) {
    if (opens(tokens[i])) i = tokens[i].match;
    const int here = looseness(tokens[i]);
    if (here == 0 || here > least) continue;
    if (here < least) found.clear();
    least = here;
    found.push_back(i);
  }
  return found;
}

}  // namespace

void Layout::value(Range range, int tail) {
  if (page_.fits(range, tail)) return page_.put(range);
  const Page::Base base(page_, page_.column(range.first));
  if (tokens_[range.first].keyword && tokens_[range.first].text == "if") {
    return conditional(range, tail);
  }
  const std::vector<uint32_t> operators = loosest(tokens_, range);
  if (operators.empty()) return primary(range, tail);
  chain(range, operators, tail);
}

// if a then b
// else if c then d
// else e
void Layout::conditional(Range range, int tail) {
  const int column = page_.column(range.first);
  uint32_t depth = 0, from = range.first + 1;
  page_.put(range.first);
  for (uint32_t i = from; i <= range.last; ++i) {
    const Token& token = tokens_[i];
    if (opens(token)) i = token.match;
    if (!token.keyword) continue;
    if (token.text == "if") ++depth;
    if (token.text == "else" && depth > 0) {
      --depth;
    } else if (depth == 0 && (token.text == "then" || token.text == "else")) {
      value({from, i - 1}, 0);
      if (token.text == "else") page_.line(column);
      page_.put(i);
      from = i + 1;
      if (token.text == "then" || tokens_[from].text != "if") continue;
      page_.put(from++);
      ++i;
    }
  }
  value({from, range.last}, tail);
}

void Layout::chain(Range range, std::span<const uint32_t> operators, int tail) {
  const int column = page_.column(range.first);
  uint32_t from = range.first;
  for (std::size_t n = 0; n <= operators.size(); ++n) {
    const bool ends = n == operators.size();
    const Range operand{from, ends ? range.last : operators[n] - 1};
    if (n > 0) {
      if (!page_.fits({from - 1, operand.last}, ends ? tail : 0)) page_.line(column);
      page_.put(from - 1);
    }
    value(operand, ends ? tail : 0);
    from = operand.last + 2;
  }
}

void Layout::primary(Range range, int tail) {
  for (uint32_t i = range.first; i <= range.last; ++i) {
    const Range brackets{i, tokens_[i].match};
    if (opens(tokens_[i]) && brackets.last > i && brackets.last <= range.last) {
      const bool more = brackets.last < range.last && page_.flat({brackets.last, range.last});
      list(brackets, more ? page_.width({brackets.last + 1, range.last}) + tail : tail);
      i = brackets.last;
    } else {
      page_.put(i);
    }
  }
}

void Layout::list(Range range, int tail) {
  if (page_.fits(range, tail)) return page_.put(range);
  page_.put(range.first);
  const Range inside{range.first + 1, range.last - 1};
  if (inside.first <= inside.last) items(inside, page_.column(inside.first), tail + 1);
  page_.put(range.last);
}

// What commas part, as much in a line as fits.
void Layout::items(Range range, int column, int tail) {
  const Page::Base base(page_, column);
  for (uint32_t from = range.first; from <= range.last;) {
    uint32_t comma = from;
    while (comma <= range.last && tokens_[comma].text != ",") {
      comma = opens(tokens_[comma]) ? tokens_[comma].match + 1 : comma + 1;
    }
    const int behind = comma > range.last ? tail : 1;
    if (from > range.first && !page_.fits({from, comma - 1}, behind)) page_.line(column);
    item({from, comma - 1}, behind);
    if (comma <= range.last) page_.put(comma);
    from = comma + 1;
  }
}

// A size with its sign, or a value with its name.
void Layout::item(Range range, int tail) {
  if (range.last > range.first && tokens_[range.first + 1].text == "=") {
    page_.put(range.first++);
    page_.put(range.first++);
  }
  if (range.last > range.first && tokens_[range.first].text == "~") page_.put(range.first++);
  value(range, tail);
}

}  // namespace mansard::layout
