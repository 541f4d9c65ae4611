#include "grammar/spacing.hpp"

#include <algorithm>

namespace mansard::layout {

using namespace syntax;  // NOLINT: this file is about them

Spacing::Spacing(const File& file, const Tokens& tokens)
    : tokens_(tokens), gaps_(tokens.count()), begins_line_(tokens.count()) {
  for (uint32_t i = 1; i < tokens.count(); ++i) gaps_[i] = plain_gap(i);
  for (const Import& import : file.imports) begins_line_[tokens.first(import.at) - 1] = true;
  for (const Style& one : file.styles) style(one);
  begins_line_[tokens.count() - 1] = true;
  measure();
}

int Spacing::width(Range range) const {
  return ends_[range.last] - ends_[range.first] + tokens_[range.first].width;
}

// ---- what the tokens say

namespace {

bool is_any(std::string_view text, std::initializer_list<std::string_view> all) {
  return std::find(all.begin(), all.end(), text) != all.end();
}

}  // namespace

int Spacing::plain_gap(uint32_t i) const {
  const Token& token = tokens_[i];
  const Token& before = tokens_[i - 1];
  if (token.glued || before.prefix) return 0;
  if (is_any(before.text, {"(", "[", ".", "::"})) return 0;
  if (is_any(token.text, {",", ")", "]", ".", "::"})) return 0;
  if (token.call) return 0;
  if (token.text == "*" && before.text == "}") return 0;
  return 1;
}

int Spacing::gap_behind_comment(uint32_t token) const {
  const bool closes = is_any(tokens_[token].text, {",", ")", "]"});
  return closes ? gaps_[token] : 1;
}

int Spacing::gap_before_comment(uint32_t token) const {
  return token > 0 && is_any(tokens_[token - 1].text, {"(", "["}) ? gaps_[token] : 1;
}

// ---- what the tree says

void Spacing::style(const Style& style) {
  const uint32_t close = tokens_.last(style.at), open = tokens_[close].match;
  annotations(style.pre);
  members(style.members, open, close, [&](const StyleMember& member) {
    if (const auto* inner = std::get_if<Block>(&member)) block(*inner);
    if (const auto* inner = std::get_if<Variable>(&member)) variable(*inner);
    if (const auto* inner = std::get_if<Function>(&member)) annotations(inner->pre);
  });
}

void Spacing::block(const Block& block) {
  const uint32_t close = tokens_.last(block.at), open = tokens_[close].match;
  annotations(block.pre);
  members(block.items, open, close, [&](const BlockItem& item) {
    if (const auto* made = std::get_if<Variable>(&item)) variable(*made);
    if (const auto* made = std::get_if<Function>(&item)) annotations(made->pre);
    if (const auto* made = std::get_if<Rule>(&item)) annotations(made->pre), body(made->successor);
  });
  members(block.elements, open, close, [&](const ElementEntry& made) { entry(made); });
  members(block.materials, open, close, [&](const MaterialEntry& made) { entry(made); });
}

template <class Members, class Inside>
void Spacing::members(const Members& members, uint32_t open, uint32_t close, Inside inside) {
  bool one_line = true;
  for (uint32_t i = open + 1; i <= close; ++i) one_line = one_line && !tokens_[i].line_before;
  uint32_t first = open + 1;
  bool row = false;
  for (const auto& member : members) {
    const bool joined = row && stands_in_row(member) && !tokens_[first].line_before;
    begins_line_[first] = !one_line && !joined;
    if (first > open + 1) gaps_[first] = between_members;
    inside(member);
    row = stands_in_row(member);
    first = tokens_.last(place(member)) + 1;
  }
  const Token& end = tokens_[close];
  if (!one_line && (first > open + 1 || end.comments != end.comments_end))
    begins_line_[close] = true;
}

void Spacing::variable(const Variable& variable) {
  annotations(variable.pre);
  if (variable.value) gaps_[tokens_.first(variable.value->at)] = 1;
}

// What follows an annotation keeps a line of its own.
void Spacing::annotations(const Preamble& preamble) {
  for (const Annotation& annotation : preamble.annotations) {
    const uint32_t next = tokens_.last(annotation.at) + 1;
    if (tokens_[next].line_before) begins_line_[next] = true;
  }
}

template <class Entry>
void Spacing::entry(const Entry& entry) {
  annotations(entry.pre);
  std::vector<uint32_t> firsts;
  bool broken = false;
  for (const auto& alternative : entry.alternatives) {
    uint32_t first = tokens_.first(alternative.at);
    if (tokens_[first - 1].text == "|") --first;
    if (&alternative == &entry.alternatives.front()) continue;
    firsts.push_back(first);
    broken = broken || tokens_[first].line_before;
    if (tokens_[first].text != "|") gaps_[first] = between_alternatives;
  }
  for (const uint32_t first : firsts) begins_line_[first] = broken;
  if constexpr (requires { entry.per; }) {
    if (entry.per) gaps_[tokens_.first(entry.per->at) - 1] = between_alternatives;
  }
}

void Spacing::body(const Body& body) {
  for (const Element& one : body) element(one);
}

void Spacing::element(const Element& element) {
  if (const auto* emit = std::get_if<Emit>(&element.is)) {
    if (emit->parts) parts(emit->parts->parts);
  } else if (const auto* push = std::get_if<Push>(&element.is)) {
    const uint32_t open = tokens_.first(element.at), close = tokens_[open].match;
    gaps_[open] = gaps_[open + 1] = gaps_[close] = 1;
    body(push->body);
  } else if (const auto* chain = std::get_if<If>(&element.is)) {
    if_chain(*chain);
  }
}

void Spacing::if_chain(const If& chain) {
  std::vector<uint32_t> elses;
  bool broken = false;
  for (const IfArm& arm : chain.arms) {
    body(arm.body);
    if (&arm == &chain.arms.back()) break;
    elses.push_back(tokens_.last(arm.body.back().at) + 2);
    broken = broken || tokens_[elses.back()].line_before;
  }
  for (const uint32_t one : elses) begins_line_[one] = broken;
}

void Spacing::parts(const std::vector<Part>& parts) {
  std::vector<uint32_t> bars;
  bool broken = false;
  for (const Part& part : parts) {
    body(part.body);
    if (!part.group.empty()) this->parts(part.group);
    if (&part == &parts.back()) break;
    const uint32_t bar = tokens_.last(part.at) + 1;
    bars.push_back(bar);
    broken = broken || tokens_[bar].line_before || tokens_[bar + 1].line_before;
  }
  for (const uint32_t bar : bars) begins_line_[bar] = broken;
}

// ---- sums

void Spacing::measure() {
  uint32_t line = 0;
  int end = 0;
  for (uint32_t i = 0; i < tokens_.count(); ++i) {
    const Token& token = tokens_[i];
    bool begins = begins_line_[i];
    for (uint32_t c = token.comments; c < token.comments_end; ++c) {
      const Comment& comment = tokens_.comment(c);
      begins = begins || comment.to_line_end || comment.own_line || comment.many_lines;
      end += (c == token.comments ? gap_before_comment(i) : 1) + comment.width;
    }
    line += begins;
    lines_.push_back(line);
    end += (token.comments == token.comments_end ? gaps_[i] : gap_behind_comment(i)) + token.width;
    ends_.push_back(end);
  }
}

}  // namespace mansard::layout
