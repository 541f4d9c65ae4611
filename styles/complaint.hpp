// The phrases that all diagnostics of linking share.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/diagnostic.hpp"
#include "grammar/in_quotes.hpp"
#include "grammar/syntax.hpp"

namespace mansard {

/// "A, B, C".
std::string listed(std::span<const syntax::Style* const> styles);

Diagnostic error(Span at, std::string text, std::vector<Note> notes, std::string help = {});
Diagnostic warning(std::string_view code, Span at, std::string text, std::vector<Note> notes,
                   std::string help = {});

/// The last note of each diagnostic: the style that has the problem. An heir has it too, but says
/// it in the same words, so that Diagnostics drops the repeat.
Note while_linking(const syntax::Style& style);

/// "did you mean 'TILE'?", or empty when nothing is near. Looks at a bounded number of candidates.
std::string did_you_mean(std::string_view word, std::vector<std::string_view> candidates);

}  // namespace mansard
