// Completions from the tables of the language and from the members of styles.
#include <algorithm>

#include "cli/lsp/completer.hpp"
#include "cli/lsp/describe.hpp"
#include "cli/lsp/pages.hpp"
#include "cli/vocabulary.hpp"
#include "interpreter/attribute_table.hpp"
#include "interpreter/function.hpp"
#include "interpreter/selectors.hpp"

namespace mansard::lsp {

namespace {

/// `subdiv("${1:axis}", ${2:size}) { $0 }`
std::string snippet(const Operation& operation) {
  std::string text = std::string(operation.name) + "(";
  const bool bare = operation.rule == PartRule::selectors;  // comp { side : … }
  for (std::size_t i = 0; !bare && i < operation.required; ++i) {
    if (operation.parameters[i].optional) continue;
    const std::string field =
        "${" + std::to_string(i + 1) + ":" + std::string(operation.parameter_name(i)) + "}";
    const bool quoted =
        operation.parameters[i].type == ArgType::string || operation.parameter_name(i) == "axis";
    text += (i ? ", " : "") + (quoted ? "\"" + field + "\"" : field);
  }
  text += ")";
  if (bare) text = std::string(operation.name);
  const bool parts = operation.rule != PartRule::without && operation.rule != PartRule::body;
  return text + (parts ? " { $0 }" : "$0");
}

std::string short_text(const syntax::ExprPtr& value) {
  constexpr std::size_t most = 60;
  if (!value) return "abstract";
  std::string text(value->at.text().substr(0, most));
  std::ranges::replace(text, '\n', ' ');
  return text;
}

}  // namespace

void Completer::styles(std::string_view after) {
  for (const syntax::Style* other : view_.library().styles()) {
    if (other == style_ && after.empty()) continue;
    const std::string name(other->name.text);
    add({name, style, {}, {}, after.empty() ? "" : name + std::string(after), false, '8'});
  }
}

/// Those that its styles rewrite, fill or emit.
void Completer::symbols(const syntax::Style* of) {
  if (!of) return;
  const Meanings& meanings = view_.meanings();
  const Order& order = meanings.order(*of);
  for (const syntax::File& script : view_.library().read_files()) {
    for (const Word& word : view_.words(script)) {
      const bool emitted = word.site == Site::emit || word.site == Site::rule ||
                           word.site == Site::entry || word.site == Site::abstract_symbol;
      if (!emitted || std::ranges::find(order, word.style) == order.end()) continue;
      if (known_.contains({std::string(word.text), symbol})) continue;
      if (meanings.of(word).kind != Kind::symbol) continue;
      add({std::string(word.text), symbol, {}, {}, {}, false, '4'});
    }
  }
  add({"NIL", symbol, {}, word_page("NIL"), {}});
}

void Completer::operations() {
  for (const Operation& row : mansard::operations())
    add({std::string(row.name), operation, usage(row), page(row), snippet(row), true});
}

void Completer::functions() {
  for (const Function& row : mansard::functions()) {
    const std::string name(row.name);
    add({name, function, name + "(" + std::string(row.args) + ")", page(row), name + "($0)", true,
         '6'});
  }
  add({"attr", function, "attr(\"name\", default)", word_page("attr"), "attr(\"${1:name}\", $0)",
       true, '6'});
}

void Completer::attributes() {
  for (const AttributeRow& row : mansard::attributes())
    add({std::string(row.name), property, {}, std::string(row.summary), {}});
  for (const InputRow& row : inputs())
    add({std::string(row.name), property, {}, std::string(row.summary), {}});
}

/// `split.`, `comp.`, `scope.`
void Completer::attributes_of(std::string_view object) {
  for (const AttributeRow& row : mansard::attributes()) {
    const auto dot = row.name.find('.');
    if (dot == row.name.npos || row.name.substr(0, dot) != object) continue;
    add({std::string(row.name.substr(dot + 1)), property, {}, std::string(row.summary), {}});
  }
}

void Completer::parameters() {
  for (const std::string_view name : place_.params)
    add({std::string(name),
         parameter,
         "parameter of " + std::string(place_.rule),
         {},
         {},
         false,
         '1'});
}

/// Of the block, then of the style; what a heir overrides once.
void Completer::variables() {
  if (!style_) return;
  for (const syntax::Style* from : view_.meanings().order(*style_)) {
    for (const Word* word : view_.meanings().declared_in(*from)) {
      const std::string_view block = word->block ? word->block->name.text : std::string_view{};
      if (!block.empty() && block != place_.block) continue;
      const std::string of = block.empty() ? "" : std::string(block) + ".";
      if (const auto* v = std::get_if<const syntax::Variable*>(&word->declares))
        add({std::string(word->text),
             variable,
             of + short_text((*v)->value),
             documentation(*word),
             {},
             false,
             block.empty() ? '3' : '2'});
      if (std::holds_alternative<const syntax::Function*>(word->declares))
        add({std::string(word->text), function, declaration_text(*word, 1), documentation(*word),
             std::string(word->text) + "($0)", true, '3'});
    }
  }
}

void Completer::blocks() {
  if (!style_) return;
  for (const syntax::Style* from : view_.meanings().order(*style_)) {
    for (const Word* word : view_.meanings().declared_in(*from)) {
      if (word->site == Site::block) add({std::string(word->text), module, {}, {}, {}, false, '6'});
    }
  }
}

void Completer::members_of(std::string_view block) {
  attributes_of(block);
  if (!style_) return;
  for (const syntax::Style* from : view_.meanings().order(*style_)) {
    for (const Word* word : view_.meanings().declared_in(*from)) {
      if (!word->block || word->block->name.text != block) continue;
      if (const auto* v = std::get_if<const syntax::Variable*>(&word->declares))
        add({std::string(word->text), variable, short_text((*v)->value), documentation(*word), {}});
      if (std::holds_alternative<const syntax::Function*>(word->declares))
        add({std::string(word->text), function, declaration_text(*word, 1), documentation(*word),
             std::string(word->text) + "($0)", true});
    }
  }
}

void Completer::selectors(std::string_view after) {
  for (const std::string_view word : selector_words) {
    const std::string name(word);
    add({name,
         choice,
         {},
         std::string(selector_summary(*find_selector(word))),
         after.empty() ? "" : name + std::string(after),
         false,
         '0'});
  }
}

void Completer::part_names() {
  const Operation* const row = find_operation(place_.parts_of);
  if (!row || row->rule != PartRule::named) return;
  for (std::size_t i = 0; i < parts_in(row->parts); ++i) {
    const std::string name(part_name(row->parts, i));
    add({name, choice, "part of " + std::string(row->name), {}, name + " : ", false, '0'});
  }
}

void Completer::named_arguments() {
  if (place_.calls.empty() || !place_.calls.back().is_step) return;
  const Operation* const row = find_operation(place_.calls.back().name);
  for (std::size_t i = 0; row && i < row->count; ++i) {
    const std::string name(row->parameter_name(i));
    add({name, parameter, "argument of " + std::string(row->name), argument_page(row->name, name),
         name + " = ", false, '0'});
  }
}

/// Inherited rules and variables of this block with their text, but for those the style has.
void Completer::overridable() {
  if (!style_) return;
  const Meanings& meanings = view_.meanings();
  for (const Word* word : meanings.declared_in(*style_)) {
    if (word->block && word->block->name.text == place_.block)
      known_.emplace(std::string(word->text), word->site == Site::rule ? symbol : variable);
  }
  for (const syntax::Style* from : meanings.order(*style_)) {
    std::string text;
    const auto& all = meanings.declared_in(*from);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Word& word = *all[i];
      if (!word.block || word.block->name.text != place_.block) continue;
      if (word.site != Site::rule && word.site != Site::variable) continue;
      text += (text.empty() ? "" : "\n") + declaration_text(word, 100);
      const bool more = i + 1 < all.size() && word.site == Site::rule &&
                        all[i + 1]->site == Site::rule && all[i + 1]->text == word.text;
      if (more) continue;  // the other productions of the symbol
      add({std::string(word.text), word.site == Site::rule ? symbol : variable,
           "override, from " + std::string(from->name.text), code(text), std::exchange(text, {}),
           false, '0'});
    }
  }
}

void Completer::overridable_block() {
  if (!style_) return;
  for (const syntax::Style* from : view_.meanings().order(*style_)) {
    for (const Word* word : view_.meanings().declared_in(*from)) {
      const std::string name(word->text);
      if (word->site == Site::block)
        add({name,
             module,
             "block of " + std::string(from->name.text),
             {},
             name + " {\n\t$0\n}",
             true,
             '0'});
      if (word->site == Site::variable && !word->block && from != style_)
        add({name,
             variable,
             "override, from " + std::string(from->name.text),
             {},
             declaration_text(*word, 100),
             false,
             '0'});
    }
  }
}

}  // namespace mansard::lsp
