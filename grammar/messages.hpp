// What the user calls each phrase of the grammar: the one table of the parser's messages. A row is
// wanted only where nothing optional could stand instead (see hush in lexical.hpp).
#pragma once

#include "grammar/rules.hpp"

namespace mansard::peg {

template <Fixed text>
struct quoted {
  static constexpr auto words = [] {
    std::array<char, sizeof(text.text) + 2> all{'\''};
    std::size_t end = 1;
    for (; text.text[end - 1]; ++end) all[end] = text.text[end - 1];
    all[end] = '\'';
    return all;
  }();
};

// clang-format off
template <class Rule> inline constexpr Wording wording{nullptr, nullptr, nullptr, false};
template <Fixed text> inline constexpr Wording wording<T<text>>{quoted<text>::words.data()};
template <Fixed text> inline constexpr Wording wording<K<text>>{quoted<text>::words.data()};

template <> inline constexpr Wording wording<arrow>{"'->'"};
template <> inline constexpr Wording wording<comma>{"','"};
template <> inline constexpr Wording wording<bar>{"'|'"};
template <> inline constexpr Wording wording<colon>{"':'"};
template <> inline constexpr Wording wording<assign>{"'='"};
template <> inline constexpr Wording wording<name>{"a name"};
template <> inline constexpr Wording wording<word>{"a word"};
template <> inline constexpr Wording wording<text>{"a string"};
template <> inline constexpr Wording wording<digits>{"a number"};
template <> inline constexpr Wording wording<number_end>{nullptr, "a number ends before a letter", "lengths are in metres, angles in degrees, and neither bears a unit; a share of a split is written 1r"};
template <> inline constexpr Wording wording<subscript>{"a value"};
template <> inline constexpr Wording wording<expr>{"a value"};
template <> inline constexpr Wording wording<arg>{"an argument"};
template <> inline constexpr Wording wording<expr_end>{"the end of the value"};
template <> inline constexpr Wording wording<no_bracket>{nullptr, "a '[' can not stand against the parts of an operation", "put a space before it to save the shape; an index stands against its symbol"};
template <> inline constexpr Wording wording<element_kind>{"a symbol or an operation"};
template <> inline constexpr Wording wording<part>{"a symbol or an operation"};
template <> inline constexpr Wording wording<not_head>{nullptr, "the next rule begins before this one is complete", "a rule that should leave nothing has the successor NIL"};
template <> inline constexpr Wording wording<value_here>{nullptr, "the next rule begins where a value should stand", nullptr};
template <> inline constexpr Wording wording<plain_primary>{"a value"};
template <> inline constexpr Wording wording<not_block>{nullptr, "a block can not begin in a rule", "a bare name before '{' is a block; an operation has parentheses: name() { … }"};
template <> inline constexpr Wording wording<plain_item>{"a rule, 'var' or 'def'"};
template <> inline constexpr Wording wording<any_item>{"a rule, 'var', 'def', 'abstract'"};
template <> inline constexpr Wording wording<shared_item>{"'var' or 'def'"};
template <> inline constexpr Wording wording<any_member>{"a block, 'var', 'def', 'abstract', 'start'"};
template <> inline constexpr Wording wording<entry_kind>{"':'"};
template <> inline constexpr Wording wording<meshes>{"the file of a mesh in quotes"};
template <> inline constexpr Wording wording<looks>{"a look like color(\"#a08070\")"};
template <> inline constexpr Wording wording<element_item>{"an entry NAME : \"mesh.obj\""};
template <> inline constexpr Wording wording<material_item>{"an entry NAME : color(\"#a08070\")"};
template <> inline constexpr Wording wording<style_word>{"'style'"};
template <> inline constexpr Wording wording<top>{"'style' or 'import'"};
// clang-format on

template <class Rule>
inline constexpr bool has_wording = wording<Rule>.given;

}  // namespace mansard::peg
