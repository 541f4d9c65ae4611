// A style with its inheritance resolved: for every symbol, variable, function, element and
// material, the one that is in force, who gave it and what it overrides. Nothing of inheritance is
// left for the derivation to do.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "grammar/diagnostic.hpp"
#include "grammar/syntax.hpp"
#include "styles/library.hpp"

namespace mansard {

/// Where a member was written.
struct Origin {
  const syntax::Style* style = nullptr;
  const syntax::Block* block = nullptr;  ///< null for style-wide members
};

/// The productions one style gives for a symbol.
struct Generation {
  Origin from;                                   ///< of the first of them
  std::vector<const syntax::Rule*> productions;  ///< in text order
  std::vector<Origin> origins;                   ///< one a production
};

/// generations[0] is in force; `super` in generations[k] means generations[k + 1], and the plain
/// terminal after the last.
struct SymbolRules {
  std::string_view name;
  std::vector<Generation> generations;
};

struct VariableBinding {
  std::string_view block;  ///< empty for style-wide
  std::string_view name;
  const syntax::Variable* syntax = nullptr;
  Origin from;
  std::vector<Origin> overrides;  ///< what it hides, nearest first
};

struct FunctionBinding {
  std::string_view block, name;
  const syntax::Function* syntax = nullptr;
  Origin from;
  std::vector<Origin> overrides;  ///< what it hides, nearest first
};

struct ElementChoice {
  const syntax::ElementAlternative* syntax = nullptr;
  Origin from;
};
struct ElementBinding {
  std::string_view symbol;
  std::vector<ElementChoice> alternatives;
};
struct MaterialChoice {
  const syntax::MaterialAlternative* syntax = nullptr;
  Origin from;
};
struct MaterialBinding {
  std::string_view symbol;
  const syntax::MaterialEntry* entry = nullptr;  ///< the one that said `per`
  std::vector<MaterialChoice> alternatives;
};

/// Who replaced an alternative of an element or material, or took it away.
struct Ending {
  Origin from;
  Span at;                                         ///< of the entry that did
  syntax::EntryKind how = syntax::EntryKind::set;  ///< set, take or remove
};

struct LinkedStyle {
  const syntax::Style* syntax = nullptr;
  std::vector<const syntax::Style*> order;  ///< C3, itself first
  std::string_view start = "FOOTPRINT";
  Span start_at;
  std::optional<uint64_t> seed;      ///< of the most derived @seed, 0 to 1e15
  std::vector<SymbolRules> symbols;  ///< those with productions
  std::vector<VariableBinding> variables;
  std::vector<FunctionBinding> functions;
  std::vector<ElementBinding> elements;  ///< a symbol that has rules keeps its entry; it rests
  std::vector<MaterialBinding> materials;
  /// Alternatives that were given and are in force no more.
  std::unordered_map<const syntax::ElementAlternative*, Ending> ended_elements;
  std::unordered_map<const syntax::MaterialAlternative*, Ending> ended_materials;
  /// Symbols that an `abstract` asks for and nobody gives.
  std::unordered_map<std::string_view, const syntax::AbstractSymbol*> asked;
  std::vector<Diagnostic> missing;  ///< abstract members nobody gave: errors once it is derived

  std::string_view name() const { return syntax->name.text; }
  const SymbolRules* find_symbol(std::string_view name) const;
  /// `block` empty: the style-wide one.
  const VariableBinding* find_variable(std::string_view block, std::string_view name) const;
  const FunctionBinding* find_function(std::string_view block, std::string_view name) const;
  bool has_block(std::string_view name) const;

  std::unordered_map<std::string_view, std::size_t> symbol_index;
  std::unordered_map<std::string, std::size_t> variable_index,
      function_index;                    ///< "Block.Name" or "Name"
  std::vector<std::string_view> blocks;  ///< those of rules, base style first
  std::unordered_set<std::string_view> block_set;
};

/// Some production goes on with the next generation.
bool uses_super(const Generation& generation);

/// Resolves one style of the library: C3 linearisation, merge of blocks, `replace`, `override`,
/// `final`, `abstract`, element add and take. Errors and warnings go to `diagnostics`; nullopt when
/// the order itself can not be made (missing parent, cycle, inconsistent order).
std::optional<LinkedStyle> link(const Library& library, const syntax::Style& style,
                                Diagnostics& diagnostics);

}  // namespace mansard
