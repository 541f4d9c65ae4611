#include "cli/topics.hpp"

#include <array>

namespace mansard {
namespace {

constexpr std::array rows{
    Topic{"language", "How a .style script is written",
          R"(A script holds styles; a style holds blocks; a block holds the rules of one part of a
building and the variables that shape it.

  style Hut {
      Mass  { FOOTPRINT -> extrude(3) { comp { side : WALL | top : ROOF } } }
      Roof  { var Pitch = 35   ROOF -> roof("gable", Pitch) { slope : TILES | gable : WALL } }
  }

A rule rewrites a symbol:  NAME(params)[index] : condition -> successor : probability
See also: mansard help rules, sizes, variables, inheritance, attributes, frames)"},
    Topic{
        "rules", "Rules and productions",
        R"(All productions of a symbol whose condition holds are candidates; one is drawn by its probability.
`: else` is tried only where no production before it was a candidate; `fits` is true when no fixed size
of the successor's first split would be cut.

  FACADE : fits -> subdiv("Y", 3, 1r) { GROUND_FLOOR | FLOORS } : 0.7
  FACADE : fits -> subdiv("Y", 4, 1r) { SHOP | FLOORS }         : 0.3
  FACADE : else -> WALL

A symbol without rules is a terminal and is drawn; NIL deletes. `super` goes on with the rule that this
one overrides, Other::SYMBOL with the rules of another style, style(expr)::SYMBOL with a style by name.)"},
    Topic{"sizes", "Sizes in splits",
          R"(  2.5      metres
  30%      of the scope
  1r       a share of what the others leave
  ~1.2     wants 1.2 m and stretches with the other floats to fill

A list is spliced in: subdiv("Y", [3, 2.8, 2.8, 1r]) is not possible, but subdiv("Y", Storeys, 1r) with
var Storeys = [3, 2.8, 2.8] is. One part for several sizes repeats: { FLOOR[split.index] }.)"},
    Topic{
        "variables", "Variables, and where a value comes from",
        R"(Strongest first: --set Block.Name=v, set(Block.Name, v) on the shape or an ancestor, a footprint's
property Block.Name, the most derived style, ... the base.

  var Height = attr("height", 9)      reads a property of the footprint, with a default
  @per("shape") var Width = rand(1, 2)   drawn at each use; without @per once a building

BUILDING_HEIGHT, BUILDING_LEVELS, BUILDING_NAME and BUILDING_USE are read from the usual properties.)"},
    Topic{"inheritance", "Styles that inherit",
          R"(  style Terrace : House, Sills { Tile { var WindowWidth = 1.2 } }

Blocks of one name merge; variables override by name, rules by symbol; `replace Tile { ... }` drops what
was inherited in that block. Expressions are late bound: an inherited expression that reads WindowWidth
sees the child's. Parents are ordered as in Python (C3).)"},
    Topic{"attributes", "What an expression can read of a shape",
          R"(  W H D (= scope.sx, scope.sy, scope.sz)  scope.tx scope.ty scope.tz
  area volume perimeter inradius edges  is_rectangle is_convex is_planar
  facing (azimuth in degrees, 0 north)  slope (degrees)  elevation (metres above the building's base)
  split.index split.count split.round  comp.index comp.count comp.name
  level (part of the nearest split along Y)  index  symbol  seed)"},
    Topic{
        "frames", "Which way x, y and z point",
        R"(Right-handed, metres, y up. A footprint: x along its first edge, y up, z outwards from it. A face made
by comp, roof or detrude: x along its lowest edge, y up the face, z its outward normal; its size is
W x H x 0. extrude goes up where the shape lies flat, else along z.)"},
};

}  // namespace

std::span<const Topic> topics() { return rows; }

}  // namespace mansard
