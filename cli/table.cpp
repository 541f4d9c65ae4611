#include "cli/table.hpp"

#include <algorithm>

#include "grammar/utf8.hpp"

namespace mansard {

namespace {

constexpr std::size_t gap = 2;

/// Bytes of the longest beginning that takes at most `width` columns.
std::size_t fitting(std::string_view text, std::size_t width) {
  std::size_t end = 0, used = 0;
  while (end < text.size()) {
    const CodePoint character = decode(text, end);
    used += static_cast<std::size_t>(columns(character.value));
    if (used > width) break;
    end += character.bytes;
  }
  return end;
}

}  // namespace

std::size_t width_of(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint character = decode(text, at);
    width += static_cast<std::size_t>(columns(character.value));
    at += character.bytes;
  }
  return width;
}

std::string cut_to(std::string_view text, std::size_t width) {
  if (width_of(text) <= width) return std::string(text);
  std::size_t end = fitting(text, width - std::min<std::size_t>(width, 1));
  while (end > 0 && text[end - 1] == ' ') --end;
  return std::string(text.substr(0, end)) + "…";
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  const std::size_t words = std::min(text.find_first_not_of(' '), text.size());
  const std::string indent(std::min(words + 4, width / 2), ' ');
  std::vector<std::string> lines;
  std::string line;
  while (width_of(text) > width - line.size()) {
    const std::size_t end = std::max<std::size_t>(fitting(text, width - line.size()), 1);
    const std::size_t space = text.rfind(' ', end);
    const bool between_words =
        space != std::string_view::npos && space > (lines.empty() ? words : 0);
    lines.push_back(line.append(text.substr(0, between_words ? space : end)));
    text.remove_prefix(between_words ? space + 1 : end);
    line = indent;
  }
  lines.push_back(line.append(text));
  return lines;
}

std::string inked(const std::string& text, Ink ink) {
  if (ink == Ink::plain || text.empty()) return text;
  return (ink == Ink::strong ? "\x1b[1m" : "\x1b[2m") + text + "\x1b[0m";
}

std::vector<std::size_t> Table::widths(std::size_t page_width) const {
  std::vector<std::size_t> widths;
  for (const Line& line : lines_) {
    if (line.alone) continue;
    widths.resize(std::max(widths.size(), line.cells.size()));
    for (std::size_t i = 0; i < line.cells.size(); ++i)
      widths[i] = std::max(widths[i], width_of(line.cells[i].text));
  }
  std::size_t total = 0;
  for (const std::size_t width : widths) total += width > 0 ? width + gap : 0;
  total -= std::min(total, gap);
  if (elastic_ < widths.size() && total > page_width) {
    constexpr std::size_t least = 12;
    std::size_t& elastic = widths[elastic_];
    elastic -= std::min(total - page_width, elastic - std::min(least, elastic));
  }
  return widths;
}

std::string Table::text(bool color, std::size_t page_width) const {
  const std::vector<std::size_t> widths = this->widths(page_width);
  std::string all;
  for (const Line& line : lines_) {
    std::string text;
    std::size_t owed = 0;  // spaces before the next thing that is seen
    for (std::size_t i = 0; i < line.cells.size(); ++i) {
      const Cell& cell = line.cells[i];
      if (!line.alone && widths[i] == 0) continue;
      const std::string shown = cut_to(cell.text, line.alone ? page_width : widths[i]);
      const std::size_t rest = line.alone ? 0 : widths[i] - width_of(shown);
      if (cell.to_the_right) owed += rest;
      if (!shown.empty()) {
        text.append(owed, ' ').append(color ? inked(shown, cell.ink) : shown);
        owed = 0;
      }
      owed += gap + (cell.to_the_right ? 0 : rest);
    }
    all += text + "\n";
  }
  return all;
}

}  // namespace mansard
