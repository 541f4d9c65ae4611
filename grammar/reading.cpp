#include "grammar/reading.hpp"

#include <algorithm>
#include <cstring>

#include "grammar/explain.hpp"

namespace mansard {

namespace {

constexpr std::size_t max_errors = 50;

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
bool is_hex(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

const char* line_end(const char* at, const char* end) {
  const void* found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
  return found ? static_cast<const char*>(found) : end;
}

}  // namespace

Reading::Reading(const Source& source, Diagnostics& diagnostics)
    : tree(source, tape, diagnostics),
      source_(source),
      diagnostics_(diagnostics),
      errors_before_(diagnostics.errors()),
      begin_(source.text().data()),
      end_(begin_ + source.text().size()) {}

bool Reading::is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

// The last answer is kept: alternatives of the grammar ask for the same place again and again.
const char* Reading::after_space(const char* at) {
  if (at == end_ || (!is_space(*at) && *at != '/')) return at;
  if (at == space_from_) return space_to_;
  space_from_ = at;
  for (;;) {
    while (at < end_ && is_space(*at)) ++at;
    if (end_ - at < 2 || *at != '/' || (at[1] != '/' && at[1] != '*')) break;
    at = at[1] == '/' ? line_end(at, end_) : after_comment(at);
  }
  return space_to_ = at;
}

const char* Reading::after_comment(const char* at) {
  const char* const opening = at;
  std::size_t depth = 0;
  do {
    if (end_ - at < 2) {
      open_comment_ = opening;
      return end_;
    }
    if (at[0] == '/' && at[1] == '*') {
      ++depth, at += 2;
    } else if (at[0] == '*' && at[1] == '/') {
      --depth, at += 2;
    } else {
      ++at;
    }
  } while (depth > 0);
  return at;
}

const char* Reading::after_doc(const char* at) {
  const bool file_begins = at == begin_ || (at == begin_ + 3 && *begin_ == '\xEF');  // byte order
  bool first = file_begins || at[-1] == '\n';
  for (;;) {
    for (; at < end_ && is_space(*at); ++at) first = first || *at == '\n';
    if (end_ - at < 2 || *at != '/' || (at[1] != '/' && at[1] != '*')) return nullptr;
    const bool slashes = end_ - at >= 3 && at[1] == '/' && at[2] == '/';
    if (first && slashes && (end_ - at == 3 || at[3] != '/')) return line_end(at, end_);
    first = at[1] == '/';
    at = first ? line_end(at, end_) : after_comment(at);
  }
}

const char* Reading::line_begin(const char* at) const {
  return begin_ + source_.line_begin(source_.line_of(offset(at)));
}

const char* Reading::after_blanks(const char* at) const {
  while (at < end_ && (*at == ' ' || *at == '\t')) ++at;
  return at;
}

std::size_t Reading::name_length(const char* at, const char* end) {
  const auto is_ascii_word = [](char c) { return is_word(c) && static_cast<signed char>(c) >= 0; };
  const char* after = at;
  while (after < end && is_ascii_word(*after)) ++after;
  const std::string_view word(at, static_cast<std::size_t>(after - at));
  if (word.empty() || (word[0] >= '0' && word[0] <= '9')) return 0;
  const auto reserved = keywords();
  return std::find(reserved.begin(), reserved.end(), word) == reserved.end() ? word.size() : 0;
}

const char* Reading::after_broken_text(const char* at) const {
  for (++at; at < end_ && *at != '\n'; ++at) {
    if (*at == '"') return at + 1;
    if (*at == '\\' && at + 1 < end_ && at[1] != '\n') ++at;
  }
  return at;
}

const char* Reading::after_text(const char* at) {
  if (at == end_ || *at != '"') return nullptr;
  const char* const opening = at;
  for (++at; at < end_ && *at != '\n'; ++at) {
    if (*at == '"') return at + 1;
    if (*at != '\\') continue;
    const char next = at + 1 < end_ ? at[1] : '\n';
    if (next == '"' || next == '\\') {
      ++at;
    } else if (next == 'u' && end_ - at >= 6 && std::all_of(at + 2, at + 6, is_hex)) {
      at += 5;
    } else {
      const char* const after = next == '\n' ? at + 1 : at + 2;
      trail.complain(at, explain_escape(at, after, after_broken_text(opening)));
      return nullptr;
    }
  }
  const char* const after = at > opening + 1 && at[-1] == '\r' ? at - 1 : at;
  trail.complain(at, {opening, after, "the string is not closed on its line",
                      "a string ends with '\"'; a quote inside of it is written \\\"", at});
  return nullptr;
}

const char* Reading::swallowed_head(const char* member) const {
  if (tree.lost_head() == 0 || member == end_) return nullptr;
  const char* const head = begin_ + tree.lost_head();
  const char* const line = line_begin(member);
  const bool of_its_own = after_blanks(line) == member && member - line <= head - line_begin(head);
  return of_its_own ? nullptr : head;
}

void Reading::take_block_item() {
  tree.take_block_item();
  if (diagnostics_.errors() - errors_before_ >= max_errors) add({});
}

void Reading::end_block(const char* end) {
  tree.end_block(offset(end));
  if (leave_to == Level::style) leaving = false;
}

void Reading::end_style(const char* end) {
  tree.end_style(offset(end));
  leaving = false;
}

void Reading::report(const ErrorSite& around) {
  const Trail::Place& place = trail.furthest();
  if (!open_comment_) add(explain(source_, place, around, trail, tree.brief_variable_end));
  if (open_comment_ || place.at >= end_) over_ = true;
  trail.restart();
}

void Reading::report_missing_brace(const char* at) {
  if (!open_comment_ && !over_) add(explain_missing_brace(source_, at, trail.innermost()));
  over_ = true;
}

void Reading::finish() {
  if (!open_comment_) return;
  const uint32_t begin = offset(open_comment_);
  diagnostics_.add({Severity::error,
                    {},
                    {&source_, begin, begin + 2},
                    "the comment that begins here is never closed",
                    {},
                    {},
                    "comments nest: every '/*' needs a '*/' of its own"});
}

// An empty one only checks whether there have been too many.
void Reading::add(Diagnostic diagnostic) {
  const Span at = diagnostic.at;
  if (!diagnostic.text.empty()) diagnostics_.add(std::move(diagnostic));
  if (over_ || diagnostics_.errors() - errors_before_ < max_errors) return;
  over_ = true;
  diagnostics_.add({Severity::error,
                    {},
                    at,
                    "more than " + std::to_string(max_errors - 1) +
                        " errors in this file; the rest of it is not read",
                    {},
                    {},
                    {}});
}

}  // namespace mansard
