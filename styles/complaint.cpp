#include "styles/complaint.hpp"

#include <utility>

namespace mansard {

std::string listed(std::span<const syntax::Style* const> styles) {
  std::string text;
  for (const syntax::Style* style : styles) {
    if (!text.empty()) text += ", ";
    text += style->name.text;
  }
  return text;
}

Diagnostic error(Span at, std::string text, std::vector<Note> notes, std::string help) {
  Diagnostic diagnostic;
  diagnostic.at = at;
  diagnostic.text = std::move(text);
  diagnostic.notes = std::move(notes);
  diagnostic.help = std::move(help);
  return diagnostic;
}

Diagnostic warning(std::string_view code, Span at, std::string text, std::vector<Note> notes,
                   std::string help) {
  Diagnostic diagnostic = error(at, std::move(text), std::move(notes), std::move(help));
  diagnostic.severity = Severity::warning;
  diagnostic.code = code;
  return diagnostic;
}

Note while_linking(const syntax::Style& style) {
  return {"while linking style " + in_quotes(style.name.text), {}};
}

// A hostile script has a million names; edit distances to all of them would take for ever.
std::string did_you_mean(std::string_view word, std::vector<std::string_view> candidates) {
  constexpr std::size_t most_candidates = 1000;
  if (candidates.size() > most_candidates) candidates.resize(most_candidates);
  const auto found = nearest(word, candidates);
  return found ? "did you mean " + in_quotes(*found) + "?" : std::string();
}

}  // namespace mansard
