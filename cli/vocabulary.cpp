#include "cli/vocabulary.hpp"

#include <algorithm>
#include <array>

namespace mansard {
namespace {

// clang-format off
constexpr std::array words{
    WordRow{"style", "Begins a style: style Name : Parents { members }. In a successor, style(expr)::SYMBOL goes on under the style of that name."},
    WordRow{"class", "The same word as style."},
    WordRow{"import", "Reads another script: import \"parts.style\", looked for beside this file, in the style path and in the library."},
    WordRow{"var", "Declares a variable of a block or style: var Name = value. Heirs override it by name; expressions that read it are late bound."},
    WordRow{"def", "Declares a function: def name(a, b) = value."},
    WordRow{"abstract", "Asks for a symbol's rules or a variable's value that a derived style must give."},
    WordRow{"final", "No derived style may override this, or inherit from this style."},
    WordRow{"override", "Says that a parent has this member; an error when none has."},
    WordRow{"if", "Chooses: if condition { successor } else { successor }, and in values if c then a else b."},
    WordRow{"then", "Before the value that is taken when the condition of an if holds."},
    WordRow{"else", "Of a rule, : else is tried where no rule before it was a candidate; of an if, what is taken otherwise."},
    WordRow{"super", "Goes on with the rules of this symbol that this rule overrides: the next style's in the resolution order."},
    WordRow{"true", "The truth value that holds."},
    WordRow{"false", "The truth value that does not hold."},
    WordRow{"start", "Names the symbol with which derivation begins; without it FOOTPRINT."},
    WordRow{"replace", "Before a block: drops all that was inherited in the block of this name."},
    WordRow{"remove", "Drops the inherited entry of a symbol in Elements or Materials."},
    WordRow{"per", "In Materials: how often a look is drawn, per \"shape\", \"building\" or the nearest shape above of a symbol."},
    WordRow{"fits", "In a rule's condition: true when no fixed size of the successor's first split would be cut."},
    WordRow{"Elements", "The block of meshes that replace terminals: SYMBOL : \"near.obj\" \"far.obj\" : weight."},
    WordRow{"Materials", "The block of looks of terminals: SYMBOL : color(\"tan\") : weight."},
    WordRow{"attr", "attr(\"name\", default) reads a property of the footprint and gives what its default is."},
    WordRow{"NIL", "The symbol that deletes the shape."},
    WordRow{"FOOTPRINT", "The symbol with which derivation begins, unless the style says start NAME."},
};
// clang-format on

const WordRow* find(std::span<const WordRow> rows, std::string_view name) {
  const auto it = std::ranges::find(rows, name, &WordRow::name);
  return it == rows.end() ? nullptr : &*it;
}

}  // namespace

std::span<const WordRow> word_rows() { return words; }
const WordRow* find_word(std::string_view name) { return find(words, name); }

std::string usage(const Operation& o) {
  std::string text = std::string(o.name) + "(" + std::string(o.args) + ")";
  switch (o.rule) {
    case PartRule::without:
      break;
    case PartRule::body:
      return text + " { PART }";
    case PartRule::named:
      return text + " { " + std::string(o.parts) + " }";
    case PartRule::sizes:
      return text + " { PART | ... }";
    case PartRule::pattern:
      return text + " { size : PART | { size : PART | ... }* }";
    case PartRule::selectors:
      return text + " { selector : PART | ... }";
  }
  return text;
}

}  // namespace mansard
