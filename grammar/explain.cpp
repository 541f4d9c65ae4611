#include "grammar/explain.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "grammar/in_quotes.hpp"
#include "grammar/lonely_brace.hpp"
#include "grammar/slips.hpp"

namespace mansard {

namespace {

// ---- what was wanted

std::vector<std::string_view> wanted(const Trail::Place& place) {
  std::vector<std::string_view> all;
  for (const Wording* wording : place.wants) {
    if (wording->want && std::find(all.begin(), all.end(), wording->want) == all.end()) {
      all.emplace_back(wording->want);
    }
  }
  const auto closes = [](std::string_view want) {
    return want == "'}'" || want == "')'" || want == "']'";
  };
  std::stable_partition(all.begin(), all.end(), [&](auto want) { return !closes(want); });
  return all;
}

std::string listed(const std::vector<std::string_view>& wants) {
  std::string list;
  for (std::size_t i = 0; i < wants.size(); ++i) {
    if (i > 0) list += i + 1 == wants.size() ? " or " : ", ";
    list += wants[i];
  }
  return list;
}

char closer(char open) { return open == '{' ? '}' : open == '[' ? ']' : ')'; }

/// One failing: everything the messages are made from.
class Failing {
 public:
  Failing(const Source& source, const Trail::Place& place, const ErrorSite& around)
      : source_(source),
        place_(place),
        around_(around),
        text_(source.text()),
        at_(place.at && place.at >= around.member ? place.at : around.member),
        found_(found_at(text_, offset(at_))),
        wants_(wanted(place)) {}

  Diagnostic particular() const {
    const Complaint& told = place_.complaint;
    return make(told.begin, told.end, told.text, told.help);
  }

  Diagnostic block_in_block(const Trail& trail) const {
    const std::string_view word = member_word();
    Diagnostic made = make(word, "block " + in_quotes(word) + " begins inside of another block",
                           "is a '}' missing before it?");
    point_behind(made);
    note_open(made, trail.innermost());
    return made;
  }

  Diagnostic style_in_style(const Trail& trail) const {
    const std::string_view word = found_at(text_, offset(around_.member));
    Diagnostic made = make(word, in_quotes(word) + " begins inside of another style",
                           "is a '}' missing before it?");
    point_behind(made);
    note_open(made, trail.innermost());
    return made;
  }

  // The `Materialls { WALL : color("red") }` of somebody in a hurry.
  std::optional<Diagnostic> misspelt_block() const {
    constexpr std::array<std::string_view, 2> kinds{"Elements", "Materials"};
    const auto meant = nearest(around_.block.text, kinds);
    if (around_.level != Level::rules || !meant) return std::nullopt;
    Diagnostic made = make(around_.block.text,
                           "block " + in_quotes(around_.block.text) + " is read as one of rules",
                           "did you mean " + in_quotes(*meant) + "?");
    return made;
  }

  Diagnostic homeless_block() const {
    const std::string_view word = member_word();
    Diagnostic made =
        make(word, "block " + in_quotes(word) + " stands outside of any style",
             "blocks stand in styles: style Name { " + std::string(word) + " { … } }");
    note_end(made, "style");
    return made;
  }

  Diagnostic homeless_rule() const {
    const std::string_view word = member_word();
    Diagnostic made = make(word, "rule " + in_quotes(word) + " stands outside of any block",
                           "rules stand in the blocks of a style: style Name { Block { " +
                               std::string(word) + " -> … } }");
    note_end(made, around_.level == Level::style ? "block" : "style");
    return made;
  }

  // `vra X = 1`: the grammar takes `vra` for a symbol and stumbles at X.
  std::optional<Diagnostic> misspelt() const {
    const std::string_view word = member_word();
    const bool goes_on = !found_.empty() && Reading::is_word(found_[0]) && follows_member_word();
    if (at_ == around_.member || at_ == word.data() || goes_on) {
      if (const auto meant = nearest_keyword(word)) {
        return make(word, "there is no " + in_quotes(word) + " here",
                    "did you mean " + in_quotes(*meant) + "?");
      }
    }
    return std::nullopt;
  }

