#include "grammar/page.hpp"

#include <algorithm>
#include <numeric>

namespace mansard::layout {

void Page::member_line(int column) {
  line(column);
  now_.blanks = true;
}

void Page::closing_line(int column) {
  member_line(column);
  now_.pending_comments = column + indentation;
}

// ---- tokens

void Page::put(Range range) {
  for (uint32_t i = range.first; i <= range.last; ++i) {
    if (i > range.first && spacing_.begins_line(i)) line(base_);
    put(i);
  }
}

// Comments go where they stood: behind the token before, or on lines of their own.
void Page::put(uint32_t i) {
  const Token& token = tokens_[i];
  const bool pending = now_.pending != none, blanks = now_.blanks;
  const int own = pending ? now_.pending_comments : base_;
  bool fresh = i > 0 && tokens_[i - 1].text == "{";  // no blank line behind a '{'
  bool leads = false, ended = false;                 // a comment before it on its line; above it
  for (uint32_t c = token.comments; c < token.comments_end; ++c) {
    const Comment& comment = tokens_.comment(c);
    if (comment.own_line) {
      new_line(own, blanks && comment.blank_before && !fresh);
      fresh = false;
    } else if (comment.to_line_end) {
      trailing_.push_back({text_.size(), now_.cost.lines, now_.indent, now_.column});
      space(2);
    } else {
      space(c == token.comments ? spacing_.gap_before_comment(i) : 1);
    }
    write(comment);
    ended = comment.to_line_end || (comment.own_line && comment.ends_line);
    leads = (leads || comment.own_line) && !comment.ends_line;
  }
  const bool closes = token.text == "}" || token.kind == Kind::end;
  if (leads) {
    space(spacing_.gap_behind_comment(i));
  } else if (pending || ended) {
    new_line(pending ? now_.pending : base_, blanks && token.blank_before && !fresh && !closes);
  } else if (token.comments != token.comments_end) {
    space(spacing_.gap_behind_comment(i) + pads_[i]);
  } else {
    space(spacing_.gap(i) + pads_[i]);
  }
  text_ += token.text;
  const int before = now_.column;
  now_.column += token.width;
  now_.cost.excess += std::max(0, now_.column - page_width) - std::max(0, before - page_width);
  now_.pending = none;
  now_.blanks = false;
}

void Page::new_line(int column, bool blank) {
  if (text_.empty()) return;
  text_.append(blank ? "\n\n" : "\n");
  now_.cost.lines += blank ? 2 : 1;
  now_.column = 0;
  now_.indent = column;
  if (column > 0) space(column);
}

void Page::space(int columns) {
  text_.append(static_cast<std::size_t>(columns), ' ');
  now_.column += columns;
}

// ---- comments

void Page::write(const Comment& comment) {
  if (comment.many_lines) {
    write_many_lines(comment);
  } else {
    text_ += comment.text;
    now_.column += comment.width;
  }
}

namespace {

std::string_view without_end(std::string_view line) {
  const std::size_t last = line.find_last_not_of(" \t\r");
  return line.substr(0, last == line.npos ? 0 : last + 1);
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(without_end(text.substr(at, end - at)));
    at = end + 1;
  }
  return lines;
}

}  // namespace

// Lines that begin with a star are aligned below the first one; any others stay as they are.
void Page::write_many_lines(const Comment& comment) {
  const std::vector<std::string_view> lines = lines_of(comment.text);
  const auto inner = [](std::string_view line) {
    return line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
  };
  const bool stars = std::all_of(lines.begin() + 1, lines.end(), [&](std::string_view line) {
    return inner(line).starts_with('*');
  });
  const int column = now_.column;
  text_ += lines[0];
  for (std::size_t i = 1; i < lines.size(); ++i) {
    new_line(stars ? column + 1 : 0, false);
    text_ += stars ? inner(lines[i]) : lines[i];
  }
  now_.column = stars ? column + 1 + static_cast<int>(inner(lines.back()).size()) : comment.width;
}

// ---- what would be

// Behind a comment that breaks the line, the column at which lines go on: how much stands before
// the token on its new line depends on how the comments were written.
int Page::column(uint32_t i) const {
  const Token& token = tokens_[i];
  if (now_.pending != none) return now_.pending;
  int column = now_.column;
  for (uint32_t c = token.comments; c < token.comments_end; ++c) {
    const Comment& comment = tokens_.comment(c);
    if (comment.own_line || comment.to_line_end || comment.many_lines) return base_;
    column += (c == token.comments ? spacing_.gap_before_comment(i) : 1) + comment.width;
  }
  const bool commented = token.comments != token.comments_end;
  return column + (commented ? spacing_.gap_behind_comment(i) : spacing_.gap(i)) + pads_[i];
}

int Page::padding(Range range) const {
  return std::accumulate(pads_.begin() + range.first, pads_.begin() + range.last + 1, 0);
}

bool Page::fits(Range range, int tail) const {
  return flat(range) && column(range.first) + width(range) + tail <= page_width;
}

// ---- comments behind code

std::string Page::text() const {
  constexpr int most_padding = 40;
  std::string made;
  std::size_t written = 0;
  for (std::size_t i = 0; i < trailing_.size();) {
    int low = trailing_[i].column, high = low;
    std::size_t end = i + 1;
    for (; end < trailing_.size() && trailing_[end].line == trailing_[end - 1].line + 1; ++end) {
      const int column = trailing_[end].column;
      if (trailing_[end].indent != trailing_[i].indent) break;
      if (std::max(high, column) - std::min(low, column) > most_padding) break;
      low = std::min(low, column), high = std::max(high, column);
    }
    for (; i < end; ++i) {
      made.append(text_, written, trailing_[i].at - written);
      made.append(static_cast<std::size_t>(high - trailing_[i].column), ' ');
      written = trailing_[i].at;
    }
  }
  return made.append(text_, written);
}

}  // namespace mansard::layout
