#include "grammar/slips.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "grammar/in_quotes.hpp"
#include "grammar/slips_elsewhere.hpp"

namespace mansard {

// ---- what stands at the place

namespace {

constexpr std::array<std::string_view, 18> signs{
    "-->", "->", "=>", "==", "!=", "<=", ">=", "&&", "||",
    "::",  "++", "--", "+=", "-=", "*=", "/=", ":=", "**"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t word_length(std::string_view rest) {
  std::size_t length = 0;
  const auto point = [&] {
    return is_digit(rest[0]) && rest[length] == '.' && length + 1 < rest.size() &&
           is_digit(rest[length + 1]);
  };
  while (length < rest.size() && (Reading::is_word(rest[length]) || point())) ++length;
  return length;
}

}  // namespace

std::string_view found_at(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(std::min(at, text.size()));
  if (rest.empty()) return rest;
  if (const std::size_t length = word_length(rest); length > 0) return rest.substr(0, length);
  if (rest[0] == '"') {
    const std::size_t end = rest.find_first_of("\"\n", 1);
    return rest.substr(0, end == rest.npos ? rest.size() : rest[end] == '"' ? end + 1 : end);
  }
  for (const std::string_view sign : signs) {
    if (rest.substr(0, sign.size()) == sign) return rest.substr(0, sign.size());
  }
  return rest.substr(0, 1);
}

Brackets::Brackets(std::string_view text, std::size_t begin, std::size_t end) {
  for (std::size_t at = begin; at < end; ++at) {
    const char c = text[at];
    if (c == '"') {
      at = std::min(text.find_first_of("\"\n", at + 1), end);
    } else if (text.substr(at, 2) == "//") {
      at = std::min(text.find('\n', at), end);
    } else if (c == '(' || c == '[' || c == '{') {
      open.push_back(at);
    } else if ((c == ')' || c == ']' || c == '}') && !open.empty()) {
      if (c == '}') last_group = open.back();
      open.pop_back();
    }
  }
}

bool Brackets::has(std::string_view text, char bracket) const {
  return std::any_of(open.begin(), open.end(), [&](std::size_t at) { return text[at] == bracket; });
}

bool Stuck::wanted(std::string_view want) const {
  return want.empty() || std::find(wants.begin(), wants.end(), want) != wants.end();
}

// ---- words and signs of other languages

namespace {

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

constexpr const char* condition_help =
    "a condition stands behind a ':' in the head of a rule: NAME : condition -> …";

/// `override DOOR : …` in Elements.
std::string marked_entry(const Stuck& stuck) {
  if (stuck.level != Level::elements && stuck.level != Level::materials) return {};
  if (stuck.found != "override" && stuck.found != "final") return {};
  const std::size_t next = stuck.text.find_first_not_of(" \t\r\n", stuck.at + stuck.found.size());
  if (next == stuck.text.npos || !Reading::is_word(stuck.text[next])) return {};
  return "no entry is marked " + in_quotes(stuck.found) +
         ": 'NAME :' takes the place of what is inherited, 'NAME +' adds to it";
}

std::string foreign_word(const Stuck& stuck) {
  if (std::string help = marked_entry(stuck); !help.empty()) return help;
  for (const Slip& slip : slips) {
    const std::string_view found = stuck.found.substr(0, slip.found.size());
    const bool same = slip.found == "→" ? found == slip.found : stuck.found == slip.found;
    if (same && stuck.wanted(slip.want)) return std::string(slip.help);
  }
  return {};
}

// ---- signs that are missing, or there twice, told from what stands around the place

struct Around {
  explicit Around(const Stuck& stuck) {
    const std::size_t last = stuck.text.substr(0, stuck.at).find_last_not_of(" \t\r\n");
    if (last != stuck.text.npos) before = stuck.text[last];
    touches = last + 1 == stuck.at;
    if (!stuck.found.empty()) first = stuck.found[0];
    value = (Reading::is_word(first) && stuck.found != "r") || first == '"' || first == '[';
    in_rule = stuck.level == Level::rules && !stuck.wanted("a value") && stuck.open == '{';
  }
  char before = '\0';    ///< the last before it that is no space
  char first = '\0';     ///< of what was found
  bool touches = false;  ///< no space between them
  bool value = false;    ///< a value begins here
  bool in_rule = false;  ///< among rules, and not in a value
};

std::string closing_bracket(const Stuck& stuck) {
  const char opener = stuck.found == "]" ? '[' : '(';
  if (stuck.found != ")" && stuck.found != "]") return {};
  const Brackets brackets(stuck.text, stuck.member, stuck.at);
  if (brackets.has(stuck.text, opener) || stuck.wanted("a value")) return {};
  return "this " + in_quotes(stuck.found) + " closes nothing: is a " +
         in_quotes(std::string(1, opener)) + " missing, or is it one too many?";
}

std::string in_arguments(const Stuck& stuck, const Around& around) {
  if (stuck.open != '(') return {};
  const bool one_want = stuck.wants.size() == 1;
  if (stuck.found == "," && one_want && stuck.wanted("')'"))
    return "',' stands between arguments: is one '(' too many?";
  if (stuck.level == Level::rules && stuck.wanted("a name") && stuck.wanted("')'"))
    return "names in parentheses belong to the head of a rule: is a '->' missing before it?";
  if (!stuck.wanted("','")) return {};
  if (around.before == ')') return "a ')' stands before it: is one '(' too many, or a ')' missing?";
  if (!around.value || !Reading::is_word(around.before)) return {};
  if (around.first == '"' && around.touches) return "is a '(' missing before it?";
  return "an argument with a name is written: name = value; is a '=' missing before it?";
}

bool odd_quotes(const Stuck& stuck) {
  const std::size_t begin = stuck.text.rfind('\n', stuck.at == 0 ? 0 : stuck.at - 1) + 1;
  const std::string_view line = stuck.text.substr(begin, stuck.text.find('\n', stuck.at) - begin);
  std::size_t quotes = 0;
  for (std::size_t i = 0; i < line.size() && line.substr(i, 2) != "//"; ++i) {
    if (line[i] == '\\')
      ++i;
    else
      quotes += line[i] == '"';
  }
  return quotes % 2 == 1;
}

std::string missing_sign(const Stuck& stuck) {
  if (stuck.found.empty()) return {};
  const Around around(stuck);
  if (odd_quotes(stuck)) return "the quotes of this line do not pair: is a '\"' missing?";
  if (std::string help = closing_bracket(stuck); !help.empty()) return help;
  if (std::string help = in_arguments(stuck, around); !help.empty()) return help;
  if (stuck.found == "|" && stuck.open != '(' && !stuck.wanted("'|'") &&
      !stuck.wanted("a symbol or an operation")) {
    return "'|' stands between parts: is a '{' missing before them, or one '}' too many?";
  }
  if (stuck.found == "," && stuck.open == '[' && stuck.wants.size() == 1 && stuck.wanted("']'"))
    return "an index is one value: is a '(' missing before the '['?";
  if (around.in_rule && (around.first == '"' || around.first == ',') &&
      Reading::is_word(around.before)) {
    return "arguments stand in parentheses: is a '(' missing before them?";
  }
  if (stuck.level == Level::style && around.first == '"') return "is a '(' missing before it?";
  if (is_digit(around.first) && around.before == ':' && stuck.wanted("a symbol or an operation"))
    return "a number is a probability or a weight: is a '}' missing before the ':'?";
  const bool bare = is_digit(around.first) && stuck.open == '{' && !stuck.wanted("a value");
  if (bare && (stuck.level == Level::elements || stuck.level == Level::materials))
    return "a weight stands behind a ':'";
  if (bare && stuck.level == Level::rules) return "a probability stands behind a ':'";
  const bool compares =
      around.first == '<' || around.first == '>' || stuck.found == "==" || stuck.found == "!=";
  if (around.in_rule && (compares || stuck.found == "else") && !stuck.wanted("'->'"))
    return condition_help;
  if (stuck.wanted("'->'") && stuck.found == "attr") return condition_help;
  if (stuck.level == Level::file && Reading::is_word(around.first) && stuck.wanted("'{'"))
    return "the parents of a style stand behind a ':'";
  if (stuck.found == "." && stuck.open != '(')
    return "a value stands in parentheses, or as an index in brackets: is a '[' or a '(' missing?";
  return {};
}

/// Nothing but space stands between them.
bool follows(const Stuck& stuck, std::size_t end) {
  return end <= stuck.at && stuck.text.substr(end, stuck.at - end).find_first_not_of(" \t\r\n") ==
                                std::string_view::npos;
}

std::string of_expressions(const Stuck& stuck) {
  const char first = stuck.found.empty() ? '\0' : stuck.found[0];
  if (stuck.brief_variable_end > 0 && first != '\0' && !Reading::is_word(first) &&
      std::strchr("+-*/<>=&|([.?!%:", first) && follows(stuck, stuck.brief_variable_end)) {
    return "an expression after 'var NAME' needs '='; without it only a literal, a name or a "
           "parenthesis can stand";
  }
  const char before = stuck.at > 0 ? stuck.text[stuck.at - 1] : '\0';
  if (before == '%') return "a remainder is mod(a, b); '%' is per cent";
  if (before == '-' && stuck.found == "->") return "the arrow of a rule is '->'";
  if (is_digit(first) && Around(stuck).before == '[' && stuck.wanted("a symbol or an operation"))
    return "an index stands against its symbol: NAME[1]; after a space, '[' saves the shape";
  const auto word_end =
      static_cast<std::size_t>(stuck.word.data() - stuck.text.data()) + stuck.word.size();
  if (stuck.found == "=" && !stuck.word.empty() && follows(stuck, word_end))
    return "a rule is written: NAME -> …, a variable: var NAME = value";
  return {};
}

}  // namespace

std::string explain_slip(const Stuck& stuck) {
  if (std::string help = odd_quotes(stuck) ? std::string() : explain_habit(stuck); !help.empty())
    return help;
  if (std::string help = of_expressions(stuck); !help.empty()) return help;
  if (std::string help = missing_sign(stuck); !help.empty()) return help;
  if (std::string help = foreign_word(stuck); !help.empty()) return help;
  if (stuck.found.empty()) return {};
  const Around around(stuck);
  const bool outside = stuck.level == Level::style || stuck.level == Level::file;
  if (outside && around.before == '}' && !around.value)
    return "something ends with the '}' before it: is one too many, or a '{' missing?";
  if (stuck.wanted("'->'") && Reading::is_word(around.first)) return condition_help;
  const bool ascii = static_cast<unsigned char>(around.first) < 0x80;
  return ascii ? "" : "names are of ASCII letters, digits and '_'";
}

}  // namespace mansard
