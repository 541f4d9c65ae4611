// How much space stands before each token on its line, and which tokens begin one in any case.
#pragma once

#include <vector>

#include "grammar/syntax.hpp"
#include "grammar/tokens.hpp"

namespace mansard::layout {

constexpr int indentation = 4;
constexpr int between_members = 3;       // columns, in one line
constexpr int between_alternatives = 2;  // of an element or a material

/// A range of tokens, both ends in it.
struct Range {
  uint32_t first = 0, last = 0;
};

/// Read from the tree and the tokens. The author's line ends decide only this: blocks, rows of
/// variables or entries, lists of parts, `if`s and alternatives that were written in one line may
/// stay in one, and those that were not will not be joined.
class Spacing {
 public:
  Spacing(const syntax::File& file, const Tokens& tokens);

  /// Columns before the token where it does not begin a line.
  int gap(uint32_t token) const { return gaps_[token]; }
  /// The same where a comment stands between.
  int gap_behind_comment(uint32_t token) const;
  /// Columns before a comment on the line of the token that precedes `token`.
  int gap_before_comment(uint32_t token) const;
  bool begins_line(uint32_t token) const { return begins_line_[token]; }
  /// All of the range may stand in one line.
  bool flat(Range range) const { return lines_[range.first] == lines_[range.last]; }
  /// Columns of it in one line, without the space before its first token.
  int width(Range range) const;

 private:
  int plain_gap(uint32_t token) const;
  void style(const syntax::Style& style);
  void block(const syntax::Block& block);
  template <class Members, class Inside>
  void members(const Members& members, uint32_t open, uint32_t close, Inside inside);
  void variable(const syntax::Variable& variable);
  void annotations(const syntax::Preamble& preamble);
  template <class Entry>
  void entry(const Entry& entry);
  void body(const syntax::Body& body);
  void element(const syntax::Element& element);
  void if_chain(const syntax::If& chain);
  void parts(const std::vector<syntax::Part>& parts);
  void measure();

  const Tokens& tokens_;
  std::vector<int> gaps_;
  std::vector<bool> begins_line_;
  std::vector<int> ends_;        // the column behind each token if all stood in one line
  std::vector<uint32_t> lines_;  // how many lines begin at or before each token
};

/// Of a member, or of any alternative of a variant of members.
template <class Member>
Span place(const Member& member) {
  return member.at;
}
template <class Member>
Span place(const Member* member) {
  return member->at;
}
template <class... Kinds>
Span place(const std::variant<Kinds...>& member) {
  return std::visit([](const auto& one) { return place(one); }, member);
}

/// Stands beside others of its kind in one line, where the author wrote them so.
template <class Member>
bool stands_in_row(const Member& /*member*/) {
  return std::is_same_v<Member, syntax::Variable> ||
         std::is_same_v<Member, syntax::AbstractSymbol> ||
         std::is_same_v<Member, syntax::ElementEntry> ||
         std::is_same_v<Member, syntax::MaterialEntry>;
}
template <class... Kinds>
bool stands_in_row(const std::variant<Kinds...>& member) {
  return std::visit([](const auto& one) { return stands_in_row(one); }, member);
}

}  // namespace mansard::layout
