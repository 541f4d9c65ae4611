// Rules, variables, entries, blocks and styles.
#include <algorithm>
#include <array>
#include <utility>

#include "grammar/build.hpp"
#include "grammar/in_quotes.hpp"

namespace mansard {

using namespace syntax;  // NOLINT: this file is about them

void TreeBuilder::wrong(Span at, std::string text, std::string help) {
  sound_ = false;
  diagnostics_.add({Severity::error, {}, at, std::move(text), {}, {}, std::move(help)});
}

bool TreeBuilder::finish() {
  tape_.cut(0);
  return std::exchange(sound_, true);
}

ExprPtr TreeBuilder::take_expr() {
  ExprPtr value = expr(*tape_.first());
  return finish() ? std::move(value) : nullptr;
}

void TreeBuilder::take_import() {
  const Node& path = *tape_.first();
  Import import{text(path), span(path)};
  if (finish()) file.imports.push_back(std::move(import));
}

void TreeBuilder::drop_last(bool of_style) {
  last_warnings_.clear();
  const auto drop = [](auto& members) {
    if (!members.empty()) members.pop_back();
  };
  if (of_style) {
    drop(style_.members);
  } else if (block_.kind == BlockKind::rules) {
    drop(block_.items);
  } else if (block_.kind == BlockKind::elements) {
    drop(block_.elements);
  } else {
    drop(block_.materials);
  }
}

// ---- preambles

namespace {

// The text of a documentation line stands after its slashes.
Span documentation(Span line) {
  const std::string_view text = line.text();
  std::size_t begin = text.rfind('\n');
  begin = text.find("///", begin == text.npos ? 0 : begin) + 3;
  if (begin < text.size() && text[begin] == ' ') ++begin;
  std::size_t end = text.size();
  while (end > begin && (text[end - 1] == '\r' || text[end - 1] == ' ')) --end;
  return {line.source, static_cast<uint32_t>(line.begin + begin),
          static_cast<uint32_t>(line.begin + end)};
}

// A member begins with its first annotation or modifier.
Span with_preamble(const Preamble& pre, Span at) {
  uint32_t begin = at.begin;
  if (!pre.annotations.empty()) begin = std::min(begin, pre.annotations.front().at.begin);
  for (const Span& word : {pre.final, pre.override, pre.abstract}) {
    if (word) begin = std::min(begin, word.begin);
  }
  return {at.source, begin, at.end};
}

}  // namespace

// Returns what follows it.
const Node* TreeBuilder::preamble(Preamble& into) {
  const Node* at = tape_.first();
  for (; at; at = next(*at)) {
    if (at->tag == Tag::doc) {
      into.docs.push_back(documentation(span(*at)));
    } else if (at->tag == Tag::annotation) {
      Annotation annotation{name(*child(*at)), {}, span(*at)};
      if (const Node* list = next(*child(*at))) annotation.args = args(*list);
      into.annotations.push_back(std::move(annotation));
    } else if (at->tag == Tag::modifier) {
      Span& word = words(*at) == "final" ? into.final : into.override;
      if (word) wrong(span(*at), in_quotes(words(*at)) + " stands here twice");
      word = span(*at);
    } else {
      break;
    }
  }
  return at;
}

// ---- members of blocks and styles

void TreeBuilder::take_block_item() {
  tell_last_warnings();
  Preamble pre;
  const Node* node = preamble(pre);
  BlockItem item = block_item(node, std::move(pre));
  if (!finish()) return;
  if (const auto* made = std::get_if<Rule>(&item)) warn_lost_arrow(*made);
  if (const auto* made = std::get_if<Variable>(&item); made && made->value) {
    const Span between{&source_, made->name.at.end, made->value->at.begin};
    if (between.text().find('=') == std::string_view::npos) brief_variable_end = made->at.end;
  }
  block_.items.push_back(std::move(item));
}

void TreeBuilder::take_style_item() {
  Preamble pre;
  const Node* node = preamble(pre);
  StyleMember member;
  if (node->tag == Tag::start) {
    member = Start{name(*child(*node)), span(*node)};
  } else {
    std::visit(
        [&](auto&& made) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(made)>, Rule>) {
            member = std::forward<decltype(made)>(made);
          }
        },
        block_item(node, std::move(pre)));
  }
  if (finish()) style_.members.push_back(std::move(member));
}

