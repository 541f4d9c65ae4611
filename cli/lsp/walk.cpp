#include "cli/lsp/walk.hpp"

#include <algorithm>
#include <utility>

namespace mansard::lsp {

std::vector<Word> words_of(const syntax::File& file) {
  std::vector<Word> words;
  Walk(words).file(file);
  std::ranges::stable_sort(words, {}, [](const Word& word) { return word.at.begin; });
  return words;
}

void Walk::file(const syntax::File& file) {
  for (const syntax::Import& import : file.imports) add_text(Site::file, import.path);
  for (const syntax::Style& made : file.styles) style(made);
}

void Walk::style(const syntax::Style& style) {
  style_ = &style;
  preamble(style.pre);
  add(Site::style, style.name).declares = &style;
  for (const syntax::Name& parent : style.parents) add(Site::style_use, parent);
  for (const syntax::StyleMember& made : style.members) {
    std::visit([this](const auto& m) { member(m); }, made);
  }
  style_ = nullptr;
}

void Walk::member(const syntax::Variable& variable) {
  preamble(variable.pre);
  add(Site::variable, variable.name).declares = &variable;
  expression(variable.value);
}

void Walk::member(const syntax::Function& function) {
  preamble(function.pre);
  add(Site::function, function.name).declares = &function;
  function_ = &function;
  for (const syntax::Name& name : function.params) add(Site::parameter, name);
  expression(function.value);
  function_ = nullptr;
}

void Walk::member(const syntax::AbstractSymbol& symbol) {
  preamble(symbol.pre);
  add(Site::abstract_symbol, symbol.name).declares = &symbol;
}

void Walk::member(const syntax::Start& start) { add(Site::symbol_use, start.symbol); }

void Walk::member(const syntax::Rule& rule) {
  preamble(rule.pre);
  add(Site::rule, rule.name).declares = &rule;
  rule_ = &rule;
  for (const syntax::Name& name : rule.params) add(Site::parameter, name);
  if (rule.index) {
    const auto* bound = std::get_if<syntax::Reference>(&rule.index->is);
    if (bound && bound->names.size() == 1) add(Site::parameter, bound->names[0]);
  }
  expression(rule.guard);
  body(rule.successor);
  expression(rule.probability);
  rule_ = nullptr;
}

void Walk::member(const syntax::Block& block) {
  preamble(block.pre);
  block_ = &block;
  if (block.kind == syntax::BlockKind::rules) add(Site::block, block.name).declares = &block;
  for (const syntax::BlockItem& item : block.items) {
    std::visit([this](const auto& m) { member(m); }, item);
  }
  for (const auto& made : block.elements) entry(made);
  for (const auto& made : block.materials) entry(made);
  block_ = nullptr;
}

void Walk::entry(const syntax::ElementEntry& entry) {
  add(Site::entry, entry.symbol).declares = &entry;
  for (const syntax::ElementAlternative& alternative : entry.alternatives) {
    for (const syntax::ExprPtr& mesh : alternative.meshes) add_text(Site::file, mesh);
  }
}

void Walk::entry(const syntax::MaterialEntry& entry) {
  add(Site::entry, entry.symbol).declares = &entry;
  for (const syntax::MaterialAlternative& alternative : entry.alternatives) {
    for (const syntax::Emit& look : alternative.looks) emit(look);
  }
  const auto* per = entry.per ? std::get_if<syntax::Text>(&entry.per->is) : nullptr;
  if (per && per->value != "shape" && per->value != "building")
    add_text(Site::symbol_use, entry.per);
}

void Walk::preamble(const syntax::Preamble& pre) {
  for (const syntax::Annotation& annotation : pre.annotations) {
    add(Site::annotation, annotation.name);
    const bool is_per = annotation.name.text == "per";
    for (const syntax::Arg& arg : annotation.args) {
      const auto* text =
          arg.value.value ? std::get_if<syntax::Text>(&arg.value.value->is) : nullptr;
      if (is_per && text && text->value != "shape" && text->value != "building")
        add_text(Site::symbol_use, arg.value.value);
    }
  }
}

Word& Walk::add(Site site, const syntax::Name& name) {
  return words_.emplace_back(
      Word{name.at, site, name.text, style_, block_, rule_, function_, {}, false, {}});
}

void Walk::add_text(Site site, const syntax::ExprPtr& expr) {
  const auto* text = expr ? std::get_if<syntax::Text>(&expr->is) : nullptr;
  if (!text || expr->at.end < expr->at.begin + 2) return;
  add(site, {text->value, {expr->at.source, expr->at.begin + 1, expr->at.end - 1}});
}

/// One, or a list of them.
void Walk::add_texts(Site site, const syntax::ExprPtr& expr) {
  add_text(site, expr);
  const auto* list = expr ? std::get_if<syntax::List>(&expr->is) : nullptr;
  if (!list) return;
  for (const syntax::ExprPtr& item : list->items) add_text(site, item);
}

}  // namespace mansard::lsp
