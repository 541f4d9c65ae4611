// Where lines break: from the whole file down to a value, each phrase in one line if it fits, else
// broken at its own joints.
#pragma once

#include <span>

#include "grammar/columns.hpp"

namespace mansard::layout {

/// What is written as `range` begins where the page stands; `tail` more columns will follow in its
/// last line.
class Layout {
 public:
  Layout(const syntax::File& file, const Tokens& tokens);
  std::string text() const { return page_.text(); }

 private:
  // layout_members.cpp
  template <class Members>
  void members(const Members& members, uint32_t first, int column);
  template <class Members>
  std::vector<Row> rows(const Members& members, uint32_t first, int column);
  bool stands_apart(uint32_t first) const;
  template <class Member>
  void describe(const Member& member, Range range, int column, Row& row);
  template <class Member>
  void describe(const Member* member, Range range, int column, Row& row);
  template <class... Kinds>
  void describe(const std::variant<Kinds...>& member, Range range, int column, Row& row);
  template <class... Kinds>
  void write(const std::variant<Kinds...>& member, Range range, int column);
  template <class Member>
  void write(const Member* member, Range range, int column);
  void write(const syntax::Import& import, Range range, int column);
  void write(const syntax::Style& style, Range range, int column);
  void write(const syntax::Block& block, Range range, int column);
  void write(const syntax::Variable& variable, Range range, int column);
  void write(const syntax::Function& function, Range range, int column);
  void write(const syntax::AbstractSymbol& symbol, Range range, int column);
  void write(const syntax::Start& start, Range range, int column);
  void declaration(const syntax::Preamble& before, const syntax::ExprPtr& is, Range range,
                   int column);
  bool begin(const syntax::Preamble& before, Range range, int column);
  uint32_t last_line(const syntax::Preamble& preamble, Range range) const;
  uint32_t preamble(const syntax::Preamble& preamble, Range range, int column);

  // layout_entries.cpp
  void write(const syntax::ElementEntry& entry, Range range, int column);
  void write(const syntax::MaterialEntry& entry, Range range, int column);
  template <class Entry>
  void entry(const Entry& entry, Range range, int column);
  template <class Alternative>
  int weight_column(const std::vector<Alternative>& alternatives) const;
  void alternative(std::span<const Range> pieces, Range range);

  // layout_successors.cpp
  struct RuleParts {
    Range head, body, probability;  ///< the last with its ':', empty where there is none
  };
  RuleParts parts_of(const syntax::Rule& rule, Range range) const;
  uint32_t guard_colon(const syntax::Rule& rule) const;
  void describe_rule(const syntax::Rule& rule, Range range, int column, Row& row);
  void write(const syntax::Rule& rule, Range range, int column);
  void rule_head(const syntax::Rule& rule, Range range);
  void successor(const syntax::Rule& rule, const RuleParts& parts);
  void body(const syntax::Body& body, Range range, int tail);
  void element(const syntax::Element& element, Range range, int tail);
  void emit(const syntax::Emit& emit, Range range, int tail);
  void parts(const std::vector<syntax::Part>& parts, Range range, int tail);
  int label_width(const std::vector<syntax::Part>& parts) const;
  void part(const syntax::Part& part, Range range, int label, int tail);
  void push(const syntax::Push& push, Range range, int tail);
  void if_chain(const syntax::If& chain, Range range, int tail);

  // layout_values.cpp
  void value(Range range, int tail);
  void conditional(Range range, int tail);
  void chain(Range range, std::span<const uint32_t> operators, int tail);
  void primary(Range range, int tail);
  void list(Range range, int tail);
  void items(Range range, int column, int tail);
  void item(Range range, int tail);

  Range range(Span span) const { return {tokens_.first(span), tokens_.last(span)}; }

  const Tokens& tokens_;
  const Spacing spacing_;
  Page page_;
  bool arrow_dropped_ = false;  ///< of the last rule
  int nesting_ = 0;             ///< of parts that did not fit
};

}  // namespace mansard::layout
