// Files, styles, blocks and what stands in them, row by row.
#include <algorithm>

#include "grammar/layout.hpp"

namespace mansard::layout {

using namespace syntax;  // NOLINT: this file is about them

namespace {

using Top = std::variant<const Import*, const Style*>;

std::vector<Top> tops(const File& file) {
  std::vector<Top> all;
  for (const Import& import : file.imports) all.emplace_back(&import);
  for (const Style& style : file.styles) all.emplace_back(&style);
  std::sort(all.begin(), all.end(),
            [](const Top& a, const Top& b) { return place(a).begin < place(b).begin; });
  return all;
}

}  // namespace

Layout::Layout(const File& file, const Tokens& tokens)
    : tokens_(tokens), spacing_(file, tokens), page_(tokens, spacing_) {
  members(tops(file), 0, 0);
  page_.member_line(0);
  page_.put(tokens_.count() - 1);
}

// ---- members, many in a row where the author wrote them so

template <class Members>
void Layout::members(const Members& members, uint32_t first, int column) {
  const std::vector<Row> all = rows(members, first, column);
  const auto write_row = [&](const Row& row) {
    uint32_t at = row.first;
    page_.member_line(column);
    for (std::size_t i = row.member; i < row.member + row.members; ++i) {
      const Range here{at, tokens_.last(place(members[i]))};
      write(members[i], here, column);
      at = here.last + 1;
    }
  };
  align(all, column, page_, tokens_, write_row);
  for (const Row& row : all) write_row(row);
}

template <class Members>
std::vector<Row> Layout::rows(const Members& members, uint32_t first, int column) {
  std::vector<Row> all;
  bool goes_on = false, flows = false;
  int width = 0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Range here{first, tokens_.last(place(members[i]))};
    const bool flat = page_.flat(here);
    const int more = between_members + page_.width(here);
    const bool same_line = !spacing_.begins_line(first);
    const bool wanted = goes_on && flat && stands_in_row(members[i]) && !stands_apart(first) &&
                        (same_line || flows);
    const bool joins = wanted && column + width + more <= page_width;
    if (joins) {
      ++all.back().members;
      all.back().stops.push_back(first);
    } else {
      flows = wanted;  // a row that was too wide flows into the next ones
      all.emplace_back();
      all.back().member = i;
      all.back().first = all.back().line.first = first;
      all.back().apart = stands_apart(first);
    }
    Row& row = all.back();
    const std::size_t stops = row.stops.size();
    describe(members[i], here, column, row);
    row.line.last = here.last;
    const uint32_t begin = std::max(first, row.line.first);
    row.stops.erase(std::remove_if(row.stops.begin() + stops, row.stops.end(),
                                   [&](uint32_t stop) {
                                     return !page_.flat({begin, stop});
                                   }),
                    row.stops.end());
    width = joins ? width + more : page_.width(row.line);
    goes_on = stands_in_row(members[i]) && flat;
    first = here.last + 1;
  }
  return all;
}

bool Layout::stands_apart(uint32_t first) const {
  const Token& token = tokens_[first];
  bool apart = token.blank_before;
  for (uint32_t c = token.comments; c < token.comments_end; ++c) {
    apart = apart || tokens_.comment(c).own_line;
  }
  return apart;
}

// ---- which signs of a member stand below those of its neighbours

template <class... Kinds>
void Layout::describe(const std::variant<Kinds...>& member, Range range, int column, Row& row) {
  std::visit([&](const auto& one) { describe(one, range, column, row); }, member);
}

template <class Member>
void Layout::describe(const Member* member, Range range, int column, Row& row) {
  describe(*member, range, column, row);
}

template <class Member>
void Layout::describe(const Member& member, Range range, int column, Row& row) {
  if constexpr (requires { member.pre; }) {
    if (range.first == row.first) row.line.first = last_line(member.pre, range);
    row.apart = row.apart || row.line.first > row.first;
  }
  const auto stop = [&](uint32_t token, std::string_view sign, std::string_view key) {
    if (tokens_[token].text != sign) return;
    row.stops.push_back(token);
    row.key = key;
  };
  if constexpr (std::is_same_v<Member, Variable>) {
    stop(tokens_.first(member.name.at) + 1, "=", "var");
  } else if constexpr (std::is_same_v<Member, Function>) {
    stop(tokens_[tokens_.first(member.name.at) + 1].match + 1, "=", "def");
  } else if constexpr (requires { member.alternatives; }) {
    row.key = ":";
    if (member.kind != EntryKind::remove) row.stops.push_back(tokens_.first(member.symbol.at) + 1);
  } else if constexpr (std::is_same_v<Member, Block> || std::is_same_v<Member, Style>) {
    const bool one_line = page_.flat(range) && column + page_.width(range) <= page_width;
    if (one_line) stop(tokens_[range.last].match, "{", "{");
  } else if constexpr (std::is_same_v<Member, Rule>) {
    describe_rule(member, range, column, row);
  }
}

