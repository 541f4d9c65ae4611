#include "cli/vocabulary.hpp"

#include <algorithm>
#include <array>

namespace mansard {
namespace {

// clang-format off
constexpr std::array words{
    WordRow{"style", "Begins a style: style Name : Parents { members }. In a successor, style(expr)::SYMBOL goes on under the style of that name.", "language"},
    WordRow{"class", "The same word as style.", "language"},
    WordRow{"import", "Reads another script: import \"parts.style\", looked for beside this file, in the style path and in the library.", "files"},
    WordRow{"var", "Declares a variable of a block or style: var Name = value. Heirs override it by name; expressions that read it are late bound.", "variables"},
    WordRow{"def", "Declares a function: def name(a, b) = value.", "variables"},
    WordRow{"abstract", "Asks for a symbol's rules or a variable's value that a derived style must give.", "inheritance"},
    WordRow{"final", "No derived style may override this, or inherit from this style.", "inheritance"},
    WordRow{"override", "Says that a parent has this member; an error when none has.", "inheritance"},
    WordRow{"if", "Chooses: if condition { successor } else { successor }, and in values if c then a else b.", "successors"},
    WordRow{"then", "Before the value that is taken when the condition of an if holds.", "successors"},
    WordRow{"else", "Of a rule, : else is tried where no rule before it was a candidate; of an if, what is taken otherwise.", "rules"},
    WordRow{"super", "Goes on with the rules of this symbol that this rule overrides: the next style's in the resolution order.", "inheritance"},
    WordRow{"true", "The truth value that holds.", "rules"},
    WordRow{"false", "The truth value that does not hold.", "rules"},
    WordRow{"start", "Names the symbol with which derivation begins; without it FOOTPRINT.", "rules"},
    WordRow{"replace", "Before a block: drops all that was inherited in the block of this name.", "inheritance"},
    WordRow{"remove", "Drops the inherited entry of a symbol in Elements or Materials.", "elements"},
    WordRow{"per", "In Materials: how often a look is drawn, per \"shape\", \"building\" or the nearest shape above of a symbol.", "elements"},
    WordRow{"fits", "In a rule's condition: true when no fixed size of the successor's first split would be cut.", "rules"},
    WordRow{"Elements", "The block of meshes that replace terminals: SYMBOL : \"near.obj\" \"far.obj\" : weight.", "elements"},
    WordRow{"Materials", "The block of looks of terminals: SYMBOL : color(\"tan\") : weight.", "elements"},
    WordRow{"attr", "attr(\"name\", default) reads a property of the footprint and gives what its default is.", "variables"},
    WordRow{"NIL", "The symbol that deletes the shape.", "rules"},
    WordRow{"FOOTPRINT", "The symbol with which derivation begins, unless the style says start NAME.", "rules"},
};
// clang-format on

// clang-format off
constexpr std::array signs{
    WordRow{"->", "Between the head of a rule and its successor: NAME -> what becomes of it.", "rules"},
    WordRow{":", "Before a condition (NAME : W > 3 -> …), a probability (… : 0.4), behind a part's name (side : WALL), behind a new style's name before its parents.", "rules"},
    WordRow{"|", "Between parts: { WALL | WINDOW | WALL }; in Elements and Materials between alternatives.", "successors"},
    WordRow{"{", "Braces hold what a style, a block or an operation's parts contain.", "successors"},
    WordRow{"}", "Braces hold what a style, a block or an operation's parts contain.", "successors"},
    WordRow{"[", "After a space, [ … ] saves the shape and restores it; against a symbol, NAME[expr] gives or tests an index.", "successors"},
    WordRow{"]", "After a space, [ … ] saves the shape and restores it; against a symbol, NAME[expr] gives or tests an index.", "successors"},
    WordRow{"*", "Multiplies; behind the group of a split, { … }*, repeats it as often as there is room.", "sizes"},
    WordRow{"::", "Style::SYMBOL hands a shape to another style, style(expr)::SYMBOL to one chosen by its name.", "rules"},
    WordRow{"~", "~1.2 is a size of a split that wants 1.2 metres and stretches to fill.", "sizes"},
    WordRow{"r", "1r is a size of a split: a share of what the fixed sizes leave, so 1r and 2r stand one to two.", "sizes"},
    WordRow{"%", "30% is a share of the scope, in splits and in t, s and pivot; a remainder is mod(a, b).", "sizes"},
    WordRow{"+", "Adds numbers, joins strings; in Elements and Materials adds alternatives: WALL + color(\"tan\").", "elements"},
    WordRow{"-", "Subtracts; in Elements and Materials takes an alternative away.", "elements"},
    WordRow{"==", "Compares two values: also !=, <, <=, >, >=; conditions are joined with && (and), || (or), ! (not).", "rules"},
    WordRow{"&&", "And: both conditions hold.", "rules"},
    WordRow{"||", "Or: one of the conditions holds.", "rules"},
    WordRow{"!", "Not: the condition does not hold.", "rules"},
    WordRow{"=", "Behind a variable's name (var Width = 1.1) and an argument's (overhang = 0.4); two values are compared with ==.", "variables"},
    WordRow{"@", "Begins an annotation, which tells tools about what follows: @range(0.6, 1.4) var Width = 1.", "annotations"},
    WordRow{"//", "Begins a comment, to the end of the line; /* … */ may span lines. /// documents what follows.", "language"},
    WordRow{"///", "Documents the style, block, variable or rule that follows, for help, explain and editors.", "language"},
    WordRow{".", "Block.Name is the variable of another block, split.index an attribute of the shape; 0.5 a number.", "variables"},
};
// clang-format on

const WordRow* find(std::span<const WordRow> rows, std::string_view name) {
  const auto it = std::ranges::find(rows, name, &WordRow::name);
  return it == rows.end() ? nullptr : &*it;
}

}  // namespace

std::span<const WordRow> word_rows() { return words; }
const WordRow* find_word(std::string_view name) { return find(words, name); }
const WordRow* find_sign(std::string_view sign) { return find(signs, sign); }

std::string usage(const Operation& o) {
  std::string text = std::string(o.name) + "(" + o.names_by_place();
  for (std::size_t i = 0; i < o.count; ++i) {
    if (o.parameters[i].named) text += ", " + std::string(o.parameter_name(i)) + " =";
  }
  text += ")";
  switch (o.rule) {
    case PartRule::without:
      break;
    case PartRule::body:
      return text + " { PART }";
    case PartRule::named:
      return text + " { " + std::string(o.parts) + " }";
    case PartRule::sizes:
    case PartRule::choices:
      return text + " { PART | ... }";
    case PartRule::pattern:
      return text + " { size : PART | { size : PART | ... }* }";
    case PartRule::selectors:
      return text + " { selector : PART | ... }";
  }
  return text;
}

}  // namespace mansard
