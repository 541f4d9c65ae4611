// From the tape to the typed tree, a member at a time.
#pragma once

#include <string_view>

#include "grammar/diagnostic.hpp"
#include "grammar/syntax.hpp"
#include "grammar/tape.hpp"

namespace mansard {

class TreeBuilder {
 public:
  TreeBuilder(const Source& source, Tape& tape, Diagnostics& diagnostics)
      : source_(source), tape_(tape), diagnostics_(diagnostics) {
    file.source = &source;
  }

  // Each takes what is on the tape, puts it into the tree and clears the tape. A member with a
  // mistake that the grammar lets through is reported and left out.
  void take_import();
  void take_style_head();
  void take_block_head(syntax::BlockKind kind);
  void take_block_item();
  void take_style_item();
  void take_element_entry();
  void take_material_entry();
  void end_block(uint32_t end);
  void end_style(uint32_t end);
  syntax::ExprPtr take_expr();
  /// The last member that was taken turned out to be only the beginning of one.
  void drop_last(bool of_style);
  void drop_last_warnings() { last_warnings_.clear(); }

  syntax::File file;
  const syntax::Block& open_block() const { return block_; }
  /// Where a symbol of the last rule stands like the head of a rule; none: 0.
  uint32_t lost_head() const { return last_warnings_.empty() ? 0 : last_warnings_.back().at.begin; }

  uint32_t brief_variable_end = 0;  ///< of the last `var X 1`, which takes no expression

 private:
  // build_values.cpp
  syntax::ExprPtr expr(const Node& node);
  syntax::ExprPtr bare_expr(const Node& node);
  syntax::ExprPtr subscript(const Node& node);
  syntax::ExprPtr unary(const Node& node);
  syntax::ExprPtr chain(const Node& node);
  syntax::ExprPtr conditional(const Node& node);
  syntax::ExprPtr number(const Node& node);
  syntax::ExprPtr text(const Node& node);
  std::string unescaped(const Node& node);
  syntax::Reference reference(const Node& node);
  syntax::Size size(const Node& node);
  std::vector<syntax::Arg> args(const Node& node);
  // build_successors.cpp
  syntax::Body body(const Node& node);
  syntax::Element element(const Node& node);
  syntax::Emit emit(const Node& node);
  syntax::If if_chain(const Node& node);
  syntax::Parts parts(const Node& node);
  syntax::Part part(const Node& node);
  syntax::Size label(const Node& node);
  // build_members.cpp
  const Node* preamble(syntax::Preamble& into);
  syntax::BlockItem block_item(const Node* node, syntax::Preamble pre);
  syntax::Rule rule(const Node& node, syntax::Preamble pre);
  void head(const Node& node, syntax::Rule& into);
  syntax::Variable variable(const Node& node, syntax::Preamble pre);
  syntax::Function function(const Node& node, syntax::Preamble pre);
  syntax::AbstractSymbol abstract_symbol(const Node& node, syntax::Preamble pre);
  syntax::ElementAlternative meshes(const Node& node);
  syntax::MaterialAlternative looks(const Node& node);
  std::vector<syntax::Name> names(const Node& node);
  template <class Entry>
  Entry entry_head(const Node*& node);
  void warn_lost_arrow(const syntax::Rule& rule);
  void tell_last_warnings();

  Span span(const Node& node) const { return {&source_, node.begin, node.end}; }
  std::string_view words(const Node& node) const {
    return source_.text().substr(node.begin, node.end - node.begin);
  }
  syntax::Name name(const Node& node) const { return {words(node), span(node)}; }
  syntax::ExprPtr make(const Node& node, decltype(syntax::Expr::is) is) const {
    return std::make_unique<syntax::Expr>(syntax::Expr{span(node), std::move(is)});
  }
  const Node* child(const Node& node) const { return tape_.child(node); }
  const Node* next(const Node& node) const { return tape_.next(node); }
  void wrong(Span at, std::string text, std::string help = {});
  /// Clears the tape; true when the member on it was sound.
  bool finish();

  const Source& source_;
  Tape& tape_;
  Diagnostics& diagnostics_;
  syntax::Style style_;
  syntax::Block block_;
  bool sound_ = true;
  int lost_arrows_ = 0;
  std::vector<Diagnostic> last_warnings_;  ///< about the last rule, until it is certain
};

}  // namespace mansard
