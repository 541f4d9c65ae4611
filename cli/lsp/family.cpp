// Which styles share a member. A symbol of a mixin and one of a house are the same where some style
// inherits from both; two heirs that both add a variable share none.
#include <algorithm>
#include <map>
#include <numeric>

#include "cli/lsp/meaning.hpp"

namespace mansard::lsp {

namespace {

/// Union-find over the styles that mention a member.
class Groups {
 public:
  std::size_t add(const syntax::Style* style) {
    const auto [known, fresh] = numbers_.emplace(style, parent_.size());
    if (fresh) parent_.push_back(known->second);
    return known->second;
  }
  const std::size_t* find(const syntax::Style* style) const {
    const auto known = numbers_.find(style);
    return known == numbers_.end() ? nullptr : &known->second;
  }
  std::size_t root(std::size_t number) {
    while (parent_[number] != number) number = parent_[number] = parent_[parent_[number]];
    return number;
  }
  void unite(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }
  const std::map<const syntax::Style*, std::size_t>& all() const { return numbers_; }

 private:
  std::map<const syntax::Style*, std::size_t> numbers_;
  std::vector<std::size_t> parent_;
};

}  // namespace

/// Words of the same kind and name, whatever their style.
std::vector<const Word*> Meanings::alike(const Meaning& meaning) const {
  std::vector<const Word*> found;
  for (const std::vector<Word>& of_file : words_) {
    for (const Word& word : of_file) {
      if (word.text == meaning.name && of(word).alike(meaning)) found.push_back(&word);
    }
  }
  return found;
}

std::vector<const syntax::Style*> Meanings::family(const Meaning& meaning) const {
  if (!meaning.style) return library_.styles();
  Groups groups;
  groups.add(meaning.style);
  bool everywhere = false;
  for (const Word* word : alike(meaning)) {
    const Meaning same = of(*word);
    if (same.style) groups.add(same.style);
    everywhere = everywhere || !same.style;
  }
  for (const syntax::Style* heir : library_.styles()) {
    const std::size_t* first = nullptr;
    for (const syntax::Style* style : order(*heir)) {
      const std::size_t* number = groups.find(style);
      if (number && first) groups.unite(*first, *number);
      if (!first) first = number;
    }
  }
  std::vector<const syntax::Style*> members;
  const std::size_t own = groups.root(groups.add(meaning.style));
  for (const auto& [style, number] : groups.all()) {
    if (everywhere || groups.root(number) == own) members.push_back(style);
  }
  return members;
}

std::vector<const Word*> Meanings::mentions(const Meaning& meaning) const {
  std::vector<const Word*> found = alike(meaning);
  const bool of_a_style = meaning.kind == Kind::symbol || meaning.kind == Kind::variable ||
                          meaning.kind == Kind::function || meaning.kind == Kind::block;
  if (!of_a_style || !meaning.style) return found;
  const std::vector<const syntax::Style*> styles = family(meaning);
  std::erase_if(found, [&](const Word* word) {
    const Meaning same = of(*word);
    return same.style && std::ranges::find(styles, same.style) == styles.end();
  });
  return found;
}

}  // namespace mansard::lsp