// ---- members

template <class... Kinds>
void Layout::write(const std::variant<Kinds...>& member, Range range, int column) {
  std::visit([&](const auto& one) { write(one, range, column); }, member);
}

template <class Member>
void Layout::write(const Member* member, Range range, int column) {
  write(*member, range, column);
}

void Layout::write(const Import& /*import*/, Range range, int /*column*/) { page_.put(range); }
void Layout::write(const Start& /*start*/, Range range, int column) {
  const Page::Base base(page_, column + indentation);
  page_.put(range);
}
void Layout::write(const AbstractSymbol& symbol, Range range, int column) {
  range.first = preamble(symbol.pre, range, column);
  const Page::Base base(page_, column + indentation);
  page_.put(range);
}
void Layout::write(const Function& function, Range range, int column) {
  declaration(function.pre, function.value, range, column);
}
void Layout::write(const Variable& variable, Range range, int column) {
  declaration(variable.pre, variable.value, range, column);
}

void Layout::declaration(const Preamble& before, const ExprPtr& is, Range range, int column) {
  range.first = preamble(before, range, column);
  const Page::Base base(page_, column + indentation);
  if (!is || page_.fits(range, page_.padding(range))) return page_.put(range);
  const uint32_t first = tokens_.first(is->at);
  page_.put(Range{range.first, first - 1});
  value({first, range.last}, 0);
}

void Layout::write(const Block& block, Range range, int column) {
  if (!begin(block.pre, range, column)) return;
  const uint32_t first = tokens_[range.last].match + 1;
  switch (block.kind) {
    case BlockKind::rules:
      members(block.items, first, column + indentation);
      break;
    case BlockKind::elements:
      members(block.elements, first, column + indentation);
      break;
    case BlockKind::materials:
      members(block.materials, first, column + indentation);
      break;
  }
  page_.closing_line(column);
  page_.put(range.last);
}

void Layout::write(const Style& style, Range range, int column) {
  if (!begin(style.pre, range, column)) return;
  members(style.members, tokens_[range.last].match + 1, column + indentation);
  page_.closing_line(column);
  page_.put(range.last);
}

/// Up to the '{'; false when all of it went into a line.
bool Layout::begin(const Preamble& before, Range range, int column) {
  range.first = preamble(before, range, column);
  const Page::Base base(page_, column);
  if (page_.fits(range, page_.padding(range))) return page_.put(range), false;
  const Range head{range.first, tokens_[range.last].match - 1};
  uint32_t colon = head.first;
  while (colon < head.last && tokens_[colon].text != ":") {
    colon = tokens_[colon].call ? tokens_[colon].match + 1 : colon + 1;
  }
  if (page_.fits(head, 2) || colon >= head.last) {
    page_.put(head);
  } else {
    page_.put(Range{head.first, colon});
    items({colon + 1, head.last}, page_.column(colon + 1), 2);
  }
  page_.put(head.last + 1);
  return true;
}

// ---- preambles

uint32_t Layout::last_line(const Preamble& preamble, Range range) const {
  uint32_t first = range.first;
  for (const Annotation& annotation : preamble.annotations) {
    const uint32_t next = tokens_.last(annotation.at) + 1;
    if (spacing_.begins_line(next)) first = std::max(first, next);
  }
  return first;
}

/// Writes the annotations that stand on lines of their own; returns what comes next.
uint32_t Layout::preamble(const Preamble& preamble, Range range, int column) {
  const uint32_t first = last_line(preamble, range);
  if (first == range.first) return first;
  const Page::Base base(page_, column);
  page_.put(Range{range.first, first - 1});
  page_.line(column);
  return first;
}

}  // namespace mansard::layout