  // `{ { A } | B }`: a part that begins with a brace is a group.
  std::optional<Diagnostic> group_without_star() const {
    if (!wants("'*'") || wants_.size() > 1) return std::nullopt;
    const Brackets brackets(text_, offset(around_.member), offset(at_));
    if (brackets.last_group == std::string::npos) return std::nullopt;
    const std::string where = found_.empty() ? "the end of the file" : in_quotes(found_);
    Diagnostic made = make(text_.substr(brackets.last_group, 1),
                           "expected '*' behind the group that begins here, not " + where,
                           "a '{' that begins a part groups parts that repeat: { … }*; is it one "
                           "too many?");
    made.also.push_back(make(found_, {}, {}).at);
    return made;
  }

  Diagnostic unexpected(std::size_t braces_around, uint32_t brief_variable_end) const {
    const bool ends = found_.empty();
    const std::string where = ends ? " before the end of the file" : ", not " + in_quotes(found_);
    std::string text = "expected " + listed(wants_) + where;
    if (wants_.empty())
      text = ends ? "the file ends too early" : in_quotes(found_) + " can not stand here";
    std::string help = explain_slip(stuck(brief_variable_end));
    for (const Wording* wording : place_.wants) {
      if (!wording->say) continue;
      text = wording->say;
      if (wording->help) help = wording->help;
    }
    Diagnostic made = make(found_, text, help);
    if (ends) made.at = end_of_text();
    if (!ends && wants_.size() == 1 && wants("'{'")) point_behind_word(made);
    if (bracket_matters(braces_around)) note_open(made, place_.open);
    if (made.help.empty()) made.help = meant_word();
    return made;
  }

 private:
  uint32_t offset(const char* at) const { return static_cast<uint32_t>(at - text_.data()); }
  bool blank(const char* from, const char* to) const {
    return std::all_of(from, to, [](char c) { return std::strchr(" \t\r\n", c) && c; });
  }
  // Behind its annotations and modifiers.
  std::string_view member_word() const {
    const std::size_t begin = offset(around_.word ? around_.word : around_.member);
    std::string_view word = found_at(text_, begin);
    while (word == "replace" || word == "final" || word == "override") {
      word = found_at(text_, text_.find_first_not_of(" \t\r\n", offset(word.end())));
    }
    return word;
  }

  Diagnostic make(const char* begin, const char* end, std::string text, std::string help) const {
    return {Severity::error, {}, {&source_, offset(begin), offset(end)}, std::move(text), {}, {},
            std::move(help)};
  }
  Diagnostic make(std::string_view at, std::string text, std::string help) const {
    return make(at.data(), at.data() + at.size(), std::move(text), std::move(help));
  }
  Span end_of_text() const {
    const std::size_t last = text_.find_last_not_of(" \t\r\n");
    const auto end = static_cast<uint32_t>(last == text_.npos ? 0 : last + 1);
    return {&source_, end, end};
  }
  /// What is missing is missed behind what stands before the word, which gets a caret, too.
  void point_behind(Diagnostic& made) const {
    if (!around_.behind) return;
    made.also.push_back(made.at);
    made.at = {&source_, offset(around_.behind), offset(around_.behind)};
  }
  /// A '{' that is missing on a line above, with nothing but documentation between.
  void point_behind_word(Diagnostic& made) const {
    const std::string_view word = member_word();
    const char* at = word.data() + word.size();
    if (word.empty() || at > at_ || std::find(at, at_, '\n') == at_) return;
    while (at < at_ && (std::strchr(" \t\r\n", *at) || at[0] == '/'))
      at = *at == '/' ? std::find(at, at_, '\n') : at + 1;
    if (at != at_) return;
    made.also.push_back(made.at);
    const uint32_t end = offset(word.data() + word.size());
    made.at = {&source_, end, end};
  }
  void note_end(Diagnostic& made, const char* of) const {
    if (!around_.behind || around_.behind == text_.data() || around_.behind[-1] != '}') return;
    const uint32_t end = offset(around_.behind);
    made.notes.push_back(
        {std::string("the ") + of +
             " ends with this '}': is one '}' too many, or a '{' missing before it?",
         {&source_, end - 1, end}});
  }
  void note_open(Diagnostic& made, const char* open) const {
    if (!open) return;
    const uint32_t at = offset(open);
    const auto lonely =
        *open == '{' ? static_cast<uint32_t>(lonely_brace(text_, at, offset(at_))) : at;
    if (lonely != at) {
      made.notes.push_back(
          {"as the lines are indented, this '{' has no '}'", {&source_, lonely, lonely + 1}});
      return;
    }
    made.notes.push_back(
        {std::string("this '") + *open + "' is still open", {&source_, at, at + 1}});
  }

