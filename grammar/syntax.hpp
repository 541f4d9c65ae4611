// The syntax tree of a .style file, as values. Names and spans point into the Source.
// The printed grammar is docs/language.md's; every struct here is one of its phrases.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grammar/source.hpp"

namespace mansard::syntax {

struct Name {
  std::string_view text;  ///< empty when absent
  Span at;
  explicit operator bool() const { return !text.empty(); }
};

// ---- expressions

struct Expr;
using ExprPtr = std::unique_ptr<Expr>;
struct Arg;

struct Number {
  double value = 0;
};
struct Text {
  std::string value;  ///< escapes resolved
};
struct Boolean {
  bool value = false;
};
struct List {
  std::vector<ExprPtr> items;
};
/// `W`, `Tile.WindowWidth`, `split.index`, `FLOOR`, `Shop::WALL`.
struct Reference {
  Name style;               ///< before `::`
  std::vector<Name> names;  ///< separated by dots; at least one
};
/// `rand(1, 2)`, `Shape.occ("all")`, and a symbol with arguments as a value.
struct Call {
  Reference callee;
  std::vector<Arg> args;
};
struct Subscript {
  ExprPtr list, index;
};
enum class Prefix : uint8_t { minus, invert };
struct Unary {
  std::vector<Prefix> operators;  ///< outermost first
  ExprPtr operand;
};
enum class Infix : uint8_t {
  add,
  subtract,
  multiply,
  divide,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  unequal,
  and_,
  or_
};
/// A flat left-associative chain of operators of one precedence; comparisons never have more than
/// one.
struct Chain {
  std::vector<ExprPtr> operands;  ///< one more than operators
  std::vector<Infix> operators;
  std::vector<Span> operator_spans;
};
struct Conditional {
  ExprPtr condition, then, otherwise;
};

struct Expr {
  Span at;  ///< without surrounding space
  std::variant<Number, Text, Boolean, List, Reference, Call, Subscript, Unary, Chain, Conditional>
      is;
};

/// 2.5, 30%, 1r, ~1.2, `:`.
enum class SizeKind : uint8_t { absolute, percent, relative, floating, dont_care };
struct Size {
  SizeKind kind = SizeKind::absolute;
  ExprPtr value;  ///< null for dont_care
  Span at;
};

struct Arg {
  Name name;  ///< `overhang = 0.3`; empty for a positional one
  Size value;
  Span at;
};

// ---- successors

struct Element;
using Body = std::vector<Element>;
struct Part;

struct Parts {
  std::vector<Part> parts;
  bool starred = false;  ///< split(axis) { … }*
  Span at;               ///< with the braces
};

/// An operation or a symbol; which of them, the linker knows.
/// `extrude(2) { A }`, `FLOOR[1]`, `Other::FACADE`, `style(e)::FACADE`.
struct Emit {
  Name style;        ///< Other::
  ExprPtr style_of;  ///< style(expr)::
  Name name;
  std::optional<std::vector<Arg>> args;
  Span args_at;   ///< with the parentheses
  ExprPtr index;  ///< [expr]
  std::optional<Parts> parts;
};
struct Push {
  Body body;
};
struct Super {};
struct IfArm {
  ExprPtr condition;  ///< null for the final else
  Body body;
};
struct If {
  std::vector<IfArm> arms;
};

struct Element {
  Span at;
  std::variant<Emit, Push, Super, If> is;
};

struct Part {
  std::optional<Size>
      label;  ///< `side :`, `0 :`, `1r :`; a word is an absolute Size with a one-name Reference
  Body body;  ///< of a plain part
  std::vector<Part> group;  ///< of a repeated group `{ … | … }*`; then body is empty
  Span at;
};

// ---- members

struct Annotation {
  Name name;
  std::vector<Arg> args;
  Span at;
};
/// What may stand before a member.
struct Preamble {
  std::vector<Span> docs;  ///< the text after each `///`
  std::vector<Annotation> annotations;
  Span final, override, abstract;  ///< of the word, nowhere when absent
};

struct Rule {
  Preamble pre;
  Name name;
  std::vector<Name> params;
  bool has_params = false;
  ExprPtr index;            ///< in the head: a number tests, a one-name Reference binds
  bool guard_else = false;  ///< `: else` or `: else condition`
  ExprPtr guard;
  Body successor;
  ExprPtr probability;
  Span at, head;  ///< whole rule; name up to the arrow
};
struct Variable {
  Preamble pre;
  Name name;
  ExprPtr value;  ///< null for `abstract var`
  Span at;
};
struct Function {
  Preamble pre;
  Name name;
  std::vector<Name> params;
  ExprPtr value;
  Span at;
};
struct AbstractSymbol {
  Preamble pre;
  Name name;
  std::vector<Name> params;
  Span at;
};
using BlockItem = std::variant<Rule, Variable, Function, AbstractSymbol>;

enum class EntryKind : uint8_t { set, add, take, remove };  // ':', '+', '-', 'remove'
struct ElementAlternative {
  std::vector<ExprPtr> meshes;  ///< Text, one a level of detail, nearest first
  ExprPtr weight;               ///< null: 1
  Span at;
};
struct ElementEntry {
  Preamble pre;
  Name symbol;
  EntryKind kind = EntryKind::set;
  std::vector<ElementAlternative> alternatives;
  Span at;
};
struct MaterialAlternative {
  std::vector<Emit> looks;  ///< color("#fff") texture("a.png", 1, 1): operations without parts
  std::vector<Span> look_spans;
  ExprPtr weight;
  Span at;
};
struct MaterialEntry {
  Preamble pre;
  Name symbol;
  EntryKind kind = EntryKind::set;
  std::vector<MaterialAlternative> alternatives;
  ExprPtr per;  ///< Text; null: "shape"
  Span at;
};

enum class BlockKind : uint8_t { rules, elements, materials };
struct Block {
  Preamble pre;
  Span replace;  ///< of the word, nowhere when absent
  BlockKind kind = BlockKind::rules;
  Name name;
  std::vector<BlockItem> items;
  std::vector<ElementEntry> elements;
  std::vector<MaterialEntry> materials;
  Span at;
};
struct Start {
  Name symbol;
  Span at;
};
using StyleMember = std::variant<Variable, Function, AbstractSymbol, Start, Block>;

struct Style {
  Preamble pre;
  Name name;
  std::vector<Name> parents;
  std::vector<StyleMember> members;
  Span at;
};
struct Import {
  ExprPtr path;  ///< Text
  Span at;
};
/// Its special members are compiled once, in syntax.cpp: those of the whole tree are costly to
/// compile, under sanitizers above all.
struct File {
  File();
  ~File();
  File(File&&) noexcept;
  File& operator=(File&&) noexcept;

  const Source* source = nullptr;
  std::vector<Import> imports;
  std::vector<Style> styles;
};

}  // namespace mansard::syntax
