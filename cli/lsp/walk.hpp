// The walk over a syntax tree that collects its words. Private to walk*.cpp.
#pragma once

#include "cli/lsp/word.hpp"
#include "interpreter/operation.hpp"

namespace mansard::lsp {

class Walk {
 public:
  explicit Walk(std::vector<Word>& words) : words_(words) {}

  void file(const syntax::File& file);

 private:
  // walk.cpp: members
  void style(const syntax::Style& style);
  void member(const syntax::Variable& variable);
  void member(const syntax::Function& function);
  void member(const syntax::AbstractSymbol& symbol);
  void member(const syntax::Start& start);
  void member(const syntax::Rule& rule);
  void member(const syntax::Block& block);
  void entry(const syntax::ElementEntry& entry);
  void entry(const syntax::MaterialEntry& entry);
  void preamble(const syntax::Preamble& pre);

  // walk_successors.cpp
  void body(const syntax::Body& body);
  void element(const syntax::Element& element);
  void emit(const syntax::Emit& emit);
  void arguments(const syntax::Emit& emit, const Operation* operation);
  void argument(const syntax::Arg& arg, const Operation* operation, std::size_t place);
  void parts(const std::vector<syntax::Part>& parts, const Operation* operation);
  void label(const syntax::Size& label, const Operation* operation);
  void expression(const syntax::ExprPtr& expr);
  void is(const syntax::Expr& expr, const syntax::Reference& reference);
  void is(const syntax::Expr& expr, const syntax::Call& call);
  void is(const syntax::Expr& expr, const syntax::List& list);
  void is(const syntax::Expr& expr, const syntax::Subscript& subscript);
  void is(const syntax::Expr& expr, const syntax::Unary& unary);
  void is(const syntax::Expr& expr, const syntax::Chain& chain);
  void is(const syntax::Expr& expr, const syntax::Conditional& conditional);
  template <class Literal>
  void is(const syntax::Expr&, const Literal&) {}

  Word& add(Site site, const syntax::Name& name);
  /// A word in quotes.
  void add_text(Site site, const syntax::ExprPtr& expr);
  void add_texts(Site site, const syntax::ExprPtr& expr);

  std::vector<Word>& words_;
  const syntax::Style* style_ = nullptr;
  const syntax::Block* block_ = nullptr;
  const syntax::Rule* rule_ = nullptr;
  const syntax::Function* function_ = nullptr;
};

}  // namespace mansard::lsp
