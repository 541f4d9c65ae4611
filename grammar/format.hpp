// The one layout of a script: `mansard format`, and what editors ask for.
#pragma once

#include <optional>
#include <string>

#include "grammar/diagnostic.hpp"

namespace mansard {

/// The text of `source` laid out anew: every word, sign, literal and comment of it in its order,
/// only the space between them changed (and `class` written `style`). Lines end with LF and are at
/// most 100 columns wide where they can be. format() of its own result gives that result; what the
/// script derives is the same. Nothing when the text has syntax errors; they are added to
/// `diagnostics`, and so are warnings.
std::optional<std::string> format(const Source& source, Diagnostics& diagnostics);

}  // namespace mansard
