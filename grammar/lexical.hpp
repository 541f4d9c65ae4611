// The tokens of a .style file. Space is skipped before a token, never after it, so spans are exact.
// Included through rules.hpp only.
#pragma once

#include <algorithm>
#include <array>
#include <tao/pegtl.hpp>
#include <utility>

#include "grammar/reading.hpp"

namespace mansard::peg {

using namespace tao::pegtl;  // NOLINT: a grammar's words

/// A string as a template argument: T<"->">.
template <std::size_t size>
struct Fixed {
  char text[size]{};
  consteval Fixed(const char (&literal)[size]) {  // NOLINT: converts by design
    for (std::size_t i = 0; i < size; ++i) text[i] = literal[i];
  }
};
template <Fixed text, class Indices>
struct literal_of;
template <Fixed text, std::size_t... i>
struct literal_of<text, std::index_sequence<i...>> {
  using type = string<text.text[i]...>;
};
template <Fixed text>
using literal = typename literal_of<text, std::make_index_sequence<sizeof(text.text) - 1>>::type;

/// A rule written by hand: `static bool match(In&, Reading&)`.
template <class Rule>
struct by_hand {
  using rule_t = Rule;
  using subs_t = type_list<>;
  template <apply_mode, rewind_mode, template <class...> class, template <class...> class, class In>
  static bool match(In& in, Reading& reading) {
    return Rule::read(in, reading);
  }
};

struct ws : by_hand<ws> {
  template <class In>
  static bool read(In& in, Reading& reading) {
    in.bump(static_cast<std::size_t>(reading.after_space(in.current()) - in.current()));
    return true;
  }
};

/// The end of the text, or of our patience with it.
struct end : by_hand<end> {
  template <class In>
  static bool read(In& in, Reading& reading) {
    return reading.over() || reading.after_space(in.current()) == in.end();
  }
};

// Optional phrases are not "expected", unless one was begun.
template <class... Rules>
struct hush : seq<Rules...> {};
template <class... Rules>
struct maybe : opt<hush<Rules...>> {};
template <class... Rules>
struct many : star<hush<Rules...>> {};

// clang-format off
template <Fixed text> struct T : seq<ws, literal<text>> {};
template <Fixed text> struct K : seq<ws, literal<text>, not_at<identifier_other>> {};
template <char bracket> struct tight : one<bracket> {};
struct arrow : T<"->"> {};
struct comma : T<","> {};
struct bar   : T<"|"> {};
struct colon : seq<ws, one<':'>, not_at<one<':'>>> {};
struct assign : seq<ws, one<'='>, not_at<one<'='>>> {};
struct dot   : seq<ws, one<'.'>, not_at<digit>> {};
struct minus : seq<one<'-'>, not_at<one<'>'>>> {};
struct unit  : sor<seq<one<'r'>, not_at<identifier_other>>, one<'%'>> {};
struct digits : seq<sor<seq<plus<digit>, opt<one<'.'>, star<digit>>>, seq<one<'.'>, plus<digit>>>, opt<one<'e', 'E'>, opt<one<'+', '-'>>, plus<digit>>> {};
struct number_end : sor<at<unit>, not_at<identifier_other>> {};
struct number : seq<ws, digits, number_end> {};
struct word  : seq<ws, identifier> {};
struct elements_name : K<"Elements"> {};
struct materials_name : K<"Materials"> {};
struct final_ : K<"final"> {};
struct no_bracket : not_at<one<'['>> {};
struct expr_end : seq<end> {};
// clang-format on

struct name : by_hand<name> {
  template <class In>
  static bool read(In& in, Reading& reading) {
    const std::size_t length = Reading::name_length(reading.after_space(in.current()), in.end());
    if (length == 0) return false;
    ws::read(in, reading);
    in.bump(length);
    return true;
  }
};

struct text : by_hand<text> {
  template <class In>
  static bool read(In& in, Reading& reading) {
    const char* const after = reading.after_text(reading.after_space(in.current()));
    if (!after) return false;
    in.bump(static_cast<std::size_t>(after - in.current()));
    return true;
  }
};

/// `///`, first on its line. Everywhere else such a line is a comment like any other.
struct doc : by_hand<doc> {
  template <class In>
  static bool read(In& in, Reading& reading) {
    const char* const after = reading.after_doc(in.current());
    if (!after) return false;
    in.bump(static_cast<std::size_t>(after - in.current()));
    return true;
  }
};

/// The members are over though no '}' came: the end of the text, or an error whose recovery goes on
/// outside of these braces.
struct leave : by_hand<leave> {
  template <class In>
  static bool read(In& in, Reading& reading);
};
struct missing_brace : by_hand<missing_brace> {
  template <class In>
  static bool read(In& in, Reading& reading);
};

/// Reports what went wrong in a member and skips to the next.
template <Level level>
struct bad {
  using rule_t = bad;
  using subs_t = type_list<>;
  template <apply_mode, rewind_mode, template <class...> class, template <class...> class Control,
            class In>
  static bool match(In& in, Reading& reading);
};
using bad_style = bad<Level::file>;
using bad_member = bad<Level::style>;
using bad_item = bad<Level::rules>;
using bad_element = bad<Level::elements>;
using bad_material = bad<Level::materials>;

}  // namespace mansard::peg