BlockItem TreeBuilder::block_item(const Node* node, Preamble pre) {
  if (node->tag == Tag::abstract_variable || node->tag == Tag::abstract_symbol) {
    pre.abstract = {&source_, node->begin, node->begin + 8};  // the word's length
  }
  switch (node->tag) {
    case Tag::variable:
    case Tag::abstract_variable:
      return variable(*node, std::move(pre));
    case Tag::function:
      return function(*node, std::move(pre));
    case Tag::abstract_symbol:
      return abstract_symbol(*node, std::move(pre));
    default:
      return rule(*node, std::move(pre));
  }
}

Rule TreeBuilder::rule(const Node& node, Preamble pre) {
  Rule rule;
  rule.at = with_preamble(pre, span(node));
  rule.pre = std::move(pre);
  for (const Node* at = child(node); at; at = next(*at)) {
    if (at->tag == Tag::head) {
      head(*at, rule);
    } else if (at->tag == Tag::body) {
      rule.successor = body(*at);
    } else {
      rule.probability = expr(*child(*at));
    }
  }
  return rule;
}

void TreeBuilder::head(const Node& node, Rule& into) {
  into.head = span(node);
  into.name = name(*child(node));
  for (const Node* at = next(*child(node)); at; at = next(*at)) {
    if (at->tag == Tag::params) {
      into.has_params = true;
      into.params = names(*at);
    } else if (at->tag == Tag::index) {
      into.index = expr(*child(*at));
    } else {
      for (const Node* part = child(*at); part; part = next(*part)) {
        if (part->tag == Tag::guard_else) {
          into.guard_else = true;
        } else {
          into.guard = expr(*part);
        }
      }
    }
  }
}

Variable TreeBuilder::variable(const Node& node, Preamble pre) {
  const Node& first = *child(node);
  Variable made;
  made.at = with_preamble(pre, span(node));
  made.pre = std::move(pre);
  made.name = name(first);
  if (const Node* value = next(first)) made.value = expr(*value);
  return made;
}

Function TreeBuilder::function(const Node& node, Preamble pre) {
  const Node& first = *child(node);
  const Node& params = *next(first);
  Function made;
  made.at = with_preamble(pre, span(node));
  made.pre = std::move(pre);
  made.name = name(first);
  made.params = names(params);
  made.value = expr(*next(params));
  return made;
}

AbstractSymbol TreeBuilder::abstract_symbol(const Node& node, Preamble pre) {
  const Node& first = *child(node);
  AbstractSymbol made;
  made.at = with_preamble(pre, span(node));
  made.pre = std::move(pre);
  made.name = name(first);
  if (const Node* params = next(first)) made.params = names(*params);
  return made;
}

std::vector<Name> TreeBuilder::names(const Node& node) {
  std::vector<Name> all;
  for (const Node* at = child(node); at; at = next(*at)) all.push_back(name(*at));
  return all;
}

// ---- a lost arrow

namespace {

// Null when something stands before it on its line.
const char* line_of_first_word(Span word) {
  const char* const text = word.source->text().data();
  const char* at = text + word.begin;
  while (at > text && (at[-1] == ' ' || at[-1] == '\t')) --at;
  return at == text || at[-1] == '\n' ? at : nullptr;
}

}  // namespace

