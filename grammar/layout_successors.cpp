// Rules and what stands to the right of their arrows.
#include <algorithm>

#include "grammar/layout.hpp"

namespace mansard::layout {

using namespace syntax;  // NOLINT: this file is about them

namespace {

constexpr int braces = 2;       // columns of " }"
constexpr int arrow_width = 3;  // of "-> "
constexpr int short_operation = 8;
constexpr int most_attempts = 1;  // nested in each other; each takes three times as long
constexpr int short_head = 40;
constexpr int far_right = 60;
constexpr int widest_label = 24, widest_guard = 28;

}  // namespace

// ---- rules

uint32_t Layout::guard_colon(const Rule& rule) const {
  if (!rule.guard && !rule.guard_else) return 0;
  uint32_t i = tokens_.first(rule.name.at) + 1;
  while (tokens_[i].text != ":") i = tokens_[i].call ? tokens_[i].match + 1 : i + 1;
  return i;
}

Layout::RuleParts Layout::parts_of(const Rule& rule, Range range) const {
  const uint32_t arrow = tokens_.from(rule.head.end);
  const uint32_t end = tokens_.last(rule.successor.back().at);
  return {{range.first, arrow - 1}, {arrow + 1, end}, {end + 1, range.last}};
}

// In one line. Else the successor in one line, behind an arrow that begins it. Else the successor
// broken, behind its head or, where that leaves too little room, behind an arrow on a new line.
void Layout::write(const Rule& rule, Range range, int column) {
  range.first = preamble(rule.pre, range, column);
  arrow_dropped_ = false;
  const Page::Base base(page_, column + indentation);
  if (page_.fits(range, page_.padding(range))) return page_.put(range);
  const RuleParts parts = parts_of(rule, range);
  const Range weighted{parts.body.first, range.last};
  rule_head(rule, parts.head);
  const int dropped_column = column + indentation;
  const bool one_line =
      page_.flat(weighted) && dropped_column + arrow_width + page_.width(weighted) <= page_width;
  const auto write_rest = [&](bool dropped) {
    if (dropped) page_.line(dropped_column);
    successor(rule, parts);
  };
  const bool guarded = rule.guard || rule.guard_else;
  const int behind = page_.column(parts.head.last + 1) - column;
  bool dropped = (guarded && one_line) || behind > short_head;
  if (!dropped) {
    const Page::Cost here = page_.cost([&] { write_rest(false); });
    const Page::Cost below = page_.cost([&] { write_rest(true); });
    dropped = below.excess < here.excess || (guarded && below.lines < here.lines);
  }
  write_rest(dropped);
  arrow_dropped_ = dropped;
}

/// The productions of a symbol align what they ask, other rules their arrows.
void Layout::describe_rule(const Rule& rule, Range range, int column, Row& row) {
  const uint32_t colon = guard_colon(rule);
  const RuleParts parts = parts_of(rule, range);
  row.key = colon ? rule.name.text : "->";
  if (colon > 0) {
    row.all_or_none = true;
    row.most_padding = widest_guard;
  }
  const Range line{row.line.first, range.last};
  const bool one_line = page_.flat(line) && column + page_.width(line) <= page_width;
  if (!one_line) {
    page_.cost([&] {
      page_.member_line(column);
      write(rule, range, column);
    });
    const Range head{row.line.first, parts.head.last};
    const bool head_fits = page_.flat(head) && column + page_.width(head) <= page_width;
    if (!head_fits) return;
  }
  if (colon) row.stops.push_back(colon);
  if (!one_line && arrow_dropped_) return;
  row.stops.push_back(parts.head.last + 1);
  if (one_line && rule.probability) row.weight = parts.probability.first;
  row.symbol = rule.name.text;
}

void Layout::rule_head(const Rule& rule, Range range) {
  const uint32_t colon = guard_colon(rule);
  if (colon == 0 || page_.fits(range, page_.padding(range) + arrow_width)) return page_.put(range);
  uint32_t guard = colon + 1;
  if (rule.guard_else) ++guard;
  page_.put(Range{range.first, guard - 1});
  if (rule.guard) value({guard, range.last}, arrow_width);
}

void Layout::successor(const Rule& rule, const RuleParts& parts) {
  const bool weighted = rule.probability != nullptr;
  const Range weight = parts.probability;
  page_.put(parts.head.last + 1);
  body(rule.successor, parts.body, weighted && page_.flat(weight) ? page_.width(weight) + 1 : 0);
  if (!weighted) return;
  page_.put(weight.first);
  value({weight.first + 1, weight.last}, 0);
}

// ---- successors

// As many elements in a line as fit; behind one of several lines the next begins a line.
void Layout::body(const Body& body, Range range, int tail) {
  if (page_.fits(range, tail)) return page_.put(range);
  const int column = page_.column(range.first);
  const Page::Base base(page_, column);
  uint32_t first = range.first;
  bool broken = false;
  for (const Element& one : body) {
    const Range here{first, tokens_.last(one.at)};
    const int behind = &one == &body.back() ? tail : 0;
    if (first > range.first && (broken || !page_.fits(here, behind))) page_.line(column);
    broken = !page_.fits(here, behind);
    element(one, here, behind);
    first = here.last + 1;
  }
}

void Layout::element(const Element& element, Range range, int tail) {
  if (page_.fits(range, tail)) return page_.put(range);
  const Page::Base base(page_, page_.column(range.first));
  if (const auto* made = std::get_if<Emit>(&element.is)) return emit(*made, range, tail);
  if (const auto* made = std::get_if<Push>(&element.is)) return push(*made, range, tail);
  if (const auto* made = std::get_if<If>(&element.is)) return if_chain(*made, range, tail);
  page_.put(range);
}

// The parts stand below the operation when that keeps them in one line, or when it is long; a
// single part goes where it takes fewer lines.
void Layout::emit(const Emit& emit, Range range, int tail) {
  if (!emit.parts) return primary(range, tail);
  const int column = page_.column(range.first);
  const uint32_t open = tokens_.first(emit.parts->at);
  const Range operation{range.first, open - 1}, list{open, range.last};
  const bool one_line = page_.fits(operation, 0);
  if (one_line) {
    page_.put(operation);
  } else {
    primary(operation, 0);
  }
  const int width = page_.column(open) - 1 - column;
  const bool fits_below = page_.flat(list) && column + page_.width(list) + tail <= page_width;
  const auto write_parts = [&](bool beside) {
    if (!beside) page_.line(column);
    ++nesting_;
    parts(emit.parts->parts, list, tail);
    --nesting_;
  };
  bool beside = one_line && page_.column(open) <= far_right && width <= short_operation;
  const bool either = one_line && !beside && !fits_below && emit.parts->parts.size() == 1;
  if (either && nesting_ < most_attempts) {
    beside = page_.cost([&] { write_parts(true); }) <= page_.cost([&] { write_parts(false); });
  }
  write_parts(beside);
}

// { one
// | two }
void Layout::parts(const std::vector<Part>& parts, Range range, int tail) {
  if (page_.fits(range, tail)) return page_.put(range);
  const uint32_t open = range.first, close = tokens_[open].match;
  const int column = page_.column(open);
  const int label = label_width(parts);
  const Page::Base base(page_, column);
  page_.put(open);
  uint32_t first = open + 1;
  for (const Part& one : parts) {
    const bool last = &one == &parts.back();
    if (first > open + 1) {
      page_.line(column);
      page_.put(first - 1);
    }
    const Range here{first, tokens_.last(one.at)};
    part(one, here, label, last ? tail + braces + static_cast<int>(range.last - close) : 0);
    first = here.last + 2;
  }
  page_.put(Range{close, range.last});
}

int Layout::label_width(const std::vector<Part>& parts) const {
  int widest = 0;
  for (const Part& one : parts) {
    if (!one.label) continue;
    const Range label{tokens_.first(one.label->at), tokens_.last(one.label->at) + 1};
    if (page_.flat(label)) widest = std::max(widest, page_.width(range(one.label->at)));
  }
  return widest > widest_label ? 0 : widest;
}

void Layout::part(const Part& part, Range range, int label, int tail) {
  if (!part.group.empty()) return parts(part.group, range, tail);
  if (part.label) {
    const uint32_t colon = tokens_.last(part.label->at) + 1;
    if (page_.flat({range.first, colon}))
      page_.pad(colon, std::max(0, label - page_.width({range.first, colon - 1})));
    page_.put(Range{range.first, colon});
    page_.pad(colon, 0);
    range.first = colon + 1;
  }
  body(part.body, range, tail);
}

void Layout::push(const Push& push, Range range, int tail) {
  page_.put(range.first);
  body(push.body, {range.first + 1, range.last - 1}, tail + braces);
  page_.put(range.last);
}

// if a { A }
// else if b { B }
// else { C }
void Layout::if_chain(const If& chain, Range range, int tail) {
  const int column = page_.column(range.first);
  uint32_t first = range.first;
  for (const IfArm& arm : chain.arms) {
    const Range inner{tokens_.first(arm.body.front().at), tokens_.last(arm.body.back().at)};
    const Range branch{inner.first - 1, inner.last + 1};
    const int behind = &arm == &chain.arms.back() ? tail : 0;
    if (first > range.first) page_.line(column);
    if (page_.fits({first, branch.last}, behind)) {
      page_.put(Range{first, branch.last});
    } else {
      while (tokens_[first].keyword &&
             (tokens_[first].text == "if" || tokens_[first].text == "else"))
        page_.put(first++);
      if (arm.condition) value({first, branch.first - 1}, braces);
      const bool below = page_.flat(branch) && !page_.fits(branch, behind) &&
                         column + braces + page_.width(branch) + behind <= page_width;
      if (below) page_.line(column + braces);
      page_.put(branch.first);
      body(arm.body, inner, behind + braces);
      page_.put(branch.last);
    }
    first = branch.last + 1;
  }
}

}  // namespace mansard::layout
