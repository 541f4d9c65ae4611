#include "grammar/diagnostic.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "grammar/in_quotes.hpp"

namespace mansard {

namespace {

bool is_separator(char c) { return c == ' ' || c == ',' || c == ':' || c == '\t'; }

// `// allow W001` or `// allow W001, W004 because …`, anywhere on the line.
bool allows(std::string_view line, std::string_view code) {
  constexpr std::string_view marker = "allow";
  for (std::size_t at = line.find("//"); at != line.npos; at = line.find("//", at + 1)) {
    std::string_view rest = line.substr(at + 2);
    while (!rest.empty() && (is_separator(rest[0]) || rest[0] == '/')) rest.remove_prefix(1);
    if (rest.substr(0, marker.size()) != marker) continue;
    rest.remove_prefix(marker.size());
    while (!rest.empty() && is_separator(rest[0])) {
      while (!rest.empty() && is_separator(rest[0])) rest.remove_prefix(1);
      std::size_t end = 0;
      while (end < rest.size() && !is_separator(rest[end])) ++end;
      if (rest.substr(0, end) == code) return true;
      rest.remove_prefix(end);
    }
  }
  return false;
}

}  // namespace

void Diagnostics::add(Diagnostic diagnostic) {
  const bool warning = diagnostic.severity == Severity::warning;
  if (warning && diagnostic.at && !diagnostic.code.empty()) {
    const Source& source = *diagnostic.at.source;
    if (allows(source.line(source.position(diagnostic.at.begin).line), diagnostic.code)) return;
  }
  const Seen seen{diagnostic.at.source, diagnostic.at.begin, diagnostic.at.end,
                  std::string(diagnostic.code) + diagnostic.text};
  if (!seen_.insert(seen).second) return;
  if (!warning) ++errors_;
  all_.push_back(std::move(diagnostic));
}

void Diagnostics::sort() {
  std::map<const Source*, std::size_t> order;
  for (const Diagnostic& d : all_) order.emplace(d.at.source, order.size());
  std::stable_sort(all_.begin(), all_.end(), [&](const Diagnostic& a, const Diagnostic& b) {
    const auto key = [&](const Diagnostic& d) {
      return std::tuple(order[d.at.source], d.at.begin, d.severity, d.at.end);
    };
    return key(a) < key(b);
  });
}

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Optimal string alignment: insertions, deletions, changes and swaps of neighbours count one each.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                           lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string made(1, '\'');
  std::size_t end = text.size();
  if (end > longest) {
    for (end = longest - 3; end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80;)
      --end;
  }
  made.append(text.substr(0, end));
  if (end < text.size()) made.append("…");
  made.push_back('\'');
  return made;
}

std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates) {
  constexpr std::size_t longest = 64;
  if (word.empty() || word.size() > longest) return std::nullopt;
  std::optional<std::string_view> best;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string_view candidate : candidates) {
    const std::size_t longer = std::max(word.size(), candidate.size());
    if (longer - std::min(word.size(), candidate.size()) >= least) continue;
    const std::size_t far = distance(word, candidate);
    if (far < least && far < longer) least = far, best = candidate;
  }
  return best;
}

}  // namespace mansard
