// W017: a terminal whose name is a slip of the keys away from that of a symbol with rules or
// entries.
#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <unordered_map>

#include "interpreter/lint/linting.hpp"
#include "interpreter/lint/walk.hpp"

namespace mansard {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool same_case(char a, char b) {
  return is_letter(a) && is_letter(b) && is_upper(a) == is_upper(b);
}

/// Whether `word` is `name` with two neighbouring letters swapped, one left out, one too many or
/// one changed, where that is hardly meant: plurals, numbers and letters at the end tell names
/// apart, and so do single letters of short words.
bool is_slip(std::string_view word, std::string_view name) {
  std::size_t front = 0, back = 0;
  const std::size_t shorter = std::min(word.size(), name.size());
  while (front < shorter && word[front] == name[front]) ++front;
  while (back < shorter - front && word[word.size() - 1 - back] == name[name.size() - 1 - back])
    ++back;
  if (front == 0) return false;
  if (word.size() == name.size()) {
    const std::size_t differ = word.size() - front - back;
    if (differ == 2) {
      return word.size() >= 4 && word[front] == name[front + 1] && word[front + 1] == name[front];
    }
    return differ == 1 && back > 0 && word.size() >= 6 && same_case(word[front], name[front]);
  }
  if (front + back < shorter) return false;
  if (word.size() == name.size() + 1) {
    return name.size() >= 5 && back > 0 && same_case(word[front], word[front - 1]);
  }
  if (word.size() + 1 != name.size() || word.size() < 4) return false;
  const char missing = name[front];
  if (back > 0) {  // EntrancePnel, but not PanelFront beside PanelAFront
    return word.size() >= 5 && (same_case(missing, name[front - 1]) ||
                                (!is_upper(missing) && same_case(missing, name[front + 1])));
  }
  return same_case(missing, name[front - 1]) && missing != 'S' && missing != 's';
}

/// Where the script emits each symbol, when that is one place only.
struct Emitted {
  const Linting& linting;
  std::map<uint32_t, std::set<uint32_t>> places = {};

  void step(const Step& step) {
    if (step.kind == StepKind::emit && linting.here(step.at))
      places[step.what].insert(step.at.begin);
  }
  void expression(ExprId) {}
};

Emitted emitted_in(const Linting& linting) {
  Emitted emitted{linting};
  for (const Production& production : linting.program.productions) {
    if (linting.here(production.syntax->head))
      walk_production(linting.program, production, emitted);
  }
  return emitted;
}

/// Finds the names that are one letter away, by what is left of them without any one letter.
class Neighbours {
 public:
  void add(uint32_t symbol, std::string_view name) {
    for_each_key(name, [&](const std::string& key) { symbols_[key].push_back(symbol); });
  }
  std::set<uint32_t> of(std::string_view name) const {
    std::set<uint32_t> found;
    for_each_key(name, [&](const std::string& key) {
      const auto at = symbols_.find(key);
      if (at != symbols_.end()) found.insert(at->second.begin(), at->second.end());
    });
    return found;
  }

 private:
  template <class F>
  static void for_each_key(std::string_view name, F f) {
    constexpr std::size_t longest = 64;
    if (name.size() > longest) return;
    f(std::string(name));
    for (std::size_t i = 0; i < name.size(); ++i) {
      f(std::string(name.substr(0, i)).append(name.substr(i + 1)));
    }
  }
  std::unordered_map<std::string, std::vector<uint32_t>> symbols_;
};

bool is_described(const CompiledStyle& style, uint32_t symbol) {
  return style.rules[symbol] != none || style.elements[symbol] != none ||
         style.materials[symbol] != none;
}

}  // namespace

void warn_of_terminals(Linting& linting) {
  const Program& program = linting.program;
  Neighbours described;
  for (uint32_t symbol = 0; symbol < program.symbols.size(); ++symbol) {
    const bool somewhere = std::ranges::any_of(
        program.styles, [&](const CompiledStyle& style) { return is_described(style, symbol); });
    if (somewhere) described.add(symbol, program.symbols[symbol]);
  }
  const Emitted emitted = emitted_in(linting);
  for (const auto& [terminal, places] : emitted.places) {
    if (places.size() > 1 || terminal == nil_symbol || linting.suspected.contains(terminal))
      continue;
    const std::string_view word = program.symbols[terminal];
    const Span at{linting.file.source, *places.begin(),
                  *places.begin() + static_cast<uint32_t>(word.size())};
    for (const uint32_t near : described.of(word)) {
      if (!is_slip(word, program.symbols[near])) continue;
      const bool meant =
          std::ranges::any_of(program.styles, [&, symbol = terminal](const CompiledStyle& style) {
            const auto number = static_cast<uint16_t>(&style - program.styles.data());
            return linting.reach.reached(number, symbol) && !is_described(style, symbol) &&
                   is_described(style, near);
          });
      if (!meant) continue;
      const bool has_rules = std::ranges::any_of(
          program.styles, [&](const CompiledStyle& style) { return style.rules[near] != none; });
      linting.warn("W017", at,
                   "'" + std::string(word) + "' has no rules, but '" +
                       std::string(program.symbols[near]) + "' has " +
                       (has_rules ? "some" : "elements or materials"),
                   "did you mean '" + std::string(program.symbols[near]) + "'?");
      break;
    }
  }
}

}  // namespace mansard
