// What we tell the user when something is wrong, and how it is printed.
#pragma once

#include <exception>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "grammar/source.hpp"

namespace mansard {

enum class Severity : uint8_t { error, warning };

struct Note {
  std::string text;  ///< "while checking block 'Floor' of style 'Terrace'"
  Span at;           ///< may be nowhere
};

/// `text` is lower case without a full stop, quotes the user's own word and says what was expected.
/// `code` is a row of grammar/codes.hpp (mansard help CODE); empty for errors that need no page.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string_view code;
  Span at;
  std::string text;
  std::vector<Span> also;  ///< more carets on the same or other lines
  std::vector<Note> notes;
  std::string help;
};

/// The user's input is wrong. Caught at parse, link, derive and main; frames on the way add notes.
struct Failure : std::exception {
  explicit Failure(Diagnostic d) : diagnostic(std::move(d)) {}
  const char* what() const noexcept override { return diagnostic.text.c_str(); }
  Diagnostic diagnostic;
};

/// Collects diagnostics, drops exact repeats and warnings that `// allow CODE` on their line
/// silences.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic);
  bool has_errors() const { return errors_ > 0; }
  std::size_t errors() const { return errors_; }
  std::span<const Diagnostic> all() const { return all_; }
  /// By file in order of first appearance, then by position; at one place errors first, and what
  /// speaks of fewer words, which is the cause of what is wrong with more.
  void sort();

 private:
  using Seen = std::tuple<const Source*, uint32_t, uint32_t, std::string>;

  std::vector<Diagnostic> all_;
  std::set<Seen> seen_;
  std::size_t errors_ = 0;
};

/// The printed form of the command line's document: text, place, the user's line with carets, notes
/// and help. Ends with a line end. Tabs and wide characters keep the carets in place; long lines
/// are cut around the caret.
std::string to_text(const Diagnostic& diagnostic, bool color = false);
/// One JSON object: severity, code, text, file, line, column, end_line, end_column, notes, help.
std::string to_json(const Diagnostic& diagnostic);
/// The same for a plain line of progress or summary, of severity "note".
std::string note_to_json(std::string_view text);

/// The candidate most like `word` (edit distance, case ignored), when it is near enough to be
/// meant.
std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates);

}  // namespace mansard
