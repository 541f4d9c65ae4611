// Every name that stands in a script, with where it stands: what hover, definition, references and
// rename are made from.
#pragma once

#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "grammar/syntax.hpp"

namespace mansard::lsp {

/// Where a name stands. What it means there depends on the style: see meaning.hpp.
enum class Site : uint8_t {
  style,            ///< the name of a style
  style_use,        ///< a parent, `Other::`, style("Other")
  block,            ///< the name of a block
  block_use,        ///< `Block` of `Block.Name`
  rule,             ///< the head of a rule
  abstract_symbol,  ///< abstract NAME
  entry,            ///< a symbol in Elements or Materials
  emit,             ///< in a successor: a symbol, a parameter or a variable
  symbol_use,       ///< start NAME, @per("NAME"), Other::NAME
  variable,         ///< var Name
  function,         ///< def name
  parameter,        ///< of a rule or function, also an index that is bound
  value,            ///< a name in an expression
  member_use,       ///< `Name` of `Block.Name`
  call,             ///< name(…) in an expression
  operation,
  argument,  ///< `overhang` of roof(…, overhang = 1)
  part,      ///< `reveal :` of an operation with named parts
  selector,  ///< `side :`, or a word in quotes that chooses edges
  file,      ///< the path of an import, a mesh or a picture
  annotation,
  super,
};

using Declared =
    std::variant<std::monostate, const syntax::Style*, const syntax::Block*, const syntax::Rule*,
                 const syntax::AbstractSymbol*, const syntax::Variable*, const syntax::Function*,
                 const syntax::ElementEntry*, const syntax::MaterialEntry*>;

struct Word {
  Span at;  ///< without quotes
  Site site;
  std::string_view text;
  const syntax::Style* style = nullptr;  ///< in which it stands
  const syntax::Block* block = nullptr;
  /// The rule or function around it: whose parameters it sees.
  const syntax::Rule* rule = nullptr;
  const syntax::Function* function = nullptr;
  /// The block of member_use and call, the style of symbol_use, the operation of argument, part.
  std::string_view of;
  bool any_style = false;  ///< of symbol_use: style(expr)::NAME
  Declared declares;
};

/// In the order of the text.
std::vector<Word> words_of(const syntax::File& file);

}  // namespace mansard::lsp
