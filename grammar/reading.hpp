// The state of one reading of a source: what the rules of the grammar share.
#pragma once

#include "grammar/build.hpp"
#include "grammar/diagnostic.hpp"
#include "grammar/parse.hpp"
#include "grammar/tape.hpp"
#include "grammar/trail.hpp"

namespace mansard {

/// Whose members are read.
enum class Level : uint8_t { file, style, rules, elements, materials };

/// What only the grammar can tell about the place of an error.
struct ErrorSite {
  const char* member = nullptr;  ///< where the member begins that could not be read
  const char* word = nullptr;    ///< where it goes on behind its annotations
  const char* behind = nullptr;  ///< the end of what stands before it; null: not known
  bool member_is_rule = false;   ///< it begins like a rule
  bool member_is_block = false;  ///< it begins like a block
  bool member_is_style = false;  ///< it begins like a style
  syntax::Name block;            ///< in whose braces it stands
  bool found_is_head = false;    ///< the offending word begins a rule
  Level level = Level::file;
};

class Reading {
 public:
  Reading(const Source& source, Diagnostics& diagnostics);

  /// The end of the space and comments that begin at `at`. A comment that is never closed takes the
  /// rest of the text.
  const char* after_space(const char* at);
  /// The end of the string that begins at `at`; null (and a complaint) where there is none.
  const char* after_text(const char* at);
  /// The end of what was meant to be a string: behind its closing quote, else of the line.
  const char* after_broken_text(const char* at) const;
  /// The end of the documentation line that follows `at`; null where none does.
  const char* after_doc(const char* at);
  const char* line_begin(const char* at) const;
  /// The first on or behind `at` that is no space on the same line.
  const char* after_blanks(const char* at) const;
  /// Of the name at `at`; 0 for a keyword or when there is none.
  static std::size_t name_length(const char* at, const char* end);
  static bool is_word(char c);

  /// The symbol that was read as the end of the rule before `member`, which is no member, though it
  /// stands where a rule begins; else null.
  const char* swallowed_head(const char* member) const;

  void take_block_item();
  void end_block(const char* end);
  void end_style(const char* end);

  void report(const ErrorSite& around);
  void report_missing_brace(const char* at);
  /// What can only be told when all is read.
  void finish();
  /// Nothing more is to be read: too many errors, or the text ended in the middle of a member.
  bool over() const { return over_; }

  uint32_t offset(const char* at) const { return static_cast<uint32_t>(at - begin_); }
  const char* end() const { return end_; }

  Tape tape;
  Trail trail;
  TreeBuilder tree;
  bool leaving = false;          ///< an error's recovery goes on outside of these members,
  Level leave_to = Level::file;  ///< among members of this level

 private:
  void add(Diagnostic diagnostic);
  const char* after_comment(const char* at);

  const Source& source_;
  Diagnostics& diagnostics_;
  std::size_t errors_before_;
  const char *begin_, *end_;
  const char *space_from_ = nullptr, *space_to_ = nullptr;
  const char* open_comment_ = nullptr;
  bool over_ = false;
};

}  // namespace mansard
