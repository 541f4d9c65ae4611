// What may be written at a place of a script, told from the tokens before it.
#pragma once

#include <string_view>
#include <vector>

#include "cli/lsp/tokens.hpp"

namespace mansard::lsp {

/// Parentheses that stand open: `name(…, …`.
struct OpenCall {
  std::string_view name, block;  ///< of `Block.name(`; empty for bare parentheses
  std::size_t argument = 0;      ///< how many commas came before
  bool is_step = false;          ///< in a successor: an operation or a symbol; else a function
};

struct Place {
  enum class Where : uint8_t {
    nowhere,    ///< in a comment, or where a new name is made up
    file,       ///< between styles
    parents,    ///< after the `:` of a style
    style,      ///< among the members of a style
    rules,      ///< among the members of a block
    elements,   ///< among the entries of Elements
    materials,  ///< among the entries of Materials
    successor,  ///< right of an arrow
    part,       ///< at the beginning of a part
    expression,
    of_style,     ///< after `Other::`
    of_block,     ///< after `Block.`
    annotation,   ///< after `@`
    import_path,  ///< in the quotes of an import
    text,         ///< in other quotes
  };
  Where where = Where::nowhere;
  std::string_view style, block;  ///< that the place stands in
  std::string_view rule;          ///< whose head came last in this block
  std::vector<std::string_view> params;
  std::string_view before;      ///< `Other` or `Block` of of_style and of_block
  std::string_view parts_of;    ///< the operation whose parts these are
  std::vector<OpenCall> calls;  ///< innermost last
  uint32_t begin = 0;           ///< of the word that is being written
  bool first_on_line = false;   ///< but for that word
  bool after_value = false;     ///< in a successor or an expression that might be over
};

Place place_at(std::string_view text, const std::vector<Token>& tokens, uint32_t offset);

}  // namespace mansard::lsp
