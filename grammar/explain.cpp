#include "grammar/explain.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "grammar/in_quotes.hpp"

namespace mansard {

namespace {

// ---- what stands at the place, as the user would cut it into words

constexpr std::array<std::string_view, 18> signs{
    "-->", "->", "=>", "==", "!=", "<=", ">=", "&&", "||",
    "::",  "++", "--", "+=", "-=", "*=", "/=", ":=", "**"};

std::string_view found_at(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(std::min(at, text.size()));
  if (rest.empty()) return rest;
  std::size_t length = 0;
  while (length < rest.size() && Reading::is_word(rest[length])) ++length;
  if (length > 0) return rest.substr(0, length);
  if (rest[0] == '"') {
    const std::size_t end = rest.find_first_of("\"\n", 1);
    return rest.substr(0, end == rest.npos ? rest.size() : rest[end] == '"' ? end + 1 : end);
  }
  for (const std::string_view sign : signs) {
    if (rest.substr(0, sign.size()) == sign) return rest.substr(0, sign.size());
  }
  return rest.substr(0, 1);
}

// ---- slips that people make

struct Slip {
  std::string_view found;
  std::string_view want;  ///< only where this was wanted; empty: anywhere
  std::string_view help;
};

constexpr std::array slips{
    Slip{";", "", "no ';' is needed: a rule ends where the next one begins"},
    Slip{"-->", "", "the arrow of a rule is '->'"},
    Slip{"=>", "", "the arrow of a rule is '->'"},
    Slip{"→", "", "the arrow of a rule is '->'"},
    Slip{"->", "'->'", ""},
    Slip{"->", "", "'->' belongs to the head of a rule: NAME -> …"},
    Slip{":=", "", "a variable is written: var NAME = value"},
    Slip{"==", "'='", "a variable is written: var NAME = value"},
    Slip{"=", "a name", "a variable is written: var NAME = value"},
    Slip{"=", "'->'", "two values are compared with '=='"},
    Slip{"=", "", "two values are compared with '=='; a variable is written: var NAME = value"},
    Slip{"<", "", "comparisons do not chain: join two with '&&'"},
    Slip{"<=", "", "comparisons do not chain: join two with '&&'"},
    Slip{">", "", "comparisons do not chain: join two with '&&'"},
    Slip{">=", "", "comparisons do not chain: join two with '&&'"},
    Slip{"==", "", "comparisons do not chain: join two with '&&'"},
    Slip{"!=", "", "comparisons do not chain: join two with '&&'"},
    Slip{"&", "", "'and' is written '&&'"},
    Slip{"and", "", "'and' is written '&&'"},
    Slip{"or", "", "'or' is written '||'"},
    Slip{"not", "", "'not' is written '!'"},
    Slip{"?", "", "a choice is written: if condition then a else b"},
    Slip{"%", "", "'%' is per cent and stands against a number or a ')'; a remainder is mod(a, b)"},
    Slip{"^", "", "a power is written pow(a, b)"},
    Slip{"**", "", "a power is written pow(a, b)"},
    Slip{"'", "", "strings stand in double quotes"},
    Slip{"#", "", "a comment begins with //; a colour is a string: \"#a08070\""},
    Slip{"elif", "", "write: else if"},
    Slip{"elsif", "", "write: else if"},
    Slip{"elseif", "", "write: else if"},
    Slip{"[", "'->'", "an index stands against its symbol: NAME[i]"},
    Slip{"[", "", "an index stands against its list or symbol: list[i]"},
    Slip{"r", "", "'r' stands against its number: 1r, (Share)r"},
    Slip{"}", "'style' or 'import'", "this '}' closes nothing"},
    Slip{"|", "a symbol or an operation", "a part may not be empty: write NIL to leave nothing"},
    Slip{"}", "a symbol or an operation", "a part may not be empty: write NIL to leave nothing"},
    Slip{"]", "a symbol or an operation", "brackets may not be empty: write NIL to leave nothing"},
    Slip{"attr", "", "a variable is written: var NAME = value"},
    Slip{"let", "", "a variable is written: var NAME = value"},
    Slip{"case", "", "a condition stands in the head of a rule: NAME : condition -> …"},
};

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
  Failing(const Source& source, const Trail::Place& place, const Surroundings& around)
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
    note_open(made, trail.innermost());
    return made;
  }

  Diagnostic homeless_rule() const {
    const std::string_view word = member_word();
    return make(word, "rule " + in_quotes(word) + " stands outside of any block",
                "rules stand in the blocks of a style: style Name { Block { " + std::string(word) +
                    " -> … } }");
  }

  // `vra X = 1`: the grammar takes `vra` for a symbol and stumbles at X.
  std::optional<Diagnostic> misspelt() const {
    const std::string_view word = member_word();
    if (at_ == around_.member || follows_member_word()) {
      if (const auto meant = nearest_keyword(word)) {
        return make(word, "there is no " + in_quotes(word) + " here",
                    "did you mean " + in_quotes(*meant) + "?");
      }
    }
    return std::nullopt;
  }

