// The text that the formatter writes, a token at a time, with the comments where they stood.
#pragma once

#include <algorithm>
#include <string>
#include <tuple>

#include "grammar/spacing.hpp"

namespace mansard::layout {

constexpr int page_width = 100;  // columns; comments behind the code of a line do not count
constexpr int rightmost = 76;    // column where a line begins: however deep its brackets stand

class Page {
 public:
  Page(const Tokens& tokens, const Spacing& spacing)
      : tokens_(tokens), spacing_(spacing), pads_(tokens.count()) {}

  /// The next token begins a line at this column.
  void line(int column) { now_.pending = now_.pending_comments = std::min(column, rightmost); }
  /// The same for a member: one blank line before it and each of its comments is kept.
  void member_line(int column);
  /// The same for the brace that ends members: comments before it are indented as they are.
  void closing_line(int column);
  void put(uint32_t token);
  void put(Range range);

  /// Where the token would begin.
  int column(uint32_t token) const;
  /// The range would stand in this line, with `tail` columns more behind it.
  bool fits(Range range, int tail) const;
  int width(Range range) const { return spacing_.width(range); }
  bool flat(Range range) const { return spacing_.flat(range); }

  /// More columns before a token where it does not begin a line.
  void pad(uint32_t token, int columns) { pads_[token] = columns; }
  /// Of all tokens of the range.
  int padding(Range range) const;

  /// While it lives, lines that nothing but a comment breaks go on at this column.
  class Base {
   public:
    Base(Page& page, int column) : page_(page), before_(page.base_) {
      page.base_ = std::min(column, rightmost);
    }
    ~Base() { page_.base_ = before_; }
    Base(const Base&) = delete;
    Base& operator=(const Base&) = delete;

   private:
    Page& page_;
    int before_;
  };

  struct Cost {
    int excess = 0;  ///< columns beyond the width, of all lines
    int lines = 0;
    friend bool operator<=(const Cost& a, const Cost& b) {
      return std::tie(a.excess, a.lines) <= std::tie(b.excess, b.lines);
    }
  };
  /// What an attempt to write something costs; the page is as before.
  template <class Write>
  Cost cost(Write write);

  /// The whole, with the comments behind the code of consecutive lines aligned.
  std::string text() const;

 private:
  struct State {
    int column = 0;
    int indent = 0;                               // of the line
    int pending = none, pending_comments = none;  // where the next token begins a line
    bool blanks = false;
    Cost cost;
  };
  struct Trailing {  // a comment behind code
    std::size_t at = 0;
    int line = 0, indent = 0, column = 0;
  };
  static constexpr int none = -1;

  void new_line(int column, bool blank);
  void space(int columns);
  void write(const Comment& comment);
  void write_many_lines(const Comment& comment);

  const Tokens& tokens_;
  const Spacing& spacing_;
  std::vector<int> pads_;
  std::string text_;
  State now_;
  int base_ = 0;
  std::vector<Trailing> trailing_;
};

template <class Write>
Page::Cost Page::cost(Write write) {
  const State before = now_;
  const std::size_t size = text_.size(), comments = trailing_.size();
  write();
  const Cost made{now_.cost.excess - before.cost.excess, now_.cost.lines - before.cost.lines};
  now_ = before;
  text_.resize(size);
  trailing_.resize(comments);
  return made;
}

}  // namespace mansard::layout
