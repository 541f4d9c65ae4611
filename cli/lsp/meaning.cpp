#include "cli/lsp/meaning.hpp"

#include <algorithm>

#include "interpreter/attribute_table.hpp"
#include "interpreter/function.hpp"
#include "styles/members.hpp"

namespace mansard::lsp {

namespace {

bool declares(Site site) {
  return site == Site::rule || site == Site::abstract_symbol || site == Site::entry ||
         site == Site::variable || site == Site::function || site == Site::block;
}

Kind kind_of(Site site) {
  switch (site) {
    case Site::variable:
      return Kind::variable;
    case Site::function:
      return Kind::function;
    case Site::block:
      return Kind::block;
    default:
      return Kind::symbol;
  }
}

std::string_view block_name(const Word& word) {
  const bool belongs = word.site == Site::variable || word.site == Site::function;
  return belongs && word.block ? word.block->name.text : std::string_view{};
}

/// Does the rule or function around the word have a parameter of this name?
const void* parameter_scope(const Word& word, std::string_view name) {
  const auto has = [&](const std::vector<syntax::Name>& params) {
    return std::ranges::find(params, name, &syntax::Name::text) != params.end();
  };
  if (word.function && has(word.function->params)) return word.function;
  if (!word.rule) return nullptr;
  if (has(word.rule->params)) return word.rule;
  const auto* bound =
      word.rule->index ? std::get_if<syntax::Reference>(&word.rule->index->is) : nullptr;
  return bound && bound->names.size() == 1 && bound->names[0].text == name ? word.rule : nullptr;
}

}  // namespace

Meanings::Meanings(const Library& library, const std::vector<std::vector<Word>>& words)
    : library_(library), words_(words) {
  for (const std::vector<Word>& of_file : words) {
    for (const Word& word : of_file) {
      if (word.style && declares(word.site)) declare(word);
    }
  }
}

void Meanings::declare(const Word& word) {
  declared_[word.style][{kind_of(word.site), block_name(word), word.text}].push_back(&word);
  in_order_[word.style].push_back(&word);
}

const std::vector<const Word*>& Meanings::declared_in(const syntax::Style& style) const {
  static const std::vector<const Word*> nothing;
  const auto found = in_order_.find(&style);
  return found == in_order_.end() ? nothing : found->second;
}

const std::vector<const Word*>* Meanings::find(const syntax::Style& style, const Key& key) const {
  const auto members = declared_.find(&style);
  if (members == declared_.end()) return nullptr;
  const auto found = members->second.find(key);
  return found == members->second.end() ? nullptr : &found->second;
}

bool Meanings::has(const syntax::Style& style, const Key& key) const {
  return std::ranges::any_of(order(style),
                             [&](const syntax::Style* s) { return find(*s, key) != nullptr; });
}

bool Meanings::has_rules(const syntax::Style& style, std::string_view symbol) const {
  return std::ranges::any_of(order(style), [&](const syntax::Style* s) {
    const auto* all = find(*s, {Kind::symbol, {}, symbol});
    return all && std::ranges::find(*all, Site::rule, &Word::site) != all->end();
  });
}

const Order& Meanings::order(const syntax::Style& style) const {
  const auto [known, fresh] = orders_.try_emplace(&style);
  if (fresh) {
    Diagnostics unheard;
    const auto ancestry = Ancestry::of(library_, style, unheard);
    known->second = ancestry ? ancestry->order() : Order{&style};
  }
  return known->second;
}

Meaning Meanings::of(const Word& word) const {
  const auto plain = [&](Kind kind) { return Meaning{kind, {}, word.text, word.style, nullptr}; };
  switch (word.site) {
    case Site::style:
    case Site::style_use:
      return {Kind::style, {}, word.text, nullptr, nullptr};
    case Site::block:
      return plain(Kind::block);
    case Site::block_use:
      if (find_attribute(std::string(word.text) + "." + std::string(word.of)))
        return {Kind::attribute, word.text, word.of, word.style, nullptr};
      return plain(Kind::block);
    case Site::rule:
    case Site::abstract_symbol:
    case Site::entry:
      return plain(Kind::symbol);
    case Site::symbol_use: {
      Meaning meaning = plain(Kind::symbol);
      if (!word.of.empty()) meaning.style = library_.find(word.of);
      if (word.any_style) meaning.style = nullptr;
      return meaning.style || word.any_style ? meaning : Meaning{};
    }
    case Site::variable:
    case Site::function:
      return {kind_of(word.site), block_name(word), word.text, word.style, nullptr};
    case Site::parameter:
      return {Kind::parameter, {}, word.text, word.style, parameter_scope(word, word.text)};
    case Site::emit:
      return of_emit(word);
    case Site::value:
      return of_value(word);
    case Site::member_use:
      return of_member(word);
    case Site::call:
      return of_call(word);
    case Site::operation:
      return plain(Kind::operation);
    case Site::argument:
      return {Kind::argument, word.of, word.text, word.style, nullptr};
    case Site::part:
      return {Kind::part, word.of, word.text, word.style, nullptr};
    case Site::selector:
      return plain(Kind::selector);
    case Site::file:
      return plain(Kind::file);
    case Site::annotation:
      return plain(Kind::annotation);
    case Site::super:
      return {Kind::super, {}, word.rule ? word.rule->name.text : word.text, word.style, nullptr};
  }
  return {};
}

/// A parameter or a variable that a bare name sees.
bool Meanings::in_sight(const Word& word, std::string_view name, Meaning& found) const {
  if (const void* scope = parameter_scope(word, name)) {
    found = {Kind::parameter, {}, name, word.style, scope};
    return true;
  }
  const std::string_view own = word.block ? word.block->name.text : std::string_view{};
  for (const std::string_view block : {own, std::string_view{}}) {
    if (!word.style || !has(*word.style, {Kind::variable, block, name})) continue;
    found = {Kind::variable, block, name, word.style, nullptr};
    return true;
  }
  return false;
}

Meaning Meanings::of_emit(const Word& word) const {
  const Meaning symbol{Kind::symbol, {}, word.text, word.style, nullptr};
  Meaning found;
  if (!in_sight(word, word.text, found)) return symbol;
  const bool hidden = found.kind == Kind::variable && has_rules(*word.style, word.text);
  return hidden ? symbol : found;
}

Meaning Meanings::of_value(const Word& word) const {
  Meaning found;
  if (in_sight(word, word.text, found)) return found;
  if (word.text == "fits" || find_attribute(word.text) || find_input(word.text))
    return {Kind::attribute, {}, word.text, word.style, nullptr};
  return {Kind::symbol, {}, word.text, word.style, nullptr};
}

Meaning Meanings::of_member(const Word& word) const {
  if (find_attribute(std::string(word.of) + "." + std::string(word.text)))
    return {Kind::attribute, word.of, word.text, word.style, nullptr};
  return {Kind::variable, word.of, word.text, word.style, nullptr};
}

Meaning Meanings::of_call(const Word& word) const {
  if (word.of.empty() && (word.text == "attr" || find_function(word.text)))
    return {Kind::builtin, {}, word.text, word.style, nullptr};
  const std::string_view own = !word.of.empty() ? word.of
                               : word.block     ? word.block->name.text
                                                : std::string_view{};
  for (const std::string_view block : {own, std::string_view{}}) {
    if (word.style && has(*word.style, {Kind::function, block, word.text}))
      return {Kind::function, block, word.text, word.style, nullptr};
  }
  return {Kind::symbol, {}, word.text, word.style, nullptr};
}

// ---- where members are written

std::vector<const Word*> Meanings::written(const Meaning& meaning,
                                           const syntax::Style& style) const {
  std::vector<const Word*> all;
  const Order& styles = order(style);
  const Replacements replaced(styles);
  for (std::size_t rank = 0; rank < styles.size(); ++rank) {
    const auto* here = find(*styles[rank], {meaning.kind, meaning.block, meaning.name});
    if (!here) continue;
    for (const Word* word : *here) {
      if (!word->block || !replaced.drops(*word->block, rank)) all.push_back(word);
    }
  }
  return all;
}

namespace {

/// Rules decide, then entries, then `abstract`.
int strength(const Word& word) {
  const auto* variable = std::get_if<const syntax::Variable*>(&word.declares);
  if (variable) return (*variable)->value ? 0 : 2;
  return word.site == Site::entry ? 1 : word.site == Site::abstract_symbol ? 2 : 0;
}

/// All of the first style among the strongest; for entries and the like, all of them.
std::vector<const Word*> deciding(const std::vector<const Word*>& written) {
  std::vector<const Word*> chosen;
  int best = 3;
  for (const Word* word : written) best = std::min(best, strength(*word));
  for (const Word* word : written) {
    if (strength(*word) != best) continue;
    if (best == 0 && !chosen.empty() && chosen.front()->style != word->style) break;
    chosen.push_back(word);
  }
  return chosen;
}

}  // namespace

std::vector<const Word*> Meanings::definition(const Meaning& meaning) const {
  if (meaning.kind == Kind::super) {
    Meaning symbol = meaning;
    symbol.kind = Kind::symbol;
    return overridden(symbol);
  }
  if (meaning.kind == Kind::style || meaning.kind == Kind::parameter) {
    std::vector<const Word*> found = alike(meaning);
    std::erase_if(found, [](const Word* word) {
      return word->site != Site::style && word->site != Site::parameter;
    });
    return found;
  }
  if (meaning.style) return deciding(written(meaning, *meaning.style));
  std::vector<const Word*> found;
  for (const syntax::Style* style : library_.styles()) {
    for (const Word* word : deciding(written(meaning, *style))) {
      if (std::ranges::find(found, word) == found.end()) found.push_back(word);
    }
  }
  return found;
}

std::vector<const Word*> Meanings::overridden(const Meaning& meaning) const {
  if (!meaning.style) return {};
  std::vector<const Word*> rest = written(meaning, *meaning.style);
  const std::vector<const Word*> first = deciding(rest);
  if (first.empty()) return {};
  std::erase_if(rest, [&](const Word* word) {
    return word->style == first.front()->style || word->site == Site::entry;
  });
  std::vector<const Word*> all;
  while (!rest.empty()) {  // a style after the other
    const syntax::Style* next = rest.front()->style;
    for (const Word* word : rest) {
      if (word->style == next) all.push_back(word);
    }
    std::erase_if(rest, [&](const Word* word) { return word->style == next; });
  }
  return all;
}

std::vector<const Word*> Meanings::overriding(const Meaning& meaning) const {
  std::vector<const Word*> all;
  if (!meaning.style) return all;
  const Key key{meaning.kind, meaning.block, meaning.name};
  for (const syntax::Style* style : library_.styles()) {
    const auto* here = style == meaning.style ? nullptr : find(*style, key);
    if (!here || std::ranges::find(order(*style), meaning.style) == order(*style).end()) continue;
    for (const Word* word : *here) {
      if (word->site != Site::entry) all.push_back(word);
    }
  }
  return all;
}

}  // namespace mansard::lsp