  // On the same line everybody sees it.
  bool bracket_matters(std::size_t braces_around) const {
    if (!place_.open) return false;
    if (around_.found_is_head && place_.braces > braces_around) return true;
    const std::string close = in_quotes(std::string(1, closer(*place_.open)));
    if (std::find(wants_.begin(), wants_.end(), close) == wants_.end()) return false;
    if (found_.empty() || around_.found_is_head) return true;
    const bool other_closes = found_ == "}" || found_ == "]" || found_ == ")";
    return *place_.open != '{' && (other_closes || std::find(place_.open, at_, '\n') != at_);
  }

  bool wants(std::string_view want) const {
    return want.empty() || std::find(wants_.begin(), wants_.end(), want) != wants_.end();
  }

  Stuck stuck(uint32_t brief_variable_end) const {
    return {text_,
            offset(at_),
            found_,
            wants_,
            offset(around_.member),
            member_word(),
            place_.open ? *place_.open : '{',
            around_.level,
            brief_variable_end};
  }

  bool follows_member_word() const {
    const std::string_view word = member_word();
    return !word.empty() && at_ > word.data() && blank(word.data() + word.size(), at_);
  }

  // A keyword that was wanted and is like the word.
  std::optional<std::string> nearest_keyword(std::string_view word) const {
    if (!is_name(word)) return std::nullopt;
    constexpr std::array<std::string_view, 6> more{"start", "remove",   "replace",
                                                   "per",   "Elements", "Materials"};
    std::vector<std::string_view> near(keywords().begin(), keywords().end());
    near.insert(near.end(), more.begin(), more.end());
    const std::string all = listed(wants_) + member_keywords();
    std::erase_if(
        near, [&](std::string_view keyword) { return all.find(in_quotes(keyword)) == all.npos; });
    const auto found = nearest(word, near);
    if (!found || *found == word) return std::nullopt;
    return std::string(*found);
  }

  const char* member_keywords() const {
    switch (around_.level) {
      case Level::file:
        return "'style' 'class' 'import'";
      case Level::style:
        return "'var' 'def' 'abstract' 'start' 'replace' 'final' 'override'";
      case Level::rules:
        return "'var' 'def' 'abstract' 'final' 'override'";
      default:
        return "'remove' 'per'";
    }
  }

  std::string meant_word() const {
    const auto meant = nearest_keyword(found_);
    return meant ? "did you mean " + in_quotes(*meant) + "?" : std::string();
  }

  const Source& source_;
  const Trail::Place& place_;
  const ErrorSite& around_;
  std::string_view text_;
  const char* at_;
  std::string_view found_;
  std::vector<std::string_view> wants_;
};

}  // namespace

Diagnostic explain(const Source& source, const Trail::Place& place, const ErrorSite& around,
                   const Trail& trail, uint32_t brief_variable_end) {
  const Failing failing(source, place, around);
  if (place.complaint.begin) return failing.particular();
  const bool in_block = around.level != Level::file && around.level != Level::style;
  if (around.member_is_style && around.level != Level::file) return failing.style_in_style(trail);
  if (around.member_is_block && in_block) return failing.block_in_block(trail);
  if (around.member_is_block && around.level == Level::file) return failing.homeless_block();
  if (auto misspelt = failing.misspelt_block()) return *misspelt;
  if (around.member_is_rule && !in_block) return failing.homeless_rule();
  if (auto misspelt = failing.misspelt()) return *misspelt;
  if (auto group = failing.group_without_star()) return *group;
  return failing.unexpected(trail.braces(), brief_variable_end);
}

Diagnostic explain_missing_brace(const Source& source, const char* at, const char* open) {
  Trail::Place place;
  static constexpr Wording wording{"'}'"};
  place.at = at;
  place.open = open;
  place.wants = {&wording};
  ErrorSite around;
  around.member = at;
  return Failing(source, place, around).unexpected(0, 0);
}

Complaint explain_escape(const char* begin, const char* end, const char* after_text) {
  return {begin, end, in_quotes({begin, end}) + " is no escape of a string",
          "the escapes are \\\" \\\\ and \\u with four hexadecimal digits; write '/' in paths",
          after_text};
}

}  // namespace mansard
