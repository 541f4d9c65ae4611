// Text in aligned columns for a terminal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mansard {

enum class Ink : uint8_t { plain, strong, faint };

struct Cell {
  std::string text;
  Ink ink = Ink::plain;
  bool to_the_right = false;
};

/// Columns of a terminal that the text takes.
std::size_t width_of(std::string_view text);
/// Cut to at most `width` columns, with an ellipsis where something is missing.
std::string cut_to(std::string_view text, std::size_t width);
/// Lines of at most `width` columns, broken at spaces where there are any; the first of them tells
/// how far the others are indented, and they are a little more.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);
/// With the terminal's colours.
std::string inked(const std::string& text, Ink ink);

/// Rows whose cells stand below each other, and lines between them. One column, the elastic one, is
/// cut where the rows would be wider than the page. Two spaces divide columns; one in which nothing
/// stands takes no room.
class Table {
 public:
  explicit Table(std::size_t elastic) : elastic_(elastic) {}

  void row(std::vector<Cell> cells) { lines_.push_back({std::move(cells), false}); }
  /// A line of its own that makes no column wider.
  void line(Cell cell = {}) { lines_.push_back({{std::move(cell)}, true}); }
  bool empty() const { return lines_.empty(); }
  /// Ends with a line end.
  std::string text(bool color, std::size_t page_width = 100) const;

 private:
  struct Line {
    std::vector<Cell> cells;
    bool alone;
  };
  std::vector<std::size_t> widths(std::size_t page_width) const;

  std::size_t elastic_;
  std::vector<Line> lines_;
};

}  // namespace mansard
