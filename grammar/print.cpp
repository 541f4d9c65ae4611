// A diagnostic as text: what, where, the user's line with carets, notes, help.
#include <algorithm>

#include "grammar/diagnostic.hpp"
#include "grammar/utf8.hpp"

namespace mansard {

namespace {

constexpr int widest = 120;  // columns of a user's line that are shown

struct Palette {
  const char *error, *warning, *gutter, *note, *bold, *off;
};
constexpr Palette plain{"", "", "", "", "", ""};
constexpr Palette colorful{"\033[1;31m", "\033[1;33m", "\033[1;34m",
                           "\033[1;36m", "\033[1m",    "\033[0m"};

/// A line as it is shown: tabs as spaces, what can not be shown as U+FFFD, with the columns at
/// which the characters of the user's line stand.
struct Shown {
  std::string text;
  uint32_t begin = 0, end = 0;  ///< offsets in the source
  std::vector<int> column;      ///< of each byte from begin to end, and of the end
};

// Shows the whole line, or what is around `focus` when that is too long.
Shown show(const Source& source, uint32_t line, uint32_t focus) {
  constexpr uint32_t before = 60, budget = widest;
  const std::string_view text = source.text();
  const uint32_t line_begin = source.line_begin(line);
  const auto line_end = static_cast<uint32_t>(line_begin + source.line(line).size());
  const auto continues = [&](uint32_t at) {
    return (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
  };

  Shown shown;
  shown.begin = line_begin;
  int column = 0;
  const auto put = [&](std::string_view glyph, int width) {
    shown.text += glyph;
    column += width;
  };
  if (line_end - line_begin > budget && focus - line_begin > before) {
    shown.begin = focus - before;
    while (shown.begin < focus && continues(shown.begin)) ++shown.begin;
    put("…", 1);
  }
  uint32_t at = shown.begin;
  while (at < line_end && column < widest) {
    const CodePoint c = decode(text, at);
    shown.column.insert(shown.column.end(), c.bytes, column);
    if (c.value == '\t') {
      const int width = 4 - column % 4;
      put(std::string(static_cast<std::size_t>(width), ' '), width);
    } else if (!c.valid || c.value < 0x20 || c.value == 0x7F) {
      put("\uFFFD", 1);
    } else {
      put(text.substr(at, c.bytes), columns(c.value));
    }
    at += c.bytes;
  }
  shown.end = at;
  shown.column.push_back(column);
  if (at < line_end) put("…", 1);
  return shown;
}

class Printer {
 public:
  Printer(const Diagnostic& diagnostic, bool color)
      : diagnostic_(diagnostic), palette_(color ? colorful : plain) {}

  std::string print() {
    measure_gutter();
    const bool error = diagnostic_.severity == Severity::error;
    out_ += error ? palette_.error : palette_.warning;
    out_ += error ? "error" : "warning";
    if (!diagnostic_.code.empty()) out_.append("[").append(diagnostic_.code).append("]");
    out_.append(palette_.off).append(palette_.bold).append(": ");
    out_.append(diagnostic_.text).append(palette_.off).append("\n");
    excerpts();
    for (const Note& note : diagnostic_.notes) {
      say("note", note.text);
      if (note.at) excerpt(note.at, {note.at});
    }
    if (!diagnostic_.help.empty()) say("help", diagnostic_.help);
    return std::move(out_);
  }

 private:
  static uint32_t line_of(Span at) { return at.source->position(at.begin).line; }

  void measure_gutter() {
    uint32_t last = 0;
    const auto see = [&](Span at) {
      if (at) last = std::max(last, line_of(at));
    };
    see(diagnostic_.at);
    for (const Span& at : diagnostic_.also) see(at);
    for (const Note& note : diagnostic_.notes) see(note.at);
    gutter_ = std::to_string(last).size();
  }

  // All carets of a line stand under one copy of it.
  void excerpts() {
    std::vector<Span> left = diagnostic_.also;
    if (diagnostic_.at) left.insert(left.begin(), diagnostic_.at);
    std::erase_if(left, [](const Span& at) { return !at; });
    while (!left.empty()) {
      const Span first = left.front();
      const auto elsewhere = [&](const Span& at) {
        return at.source != first.source || line_of(at) != line_of(first);
      };
      const auto rest = std::stable_partition(left.begin(), left.end(),
                                              [&](const Span& at) { return !elsewhere(at); });
      excerpt(first, {left.begin(), rest});
      left.erase(left.begin(), rest);
    }
  }

  void excerpt(Span at, const std::vector<Span>& spans) {
    const Source::Position place = at.source->position(at.begin);
    const std::string number = std::to_string(place.line);
    const std::string blank(gutter_, ' ');
    const Shown shown = show(*at.source, place.line, at.begin);
    out_.append(blank).append(palette_.gutter).append("--> ").append(palette_.off);
    out_.append(at.source->name()).append(":").append(number).append(":");
    out_.append(std::to_string(place.column)).append("\n");
    bar(blank), end_line();
    bar(std::string(gutter_ - number.size(), ' ') + number);
    if (!shown.text.empty()) out_.append(" ").append(shown.text);
    end_line();
    bar(blank);
    out_.append(" ").append(palette_.error).append(carets(shown, spans)).append(palette_.off);
    end_line();
  }

  static std::string carets(const Shown& shown, const std::vector<Span>& spans) {
    std::string row;
    for (const Span& span : spans) {
      if (span.begin < shown.begin || span.begin > shown.end) continue;
      const auto from = static_cast<std::size_t>(shown.column[span.begin - shown.begin]);
      const uint32_t last = std::clamp(span.end, span.begin, shown.end);
      const auto to = std::max<std::size_t>(
          from + 1, static_cast<std::size_t>(shown.column[last - shown.begin]));
      if (row.size() < to) row.resize(to, ' ');
      std::fill(row.begin() + static_cast<std::ptrdiff_t>(from),
                row.begin() + static_cast<std::ptrdiff_t>(to), '^');
    }
    return row;
  }

  void bar(const std::string& gutter) {
    out_.append(palette_.gutter).append(gutter).append(" |").append(palette_.off);
  }
  void say(const char* kind, const std::string& text) {
    out_.append(palette_.note).append(kind).append(palette_.off).append(": ").append(text);
    end_line();
  }
  void end_line() { out_ += '\n'; }

  const Diagnostic& diagnostic_;
  const Palette& palette_;
  std::size_t gutter_ = 1;
  std::string out_;
};

}  // namespace

std::string to_text(const Diagnostic& diagnostic, bool color) {
  return Printer(diagnostic, color).print();
}

}  // namespace mansard
