// Entries of Elements and Materials that are too long for a line: an alternative a line.
#include <algorithm>

#include "grammar/layout.hpp"

namespace mansard::layout {

using namespace syntax;  // NOLINT: this file is about them

namespace {

std::vector<Span> pieces_of(const ElementAlternative& alternative) {
  std::vector<Span> pieces;
  for (const ExprPtr& mesh : alternative.meshes) pieces.push_back(mesh->at);
  return pieces;
}
std::vector<Span> pieces_of(const MaterialAlternative& alternative) {
  return alternative.look_spans;
}

}  // namespace

void Layout::write(const ElementEntry& made, Range range, int column) {
  entry(made, range, column);
}
void Layout::write(const MaterialEntry& made, Range range, int column) {
  entry(made, range, column);
}

template <class Entry>
void Layout::entry(const Entry& entry, Range range, int column) {
  range.first = preamble(entry.pre, range, column);
  const Page::Base base(page_, column + indentation);
  if (page_.fits(range, page_.padding(range)) || entry.alternatives.empty())
    return page_.put(range);
  const uint32_t sign = tokens_.first(entry.symbol.at) + 1;
  page_.put(Range{range.first, sign});
  const int left = page_.column(sign + 1);
  const Page::Base inner(page_, left);
  uint32_t first = sign + 1;
  const int weight = weight_column(entry.alternatives);
  for (const auto& one : entry.alternatives) {
    const bool bar = tokens_[first].text == "|";
    if (first > sign + 1) page_.line(bar ? left - 2 : left);
    if (bar) page_.put(first++);
    std::vector<Range> pieces;
    for (const Span piece : pieces_of(one)) pieces.push_back(this->range(piece));
    const Range here{first, tokens_.last(one.at)};
    const uint32_t colon = pieces.back().last + 1;
    if (one.weight && page_.flat({first, colon}))
      page_.pad(colon, std::max(0, weight - page_.width({first, colon - 1})));
    alternative(pieces, here);
    if (one.weight) page_.pad(colon, 0);
    first = here.last + 1;
  }
  if (first > range.last) return;
  if (!page_.fits({first, range.last}, 0)) page_.line(left);
  page_.put(Range{first, range.last});
}

/// Where the weights of all alternatives may stand below each other, from the left of each.
template <class Alternative>
int Layout::weight_column(const std::vector<Alternative>& alternatives) const {
  int column = 0;
  for (const Alternative& one : alternatives) {
    const Range all{tokens_.first(one.at), range(pieces_of(one).back()).last};
    if (one.weight && page_.flat({all.first, all.last + 1}))
      column = std::max(column, page_.width(all));
  }
  constexpr int widest = 60;
  return column > widest ? 0 : column;
}

void Layout::alternative(std::span<const Range> pieces, Range range) {
  if (page_.fits(range, page_.padding(range))) return page_.put(range);
  const int column = page_.column(range.first);
  for (const Range piece : pieces) {
    if (piece.first > range.first && !page_.fits(piece, 0)) page_.line(column);
    primary(piece, 0);
  }
  if (pieces.back().last == range.last) return;
  page_.put(pieces.back().last + 1);
  value({pieces.back().last + 2, range.last}, 0);
}

}  // namespace mansard::layout