void TreeBuilder::warn_lost_arrow(const Rule& rule) {
  constexpr int enough = 50;  // of one kind in one file
  uint32_t head_column = 0;
  for (const Element& element : rule.successor) {
    const auto* symbol = std::get_if<Emit>(&element.is);
    if (!symbol || symbol->args || symbol->parts || symbol->style || symbol->style_of) continue;
    const char* const line = line_of_first_word(element.at);
    if (!line || line <= source_.text().data() + rule.name.at.begin) continue;
    if (head_column == 0) head_column = source_.position(rule.at.begin).column;
    const auto column = source_.text().data() + element.at.begin - line + 1;
    if (column > head_column || ++lost_arrows_ > enough) continue;
    Diagnostic warning{Severity::warning, "W001", symbol->name.at, {}, {}, {}, {}};
    warning.text = in_quotes(symbol->name.text) +
                   " stands where a rule begins, but is read as part of rule " +
                   in_quotes(rule.name.text);
    warning.notes.push_back({"the rule begins here", rule.name.at});
    constexpr std::array<std::string_view, 3> words{"override", "final", "super"};
    const auto meant = nearest(symbol->name.text, words);
    warning.help = meant ? "did you mean " + in_quotes(*meant) + "?"
                         : "add the '->' that it has lost, or indent it deeper than its rule";
    last_warnings_.push_back(std::move(warning));
  }
}

void TreeBuilder::tell_last_warnings() {
  for (Diagnostic& warning : last_warnings_) diagnostics_.add(std::move(warning));
  last_warnings_.clear();
}

// ---- entries of Elements and Materials

namespace {

EntryKind entry_kind(std::string_view sign) {
  return sign == "+" ? EntryKind::add : sign == "-" ? EntryKind::take : EntryKind::set;
}

}  // namespace

// Leaves `node` at the first alternative.
template <class Entry>
Entry TreeBuilder::entry_head(const Node*& node) {
  Entry made;
  const Node* const at = preamble(made.pre);
  made.at = with_preamble(made.pre, span(*at));
  made.symbol = name(*child(*at));
  node = next(*child(*at));
  if (node) {
    made.kind = entry_kind(words(*node));
    node = next(*node);
  } else {
    made.kind = EntryKind::remove;
  }
  return made;
}

void TreeBuilder::take_element_entry() {
  const Node* node = nullptr;
  auto made = entry_head<ElementEntry>(node);
  for (; node; node = next(*node)) made.alternatives.push_back(meshes(*node));
  if (finish()) block_.elements.push_back(std::move(made));
}

void TreeBuilder::take_material_entry() {
  const Node* node = nullptr;
  auto made = entry_head<MaterialEntry>(node);
  for (; node; node = next(*node)) {
    if (node->tag == Tag::per) {
      made.per = expr(*child(*node));
    } else {
      made.alternatives.push_back(looks(*node));
    }
  }
  if (finish()) block_.materials.push_back(std::move(made));
}

ElementAlternative TreeBuilder::meshes(const Node& node) {
  ElementAlternative made;
  made.at = span(node);
  for (const Node* at = child(node); at; at = next(*at)) {
    if (at->tag == Tag::weight) {
      made.weight = expr(*child(*at));
    } else {
      made.meshes.push_back(expr(*at));
    }
  }
  return made;
}

MaterialAlternative TreeBuilder::looks(const Node& node) {
  MaterialAlternative made;
  made.at = span(node);
  for (const Node* at = child(node); at; at = next(*at)) {
    if (at->tag == Tag::weight) {
      made.weight = expr(*child(*at));
    } else {
      made.looks.push_back(emit(*at));
      made.look_spans.push_back(span(*at));
    }
  }
  return made;
}

// ---- blocks and styles

void TreeBuilder::take_block_head(BlockKind kind) {
  block_ = {};
  block_.kind = kind;
  const Node* at = preamble(block_.pre);
  block_.at = with_preamble(block_.pre, span(*at));
  if (at->tag == Tag::replace) {
    block_.replace = span(*at);
    at = next(*at);
  }
  block_.name = name(*at);
  finish();
}

void TreeBuilder::end_block(uint32_t end) {
  tell_last_warnings();
  block_.at.end = end;
  style_.members.emplace_back(std::exchange(block_, {}));
}

void TreeBuilder::take_style_head() {
  style_ = {};
  const Node* at = preamble(style_.pre);
  style_.at = with_preamble(style_.pre, span(*at));
  at = next(*at);  // past `style`
  style_.name = name(*at);
  if (const Node* parents = next(*at)) style_.parents = names(*parents);
  finish();
}

void TreeBuilder::end_style(uint32_t end) {
  style_.at.end = end;
  file.styles.push_back(std::exchange(style_, {}));
}

}  // namespace mansard
