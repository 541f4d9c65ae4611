// From text to the syntax tree.
#pragma once

#include "grammar/diagnostic.hpp"
#include "grammar/syntax.hpp"

namespace mansard {

/// Reads a whole file. Every syntax error is added to `diagnostics`; reading goes on at the next
/// member, so one run reports them all and the tree holds what was sound. Never throws for any
/// input: depth of open brackets is bounded (250), invalid UTF-8 and control characters are errors
/// with a place.
syntax::File parse(const Source& source, Diagnostics& diagnostics);

/// Parses the value of `--set NAME=VALUE` or one expression of the command line; null after an
/// error.
syntax::ExprPtr parse_expression(const Source& source, Diagnostics& diagnostics);

/// The words that can not be names (one list for parser, docs and editors).
std::span<const std::string_view> keywords();

/// A word that code, documents and the user would all call a name: letter or _, then letters,
/// digits, _.
bool is_name(std::string_view text);

}  // namespace mansard
