// `mansard explain`: what its pages are made of. Private to cli/explain*.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interpreter/building_values.hpp"
#include "styles/standing.hpp"
#include "styles/story.hpp"

namespace mansard {

/// A style with all that is known of it.
struct Explained {
  const LinkedStyle& style;
  const Stories& stories;
  std::vector<Standing> standings;
  BuildingValues* values = nullptr;  ///< null when the style has errors
  /// "with --set Tile.Width=1.2", "for footprint 'a', seed 0"; empty when nothing was given.
  std::string circumstances;
  bool footprint = false;   ///< --footprint was given: random draws are known
  bool properties = false;  ///< --footprint or --attr was given
  bool color = false;

  std::optional<VariableValue> value(const Story& variable) const;
  /// The value is one that these circumstances settle.
  bool settled(const VariableValue& value) const;
  /// "first_house.style:7": without folders where all files of the style have different names.
  std::string place(Span at) const;
};

/// "examples/first_house.style:7".
std::string full_place(Span at);
/// The user's words on one line, without comments.
std::string one_line(Span at);
/// A rule from its parameters on: ": H > 4 -> WALL".
std::string behind_the_name(const syntax::Rule& rule, bool with_probability);
/// What the command line or a property gives.
std::string outside_text(const VariableValue& value);
/// It says its value itself: 2.5, "text", true, -1.
bool is_literal(const syntax::Expr& expr);
/// The lines on which they stand, without what is before and after them, indented as they are to
/// each other.
std::vector<std::string> source_lines(Span at);
/// "var Tile.Width", "def width", "TILE".
std::string title(const Story& story);
/// The same without the block, but with a function's parameters: "var Width", "def width(room)".
std::string short_title(const Story& story);
std::string_view name_of(MemberKind kind);
std::string_view name_of(Fate fate);
std::string_view name_of(UseKind kind);
/// Text with no characters that move a terminal's cursor.
std::string printable(std::string_view text);

/// How often an alternative is drawn among those that stand beside it.
struct Share {
  std::optional<double> part;  ///< 0 to 1; nothing when a weight depends on the shape
  bool alone = true;           ///< there is nothing to draw from
  std::string text() const;    ///< "30%", or empty
};
/// Of rules of one generation: among those with the same condition.
std::vector<Share> shares(const Explained& explained, const std::vector<const Writing*>& rules);

/// An alternative of an element or a material.
struct Alternative {
  std::string text;  ///< `"window.obj" "window_far.obj"`, `color("tan")`
  Origin from;
  Span at;
  Share share;
  Fate fate = Fate::in_force;  ///< or hidden, or dropped
  Ending ended;                ///< by whom, when it is not in force
};
/// Those in force first, then those that were, the most derived first.
std::vector<Alternative> elements_of(const LinkedStyle& style, const Story& symbol);
std::vector<Alternative> materials_of(const LinkedStyle& style, const Story& symbol);
/// `per "building"`, as the entry in force says it; empty when none does.
std::string material_draws(const LinkedStyle& style, std::string_view symbol);

/// What a member speaks of: the uses that stand in its writings in force.
struct StoryUse {
  const Story* of;
  UseKind kind;
};
std::vector<StoryUse> readings(const Stories& stories, const Story& speaker);

// ---- the pages; all end with a line end

/// `block` empty: all of the style.
std::string overview_page(const Explained& explained, std::string_view block);
std::string story_page(const Explained& explained, const Story& story);
/// What an ancestor gives to the style, and what of it is in force.
std::string ancestor_page(const Explained& explained, const syntax::Style& ancestor);
/// `stories` empty: all of the style.
std::string explained_json(const Explained& explained, const std::vector<const Story*>& stories);

}  // namespace mansard
