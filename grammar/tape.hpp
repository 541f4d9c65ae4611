// What the actions of the grammar write: a flat record of the phrases that matched, children before
// parents. Backtracking cuts its end off. The typed tree is read from it, a member at a time.
#pragma once

#include <cstdint>
#include <vector>

namespace mansard {

enum class Tag : uint8_t {
  none,
  // values
  name,
  qualified,
  word,
  number,
  text,
  boolean,
  list,
  parenthesis,
  unit,
  amount,
  op,
  reference,
  call,
  subscript,
  unary,
  chain,
  conditional,
  named,
  floating,
  dont_care,
  args,
  index,
  // successors
  push,
  if_,
  super_,
  of_style,
  emit,
  body,
  label,
  part,
  group,
  parts,
  star,
  // members
  doc,
  annotation,
  modifier,
  params,
  guard,
  guard_else,
  head,
  probability,
  rule,
  variable,
  function,
  abstract_variable,
  abstract_symbol,
  start,
  replace,
  parents,
  import,
  alternative,
  weight,
  look,
  entry_kind,
  entry,
  per
};

struct Node {
  static constexpr uint32_t none = UINT32_MAX;
  uint32_t begin = 0, end = 0;         ///< offsets into the source, without surrounding space
  uint32_t mark = 0;                   ///< where the record of its first descendant stands
  uint32_t child = none, next = none;  ///< first child, next sibling
  Tag tag = Tag::none;
};

class Tape {
 public:
  uint32_t size() const { return static_cast<uint32_t>(nodes_.size()); }
  void cut(uint32_t mark) { nodes_.resize(mark); }
  /// A phrase whose descendants are all records from `mark` on.
  void add(Tag tag, uint32_t begin, uint32_t end, uint32_t mark) {
    Node node{begin, end, mark, Node::none, Node::none, tag};
    node.child = link(mark);
    nodes_.push_back(node);
  }
  /// Exactly one phrase stands from `mark` on, with all its descendants.
  bool single(uint32_t mark) const { return size() > mark && nodes_.back().mark == mark; }

  const Node* child(const Node& of) const { return at(of.child); }
  const Node* next(const Node& of) const { return at(of.next); }
  /// The first of the phrases that are nobody's children, in order.
  const Node* first() { return at(link(0)); }

 private:
  const Node* at(uint32_t i) const { return i == Node::none ? nullptr : &nodes_[i]; }
  uint32_t link(uint32_t mark) {
    uint32_t first = Node::none;
    for (uint32_t end = size(); end > mark; end = nodes_[end - 1].mark) {
      nodes_[end - 1].next = first;
      first = end - 1;
    }
    return first;
  }

  std::vector<Node> nodes_;
};

}  // namespace mansard
