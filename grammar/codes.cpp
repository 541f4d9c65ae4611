#include "grammar/codes.hpp"

#include <algorithm>
#include <array>

namespace mansard {

namespace {

// One row an entry, in the order of their numbers. A page says why, shows the case, and what to do.
constexpr std::array rows{
    CodePage{
        "W001", "A symbol stands where a rule begins, but has no '->'.",
        R"(A rule ends where the next head, NAME … ->, begins; line ends mean nothing. A name that has lost
its arrow is therefore read as the last symbol of the rule above it.

    Facade {
        FACADE -> extrude(0.2) { WALL }
        WALL                                // read as: FACADE -> extrude(0.2) { WALL } WALL
    }

Add the arrow, or indent the symbol deeper than its rule when it belongs there.)"},
    CodePage{
        "W002", "A guarded rule has no 'else'.",
        R"(When no condition of a symbol's rules holds, the shape stays as it is, a terminal of that symbol.
That is rarely meant, and it shows only on the footprint that is too narrow.

    FACADE : H > 4 -> subdiv("Y", 3, 1r) { GROUND_FLOOR | UPPER_FLOORS }

Say what is left over:

    FACADE : else  -> WALL)"},
    CodePage{
        "W003", "Two parents that know nothing of each other give the same member.",
        R"(The parent that is earlier in the resolution order wins, and the other's is never used.

    style Shop : Georgian, Glazed { }       // both give rules to FACADE

Settle it in the child, or mark the winner 'override' or let it call 'super' when it is made to be mixed
in. 'mansard explain' shows the order.)"},
    CodePage{
        "W004", "A symbol is overridden in another block than its own.",
        R"(Rules are overridden by symbol, whatever block they stand in. A reader looks for them in the block
that first gave them, and 'replace' of that block would not reach them.

    style Base    { Tile { TILE -> WALL } }
    style Special : Base { Floor { TILE -> WINDOW } }     // TILE belongs to Tile

Move the rule into the block of the same name.)"},
    CodePage{
        "W005", "A style has no rule for the symbol with which derivation begins.",
        R"(A derivation begins at FOOTPRINT, or at what the style's 'start' names. Without a rule for it the
footprint itself is all that is drawn. Often the name is misspelt.

    style Hut { Mass { FOOTPRNT -> extrude(3) } }

Give the symbol a rule, or say: start NAME)"},
    CodePage{
        "W008", "The mesh of an element is missing.",
        R"(The file was looked for beside the script that names it, in the style path and in the library, and
under the same name with the endings .obj and .glb. Shapes of the symbol stay plain polygons.

    Elements { WINDOW : "sash_window.obj" }

Correct the path, or add its folder with --style-path.)"},
    CodePage{
        "W010", "No production was a candidate: the shape stays a terminal.",
        R"(Every rule of the symbol has a condition and none of them held for this shape. It is said once a
symbol and counted in the report; with --strict it is an error that names the shape.

    FLOOR : W > 5 -> repeat("X", 2.1) { TILE }

Add FLOOR : else -> WALL, or whatever a narrow floor should be.)"},
    CodePage{
        "W011", "A part that a roof makes is not named.",
        R"(The roof has a surface for which the rule says nothing, so the building has a hole there.

    ROOF -> roof("gable", 38) { slope : SLATE }            // and the gables?

Name the part, or send it to NIL when it should be open:

    ROOF -> roof("gable", 38) { slope : SLATE | gable : WALL | soffit : TIMBER })"},
    CodePage{
        "W012", "An attribute of a footprint can not be read.",
        R"(attr("height", 7.5) gives what its default is, here a number. The footprint's property is text that is
no number with a unit, so the default was taken.

    height = "about 12"                                    // understood: 12, 12.5 m, 40'

Correct the data, or read it as text: attr("height", "").)"},
    CodePage{
        "W013", "The sizes of a split leave a gap.",
        R"(All sizes are fixed and their sum is less than the scope, so a strip of the wall stays open.

    FLOOR -> subdiv("X", 1, 2) { WALL | TILE }             // and the rest?

Let one size take what is left:

    FLOOR -> subdiv("X", 1, 2, 1r) { WALL | TILE | WALL })"},
    CodePage{
        "W014", "A shape has no edge of the number that was asked for.",
        R"(Edges are numbered from 0, around the outline and then around each hole. A footprint with three edges
has no edge 3, so the number chooses nothing there.

    FOOTPRINT -> setback(2, 3) { LOT | GARDEN }

Choose edges by what they are, where you can: "street", "party", "front".)"},
    CodePage{
        "W020", "The picture of a texture is missing.",
        R"(The file was looked for beside the script that names it, then in each --style-path. The surfaces keep
their plain colour.

    Materials { WALL : texture("brick.jpg", 2, 1) }

Correct the name, or add the folder with --style-path.)"},
};

}  // namespace

std::span<const CodePage> code_pages() { return rows; }

const CodePage* find_code(std::string_view code) {
  const auto* found = std::find_if(rows.begin(), rows.end(),
                                   [&](const CodePage& page) { return page.code == code; });
  return found == rows.end() ? nullptr : found;
}

}  // namespace mansard