  Diagnostic unexpected(std::size_t braces_around, uint32_t brief_variable_end) const {
    const bool ends = found_.empty();
    const std::string where = ends ? " before the end of the file" : ", not " + in_quotes(found_);
    std::string text = "expected " + listed(wants_) + where;
    if (wants_.empty())
      text = ends ? "the file ends too early" : in_quotes(found_) + " can not stand here";
    std::string help = slip(brief_variable_end);
    for (const Wording* wording : place_.wants) {
      if (!wording->say) continue;
      text = wording->say;
      if (wording->help) help = wording->help;
    }
    Diagnostic made = make(found_, text, help);
    if (ends) made.at = end_of_text();
    if (bracket_matters(braces_around)) note_open(made, place_.open);
    if (made.help.empty()) made.help = meant_word();
    return made;
  }

 private:
  uint32_t offset(const char* at) const { return static_cast<uint32_t>(at - text_.data()); }
  bool blank(const char* from, const char* to) const {
    return std::all_of(from, to, [](char c) { return std::strchr(" \t\r\n", c) && c; });
  }
  std::string_view member_word() const {
    const std::string_view word = found_at(text_, offset(around_.member));
    return word == "replace"
               ? found_at(text_, text_.find_first_not_of(" \t\r\n", offset(word.end())))
               : word;
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
  void note_open(Diagnostic& made, const char* open) const {
    if (!open) return;
    const uint32_t at = offset(open);
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

  /// Only space stands between the sign and the place.
  bool before(std::string_view sign) const {
    const std::size_t last = text_.substr(0, offset(at_)).find_last_not_of(" \t\r\n");
    return last != text_.npos && last + 1 >= sign.size() && !found_.empty() && found_[0] >= '0' &&
           found_[0] <= '9' && text_.substr(last + 1 - sign.size(), sign.size()) == sign;
  }

  bool wants(std::string_view want) const {
    return want.empty() || std::find(wants_.begin(), wants_.end(), want) != wants_.end();
  }

  std::string slip(uint32_t brief_variable_end) const {
    if (brief_variable_end > 0 && brief_variable_end <= offset(at_) && !found_.empty() &&
        !Reading::is_word(found_[0]) && std::strchr("+-*/<>=&|([.?!%:", found_[0]) &&
        blank(text_.data() + brief_variable_end, at_)) {
      return "an expression after 'var NAME' needs '='; without it only a literal, a name or a "
             "parenthesis can stand";
    }
    if (offset(at_) > 0 && at_[-1] == '%') return "a remainder is mod(a, b); '%' is per cent";
    if (offset(at_) > 0 && at_[-1] == '-' && found_ == "->") return "the arrow of a rule is '->'";
    if (wants("a symbol or an operation") && before("[")) {
      return "an index stands against its symbol: NAME[1]; after a space, '[' saves the shape";
    }
    if (found_ == "=" && follows_member_word()) {
      return "a rule is written: NAME -> …, a variable: var NAME = value";
    }
    for (const Slip& slip : slips) {
      if (slip.found == "→" ? found_.substr(0, 3) == slip.found : slip.found == found_) {
        if (wants(slip.want)) return std::string(slip.help);
      }
    }
    if (!found_.empty() && static_cast<unsigned char>(found_[0]) >= 0x80) {
      return "names are of ASCII letters, digits and '_'";
    }
    return {};
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
  const Surroundings& around_;
  std::string_view text_;
  const char* at_;
  std::string_view found_;
  std::vector<std::string_view> wants_;
};

}  // namespace

Diagnostic explain(const Source& source, const Trail::Place& place, const Surroundings& around,
                   const Trail& trail, uint32_t brief_variable_end) {
  const Failing failing(source, place, around);
  if (place.complaint.begin) return failing.particular();
  const bool in_block = around.level != Level::file && around.level != Level::style;
  if (around.member_is_block && in_block) return failing.block_in_block(trail);
  if (around.member_is_rule && !in_block) return failing.homeless_rule();
  if (auto misspelt = failing.misspelt()) return *misspelt;
  return failing.unexpected(trail.braces(), brief_variable_end);
}

Diagnostic explain_missing_brace(const Source& source, const char* at, const char* open) {
  Trail::Place place;
  static constexpr Wording wording{"'}'"};
  place.at = at;
  place.open = open;
  place.wants = {&wording};
  Surroundings around;
  around.member = at;
  return Failing(source, place, around).unexpected(0, 0);
}

Complaint explain_escape(const char* begin, const char* end, const char* after_text) {
  return {begin, end, in_quotes({begin, end}) + " is no escape of a string",
          "the escapes are \\\" \\\\ and \\u with four hexadecimal digits; write '/' in paths",
          after_text};
}

}  // namespace mansard
