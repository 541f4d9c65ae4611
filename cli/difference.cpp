#include "cli/difference.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace mansard {
namespace {

using Lines = std::vector<std::string_view>;

constexpr std::size_t context = 3;
constexpr std::size_t largest_table = 40'000'000;  // pairs of lines

/// Each with its line end.
Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

/// Lines [a, a_end) of the one text became lines [b, b_end) of the other.
struct Change {
  std::size_t a = 0, a_end = 0, b = 0, b_end = 0;
};

/// By the longest common subsequence of lines of what is left between the common beginning and end.
std::vector<Change> changes(const Lines& a, const Lines& b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  std::size_t head = 0, tail = 0;
  while (head < shorter && a[head] == b[head]) ++head;
  while (tail < shorter - head && a[a.size() - 1 - tail] == b[b.size() - 1 - tail]) ++tail;
  const std::size_t n = a.size() - head - tail, m = b.size() - head - tail;
  if (n + m == 0) return {};
  if (n > 0 && m > largest_table / n) return {{head, head + n, head, head + m}};

  // common[i * (m + 1) + j]: how many lines a[i…] and b[j…] have in common
  std::vector<uint16_t> common((n + 1) * (m + 1));
  const auto at = [&](std::size_t i, std::size_t j) -> uint16_t& {
    return common[i * (m + 1) + j];
  };
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = m; j-- > 0;) {
      const bool same = a[head + i] == b[head + j];
      at(i, j) =
          same ? static_cast<uint16_t>(at(i + 1, j + 1) + 1) : std::max(at(i + 1, j), at(i, j + 1));
    }
  }
  std::vector<Change> all;
  for (std::size_t i = 0, j = 0; i < n || j < m;) {
    if (i < n && j < m && a[head + i] == b[head + j]) {
      ++i, ++j;
      continue;
    }
    Change change{head + i, head + i, head + j, head + j};
    while ((i < n || j < m) && !(i < n && j < m && a[head + i] == b[head + j])) {
      if (j == m || (i < n && at(i + 1, j) >= at(i, j + 1))) {
        change.a_end = head + ++i;
      } else {
        change.b_end = head + ++j;
      }
    }
    all.push_back(change);
  }
  return all;
}

std::string range(std::size_t begin, std::size_t end) {
  const std::size_t first = end > begin ? begin + 1 : begin;
  return std::to_string(first) + "," + std::to_string(end - begin);
}

void put(std::string& text, char sign, const Lines& lines, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    text.append(1, sign).append(lines[i]);
    if (!lines[i].ends_with('\n')) text += "\n\\ No newline at end of file\n";
  }
}

}  // namespace

std::string difference(std::string_view name, std::string_view before, std::string_view after) {
  const Lines a = lines_of(before), b = lines_of(after);
  const std::vector<Change> all = changes(a, b);
  std::string text;
  if (all.empty()) return text;
  text.append("--- ").append(name).append("\n+++ ").append(name).append("\n");
  for (std::size_t i = 0; i < all.size();) {
    std::size_t last = i;
    while (last + 1 < all.size() && all[last + 1].a - all[last].a_end <= 2 * context) ++last;
    const std::size_t lead = std::min(context, all[i].a);
    const std::size_t trail = std::min(context, a.size() - all[last].a_end);
    text += "@@ -" + range(all[i].a - lead, all[last].a_end + trail) + " +" +
            range(all[i].b - lead, all[last].b_end + trail) + " @@\n";
    std::size_t at = all[i].a - lead;
    for (; i <= last; ++i) {
      put(text, ' ', a, at, all[i].a);
      put(text, '-', a, all[i].a, all[i].a_end);
      put(text, '+', b, all[i].b, all[i].b_end);
      at = all[i].a_end;
    }
    put(text, ' ', a, at, at + trail);
  }
  return text;
}

}  // namespace mansard
