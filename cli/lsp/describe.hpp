// What there is to say of a member of a style: Markdown with its documentation, the text in force,
// what that is worth, who gave it, what it overrides and who overrides it.
#pragma once

#include <string>

#include "cli/lsp/view.hpp"

namespace mansard::lsp {

/// Empty for what is declared nowhere.
std::string describe(View& view, const Meaning& meaning);

/// The lines after `///` before a declaration, as they were written.
std::string documentation(const Word& declared);
/// The text of a declaration, its indentation taken away, at most so many lines.
std::string declaration_text(const Word& declared, std::size_t most_lines = 12);

}  // namespace mansard::lsp
