// What a word of a script means: which member of which style, by the resolution order of the style
// in which it stands.
#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "cli/lsp/word.hpp"
#include "styles/library.hpp"
#include "styles/linearise.hpp"

namespace mansard::lsp {

enum class Kind : uint8_t {
  nothing,
  style,
  block,
  symbol,
  variable,
  function,
  parameter,
  file,
  operation,
  builtin,  ///< a function of the language
  attribute,
  selector,
  part,
  argument,
  annotation,
  super,
};

struct Meaning {
  Kind kind = Kind::nothing;
  std::string_view block;  ///< of a variable or function, empty for style-wide ones; the operation
                           ///< of a part or argument
  std::string_view name;
  const syntax::Style* style = nullptr;  ///< whose order decides; null: that of every style
  const void* scope = nullptr;           ///< the rule or function of a parameter

  explicit operator bool() const { return kind != Kind::nothing; }
  /// Of one kind and name; in which styles is another question.
  bool alike(const Meaning& other) const {
    return kind == other.kind && name == other.name && block == other.block && scope == other.scope;
  }
};

/// The names of all files of a library.
class Meanings {
 public:
  /// `words` are of these files and outlive this.
  Meanings(const Library& library, const std::vector<std::vector<Word>>& words);

  Meaning of(const Word& word) const;

  /// Itself first; alone when its parents contradict each other or are missing.
  const Order& order(const syntax::Style& style) const;

  /// The members that a style itself declares, in the order of the text.
  const std::vector<const Word*>& declared_in(const syntax::Style& style) const;

  /// Where the member is written in the order of `style`, most derived first, within a style in the
  /// order of the text; what a `replace` drops is left out. Of symbols rules, `abstract` and
  /// entries.
  std::vector<const Word*> written(const Meaning& meaning, const syntax::Style& style) const;
  /// The first of them that decide: of a symbol its rules in force, else its entries, else what
  /// asks for it. Of other kinds of names, where they are declared.
  std::vector<const Word*> definition(const Meaning& meaning) const;
  /// What the definition overrides, nearest style first.
  std::vector<const Word*> overridden(const Meaning& meaning) const;
  /// Writings in heirs of the style.
  std::vector<const Word*> overriding(const Meaning& meaning) const;

  /// All words that mean the same member: in every style that shares it with this one by an
  /// ancestor or an heir that has both. Includes the declarations.
  std::vector<const Word*> mentions(const Meaning& meaning) const;
  /// The styles among which a member is shared.
  std::vector<const syntax::Style*> family(const Meaning& meaning) const;

  const Library& library() const { return library_; }

 private:
  struct Key {
    Kind kind;
    std::string_view block, name;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const {
      const std::hash<std::string_view> hash;
      return (hash(key.name) * 31 + hash(key.block)) * 31 + static_cast<std::size_t>(key.kind);
    }
  };
  using Members = std::unordered_map<Key, std::vector<const Word*>, Hash>;

  void declare(const Word& word);
  const std::vector<const Word*>* find(const syntax::Style& style, const Key& key) const;
  bool has(const syntax::Style& style, const Key& key) const;
  bool has_rules(const syntax::Style& style, std::string_view symbol) const;
  Meaning of_emit(const Word& word) const;
  Meaning of_value(const Word& word) const;
  Meaning of_member(const Word& word) const;
  Meaning of_call(const Word& word) const;
  bool in_sight(const Word& word, std::string_view name, Meaning& found) const;
  std::vector<const Word*> alike(const Meaning& meaning) const;

  const Library& library_;
  const std::vector<std::vector<Word>>& words_;
  std::unordered_map<const syntax::Style*, Members> declared_;
  std::unordered_map<const syntax::Style*, std::vector<const Word*>> in_order_;
  mutable std::unordered_map<const syntax::Style*, Order> orders_;
};

}  // namespace mansard::lsp
