// After an error: report it, then skip to where the next member begins, so that one run finds every
// error of a file.
#pragma once

#include "grammar/control.hpp"

namespace mansard::peg {

/// Whether Rule would match at `at`.
template <class Rule, template <class...> class Control>
bool begins(Reading& reading, const char* at) {
  memory_input<tracking_mode::lazy, eol::lf_crlf, const char*> in(at, reading.end(), "");
  reading.trail.hush();
  const bool matched =
      Control<Rule>::template match<apply_mode::nothing, rewind_mode::required, nothing, Control>(
          in, reading);
  reading.trail.speak();
  return matched;
}

/// Where the word behind Rule, which may be empty, begins.
template <class Rule, template <class...> class Control>
const char* behind(Reading& reading, const char* at) {
  memory_input<tracking_mode::lazy, eol::lf_crlf, const char*> in(at, reading.end(), "");
  reading.trail.hush();
  Control<Rule>::template match<apply_mode::nothing, rewind_mode::required, nothing, Control>(
      in, reading);
  reading.trail.speak();
  return reading.after_space(in.current());
}

/// The same for its trail: what was wanted, and where.
template <class Rule, template <class...> class Control>
void begins_aloud(Reading& reading, const char* at) {
  memory_input<tracking_mode::lazy, eol::lf_crlf, const char*> in(at, reading.end(), "");
  reading.trail.restart();
  Control<Rule>::template match<apply_mode::nothing, rewind_mode::required, nothing, Control>(
      in, reading);
}

/// Skips the rest of a member that could not be read. Brackets that were open where reading failed
/// are closed on the way; the head of a member inside of them means that their ends are missing.
template <Level level, template <class...> class Control>
class Skip {
 public:
  Skip(Reading& reading, const char* member)
      : reading_(reading), member_(member), member_line_(reading.line_begin(member)) {}

  /// Where reading goes on; reading.leaving is set when that is not among members of this level.
  const char* run(const char* at, std::size_t open_braces) {
    open_ = open_braces;
    bool operand = false;  // what stands behind an operator begins nothing
    for (at = reading_.after_space(at); at < reading_.end(); at = reading_.after_space(past(at))) {
      if (*at == '{') ++open_;
      if (*at == '}' && !closes()) return at;
      if (starts_word(*at) && !operand && stops(at)) return at;
      operand = std::string_view(":+-*/<>=&|(,!~").find(*at) != std::string_view::npos;
    }
    return at;
  }

 private:
  static bool starts_word(char c) { return c == '@' || Reading::is_word(c); }

  const char* past(const char* at) const {
    if (*at == '"') return reading_.after_broken_text(at);
    do {
      ++at;
    } while (Reading::is_word(at[-1]) && at < reading_.end() && Reading::is_word(*at));
    return at;
  }

  // False for the brace that ends the members of this level.
  bool closes() {
    if (open_ == 0) return level == Level::file;
    --open_;
    return true;
  }

  bool stops(const char* at) {
    if (level == Level::file) return *at != '@' && at > member_ && is<style_start>(at);
    if (is<style_start>(at)) return leave(Level::file);
    if (is<any_block>(at)) return level == Level::style ? at > member_ : leave(Level::style);
    return at > member_ && (is_member(at) || looks_like_member(at));
  }

  bool is_member(const char* at) {
    if constexpr (level == Level::style) return is<style_item_start>(at);
    if constexpr (level == Level::rules) return is<member_start>(at);
    if constexpr (level == Level::elements) return is<element_start>(at);
    return is<material_start>(at);
  }

  // With an error of its own, but first on a line that is indented no deeper than the member's.
  bool looks_like_member(const char* at) const {
    constexpr std::array<std::string_view, 5> inner{"else", "then", "if", "super", "per"};
    const std::string_view word(at, static_cast<std::size_t>(past(at) - at));
    if (std::find(inner.begin(), inner.end(), word) != inner.end()) return false;
    const char* const line = reading_.line_begin(at);
    return reading_.after_blanks(line) == at &&
           at - line <= reading_.after_blanks(member_line_) - member_line_;
  }

  template <class Rule>
  bool is(const char* at) {
    return begins<Rule, Control>(reading_, at);
  }

  bool leave(Level to) {
    reading_.leaving = true;
    reading_.leave_to = to;
    return true;
  }

  Reading& reading_;
  const char* member_;
  const char* member_line_;
  std::size_t open_ = 0;
};

template <Level level>
template <apply_mode, rewind_mode, template <class...> class, template <class...> class Control,
          class In>
bool bad<level>::match(In& in, Reading& reading) {
  const char* const start = reading.after_space(in.current());
  const char* member = start;
  // `A -> B` and below it `C : W = 3 -> D` are read as `A -> B C`, and then `: …` is no member:
  // what is wrong is told from C on.
  if (const char* const head = reading.swallowed_head(start)) {
    member = head;
    begins_aloud<rule, Control>(reading, head);
  }
  const Trail::Place place = reading.trail.furthest();
  const char* const found = place.at ? std::max(place.at, member) : member;

  ErrorSite around;
  around.member = member;
  around.level = level;
  if (in.current() < member) around.behind = in.current();
  if (level != Level::file && level != Level::style) around.block = reading.tree.open_block().name;
  around.member_is_style = begins<style_start, Control>(reading, member);
  around.word = behind<preamble, Control>(reading, member);
  around.member_is_rule = begins<rule_start, Control>(reading, member);
  around.member_is_block = begins<any_block, Control>(reading, member);
  around.found_is_head = begins<head, Control>(reading, found);
  reading.report(around);
  // `A -> B [` is read as `A -> B`, and then `[` is no member.
  const bool torn = found > start && !Reading::is_word(*start) && *start != '@';
  if (torn || member < start) {
    reading.tree.drop_last(level == Level::style);
  }

  const char* at = reading.end();
  if (!reading.over()) {
    const std::size_t here = reading.trail.braces();
    const char* const from =
        place.complaint.resume ? place.complaint.resume : std::max(found, start);
    Skip<level, Control> skip(reading, member);
    at = skip.run(from, place.braces > here ? place.braces - here : 0);
  }
  reading.tape.cut(0);
  in.bump(static_cast<std::size_t>(at - in.current()));
  return true;
}

template <class In>
bool leave::read(In& in, Reading& reading) {
  return reading.leaving || reading.over() || reading.after_space(in.current()) == in.end();
}

template <class In>
bool missing_brace::read(In& in, Reading& reading) {
  if (reading.leaving) return true;
  const char* const at = reading.after_space(in.current());
  reading.tree.drop_last_warnings();
  reading.report_missing_brace(at);
  in.bump(static_cast<std::size_t>(at - in.current()));
  return true;
}

}  // namespace mansard::peg
