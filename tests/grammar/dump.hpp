// The syntax tree as s-expressions, one member a line, for golden files.
#pragma once

#include <string>

#include "grammar/syntax.hpp"

namespace mansard {

std::string dump(const syntax::File& file);
std::string dump(const syntax::Expr& expr);

}  // namespace mansard
