#include "interpreter/lint.hpp"

#include <utility>

#include "interpreter/lint/linting.hpp"

namespace mansard {

void lint(const Program& program, const syntax::File& file, Diagnostics& diagnostics) {
  Linting linting(program, file, diagnostics);
  warn_of_unreached(linting);
  warn_of_terminals(linting);
  warn_of_unread(linting);
  warn_of_chances(linting);
  warn_of_indices(linting);
  warn_of_shadows(linting);
  warn_of_defaults(linting);
  warn_of_snapping(linting);
}

Linting::Linting(const Program& p, const syntax::File& f, Diagnostics& d)
    : program(p), file(f), diagnostics(d), reach(p), reads(p) {
  const auto count = static_cast<uint16_t>(program.styles.size());
  for (uint16_t number = 0; number < count; ++number) {
    if (!reach.live(number)) continue;
    for (const syntax::Style* style : program.styles[number].linked->order) {
      heirs_[style].push_back(number);
    }
  }
}

const LinkedStyle* Linting::linked(const syntax::Style& style) const {
  const auto number = program.style_numbers.find(style.name.text);
  if (number == program.style_numbers.end()) return nullptr;
  const LinkedStyle* const found = program.styles[number->second].linked;
  return found->syntax == &style ? found : nullptr;
}

const std::vector<uint16_t>& Linting::live_heirs(const syntax::Style& style) const {
  static const std::vector<uint16_t> nobody;
  const auto found = heirs_.find(&style);
  return found == heirs_.end() ? nobody : found->second;
}

bool Linting::reached(const syntax::Style& style, uint32_t symbol) const {
  for (const uint16_t heir : live_heirs(style)) {
    if (reach.reached(heir, symbol)) return true;
  }
  return false;
}

void Linting::warn(std::string_view code, Span at, std::string text, std::string help,
                   std::vector<Note> notes) {
  Diagnostic d;
  d.severity = Severity::warning;
  d.code = code;
  d.at = at;
  d.text = std::move(text);
  d.help = std::move(help);
  d.notes = std::move(notes);
  diagnostics.add(std::move(d));
}

std::string_view Linting::nearest_of(std::string_view word,
                                     const std::vector<std::string_view>& candidates) {
  if (suggestions_left-- <= 0) return {};
  return nearest(word, candidates).value_or(std::string_view());
}

}  // namespace mansard
