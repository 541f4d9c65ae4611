// The story of every member of a linked style: all its writings, what has become of each, and who
// speaks of it. For `mansard explain` and for editors.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "styles/style.hpp"

namespace mansard {

enum class MemberKind : uint8_t { variable, function, symbol };

/// What has become of a writing.
enum class Fate : uint8_t {
  in_force,
  by_super,   ///< a hidden rule that `super` reaches from the one in force
  hidden,     ///< a more derived style gives the member too
  dropped,    ///< a more derived style says `replace` of its block
  answered,   ///< `abstract`, and another writing gives what it asks for
  unanswered  ///< `abstract`, and nobody does
};

/// One place where a member is written.
struct Writing {
  using Syntax = std::variant<const syntax::Variable*, const syntax::Function*, const syntax::Rule*,
                              const syntax::AbstractSymbol*, const syntax::ElementEntry*,
                              const syntax::MaterialEntry*>;
  Syntax syntax;
  Origin from;
  uint32_t rank = 0;  ///< place of its style in the order, 0 the most derived
  Fate fate = Fate::in_force;
  Origin replaced_by;  ///< of a dropped one: the block that says `replace`; else without style

  Span at() const;    ///< all of it, without `///` and annotations
  Span name() const;  ///< the name it gives
  const syntax::Preamble& preamble() const;
};

enum class UseKind : uint8_t {
  reads,  ///< a variable's value
  sets,   ///< set() in a rule
  calls,  ///< a function
  emits,  ///< a symbol in a successor
  names   ///< a symbol as a value: `var Infill = BRICK`
};

/// A place that speaks of a member.
struct Use {
  UseKind kind;
  Span at;               ///< the words: `Width`, `Tile.Width`
  Span value{};          ///< what a set() gives; else nowhere
  uint32_t story = 0;    ///< of the member that speaks, in Stories::all()
  uint32_t writing = 0;  ///< which of its writings
};

struct Story {
  MemberKind kind = MemberKind::symbol;
  std::string_view block;  ///< empty: style-wide. Of a symbol the block of its rules in force
  std::string_view name;
  /// Most derived style first, within a style in text order. A symbol without rules has none.
  std::vector<Writing> writings;
  std::vector<Writing> elements, materials;  ///< a symbol's entries, in the same order
  std::vector<Use> uses;                     ///< also by writings that are not in force

  /// "Tile.WindowWidth", "TILE".
  std::string full_name() const;
  /// The first of them; null when nobody gives it, as of a terminal.
  const Writing* in_force() const;
  bool terminal() const { return kind == MemberKind::symbol && !in_force(); }
};

/// All stories of a style, found and linked to each other once; asking is a look-up. Takes time in
/// proportion to the text of the style and its ancestors.
class Stories {
 public:
  /// `style` must outlive the stories.
  explicit Stories(const LinkedStyle& style);

  const LinkedStyle& style() const { return *style_; }
  /// Variables, functions, symbols; of each kind in the order in which a reader meets them, base
  /// style first, and symbols without rules last.
  const std::vector<Story>& all() const { return stories_; }
  const Story& speaker(const Use& use) const { return stories_[use.story]; }
  const Writing& writing(const Use& use) const { return speaker(use).writings[use.writing]; }

  /// `block` empty: the style-wide one; of symbols it is not asked. Null when there is none.
  const Story* find(MemberKind kind, std::string_view block, std::string_view name) const;
  /// All that `Tile.WindowWidth`, `WindowWidth` or `TILE` can mean; a bare name in every block.
  std::vector<const Story*> named(std::string_view name) const;
  /// The member that the name at this byte of a source gives or speaks of, its end included; null
  /// when there is none, and in parts of the source that are not this style's or an ancestor's.
  const Story* at(const Source& source, uint32_t offset) const;

 private:
  friend class Teller;
  struct Key {
    MemberKind kind;
    std::string_view block, name;
    bool operator==(const Key&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  struct Place {
    Span at;
    uint32_t story;
  };
  static bool earlier(const Span& a, const Span& b);

  const LinkedStyle* style_;
  std::vector<Story> stories_;
  std::unordered_map<Key, uint32_t, Hash> numbers_;
  std::unordered_multimap<std::string_view, uint32_t> by_name_;
  std::vector<Place> places_;  ///< of all names, by source and place
};

/// The same writings, base style first, within a style in text order: how a person would tell it.
std::vector<const Writing*> from_the_base(const std::vector<Writing>& writings);

}  // namespace mansard
