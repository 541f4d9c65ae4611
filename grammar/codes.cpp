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

So it is with variables, functions, elements and materials of one name. Settle it in the child, or mark the
winner 'override' or let it call 'super' when it is made to be mixed in. A mixin whose rule says 'super'
stands before what it goes on with: style Mine : Cornice, House.)"},
    CodePage{
        "W004", "A member is overridden in another block than its own.",
        R"(Rules are overridden by symbol, whatever block they stand in. A reader looks for them in the block
that first gave them, and 'replace' of that block would not reach them.

    style Base    { Tile { TILE -> WALL } }
    style Special : Base { Floor { TILE -> WINDOW } }     // TILE belongs to Tile

Move the rule into the block of the same name. A variable that is given in another block is a new one: it
overrides nothing at all.

    style Wide    : Base { Floor { var WindowWidth = 2 } } // Tile.WindowWidth stays as it was)"},
    CodePage{
        "W005", "A style has no rule for the symbol with which derivation begins.",
        R"(A derivation begins at FOOTPRINT, or at what the style's 'start' names. Without a rule for it the
footprint itself is all that is drawn. Often the name is misspelt.

    style Hut { Mass { FOOTPRNT -> extrude(3) } }

Give the symbol a rule, or say: start NAME)"},
    CodePage{
        "W006", "A variable or function is never read.",
        R"(No rule, variable or function of the style, or of one that inherits from it, reads it, so another value
would change nothing. set() and --set give values, they do not read them. In a child it may also be that a
rule which read it was overridden.

    Tile { var WindowDepth = 0.1   TILE -> WINDOW }        // and where is the depth?

Use it, or take it away. Nothing is said of styles that are only mixed in elsewhere.)"},
    CodePage{
        "W007", "A production is never chosen.",
        R"(Its condition is never true, its probability is 0, or it is an 'else' after a production that always
fits.

    FACADE -> WALL
    FACADE : else -> subdiv("X", 1r, 1r) { PIER | PANEL }  // the first always fits

Put its condition right, or take it away. Several ': else' after each other are alternatives, drawn by their
probabilities.)"},
    CodePage{
        "W008", "The mesh of an element is missing or can not be read.",
        R"(The file was looked for beside the script that names it, in the style path and in the library, and
under the same name with the endings .obj and .glb. Shapes of the symbol stay plain polygons. A mesh is not read
where it, or a file that it names, lies outside the folders of the scripts, of --style-path and of the library,
nor where it is larger than 256 MB or broken.

    Elements { WINDOW : "sash_window.obj" }

Correct the path, or add its folder with --style-path.)"},
    CodePage{
        "W009", "A symbol has rules, elements or materials, but no shape ever has that symbol.",
        R"(No style of the script that can be derived comes to it from its start, through 'super', Other::SYMBOL,
variables and parameters. Often a name is misspelt, or the rule that emitted it was overridden.

    FACADE -> repeat("X", 2) { TILLE }
    TILE   -> WINDOW                                       // nothing emits TILE

Emit it, or take it away. Nothing is said of styles that are only mixed in elsewhere.)"},
    CodePage{
        "W010", "No production was a candidate: the shape stays a terminal.",
        R"(Every rule of the symbol has a condition and none of them held for this shape, or tests an index that it
has not. It is said once a symbol and counted in the report; with --strict it is an error that names the shape.

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
        "W015", "A name hides another one.",
        R"(A parameter hides variables and symbols of its name, a block's variable or function the style's. The rule
reads the nearer one, which a reader may not see, and an override of the farther one changes nothing there.

    var Width = 2
    Tile { var Width = 1   TILE -> subdiv("X", 1r, Width, 1r) { WALL | WINDOW | WALL } }

Give one of them another name.)"},
    CodePage{
        "W016", "A name is nearly an inherited one.",
        R"(A child gives a rule, a variable, a function or a block that no parent has, that nothing reaches or reads,
and whose name is nearly that of one that the parents have. It was probably meant to override that.

    style Wide : House { Tile { var WindwoWidth = 2 } }    // WindowWidth

Correct it. 'override' before a rule or variable makes such a slip an error.)"},
    CodePage{
        "W017", "A terminal is nearly the name of a symbol that is known.",
        R"(It has no rules, elements or materials, is emitted in one place only, and one slip of the keys away there
is a symbol that has.

    Column -> subdiv("Y", 1r, 1.4, 1r) { WALL | WINDWO | WALL }
    WINDOW -> detrude(0.1) { GLASS | REVEAL }

Correct it, or give it a material.)"},
    CodePage{
        "W018", "Probabilities can not be met.",
        R"(The probabilities of the productions that fit add up to 0, so that none can be drawn; or they add up to
more than 1 beside a production that has none and counts as 1.

    FLOOR -> A : 0.7
    FLOOR -> B : 0.6
    FLOOR -> C                                             // 1 of 2.3, not the rest

Probabilities are shares: 2, 1 and 1 draw as 0.5, 0.25 and 0.25 do.)"},
    CodePage{
        "W019", "A variable's value is not what its annotation allows.",
        R"(@range, @choice and @color tell tools which values make sense; the value that stands there is none of
them. A child's variable keeps the annotations of the one that it overrides.

    @range(0.3, 2) var WindowWidth = 3

Change the value, or what the annotation says.)"},
    CodePage{
        "W020", "The picture of a texture is missing, or is none that can be used.",
        R"(The file was looked for beside the script that names it, then in each --style-path. It is not used where
it lies outside the folders of the scripts, of --style-path and of the library. The surfaces keep their plain
colour.

    Materials { WALL : texture("brick.jpg", 2, 1) }

Correct the name, or add the folder with --style-path.)"},
    CodePage{
        "W021", "A footprint's property is nearly the name of a variable.",
        R"(A property named Block.Name gives that variable its value for one building; a bare Name only a variable of
the style. This one fits no variable, so it changes nothing.

    "properties": { "Tile.WindwoWidth": 1.2 }              // Tile.WindowWidth
    "properties": { "HEIGHT": 9 }                          // attr("height", 6) reads 'height'

Names are told apart by case, those that attr() reads too. Correct it in the data or in --attr.)"},
    CodePage{
        "W022", "A style that may be asked for is not loaded.",
        R"(style(…) derives under the style of this name, and the script itself gives a name that no loaded style
has: as the default of a property, or as what a condition or a draw chooses. Deriving fails where it is asked for.

    FOOTPRINT -> style(attr("style", "Terace"))::FOOTPRINT // Terrace

Correct it, or import the file that holds the style. A default of "" says that there is none.)"},
    CodePage{
        "W023", "A roof had to be made by a simpler construction.",
        R"(Roofs stand on the straight skeleton of the footprint. Where that can not be built, because the outline
crosses itself, is tiny or hangs together by a hair, the footprint is made coarser by centimetres; failing that
one ridge runs over the whole, and in the end the roof is flat. The report counts each: roofs_not_as_asked.

Look at the footprint's outline. What a roof is like is a kind's own choice: roof("flat") is never a fallback.)"},
    CodePage{
        "W024", "A roof can not have all that was asked of it on this shape.",
        R"(A "pyramid" needs a point that sees every edge, which a concave shape or one with a courtyard has not: it
becomes a hip roof. A break that lies above the ridge breaks nothing. Where the height is less than
twice the roof's thickness its edge is made thinner.

    ROOF -> roof("mansard", 70, break_height = 6) { slope : SLATE }   // on a house 5 m wide

The report counts each: roofs_not_as_asked.)"},
    CodePage{
        "W025", "An overhang is wider than the building.",
        R"(The roof reaches farther beyond the walls than they stand apart. Often the number was meant in other units,
or a small annexe got the roof of a house.

    ROOF -> roof("hip", 30, overhang = 40) { slope : TILES | soffit : WOOD | fascia : WOOD }

Make it depend on the shape: overhang = min(0.4, inradius / 2).)"},
    CodePage{
        "W026", "A symbol is emitted with an index that none of its productions takes.",
        R"(Every production of the symbol tests an index in its head, and none of them this one, so that the shape
stays as it is. In a child this is often what an override left out: it replaces all inherited productions of the
symbol, whatever their index.

    FACADE   -> subdiv("Y", 3, 1r) { FLOOR[0] | FLOOR[2] }
    FLOOR[0] -> SHOP
    FLOOR[1] -> repeat("X", 2) { WINDOW }

Give it the number that was meant, or add a production that takes any other: FLOOR -> WALL)"},
    CodePage{
        "W027", "An axis snaps, and nothing records a plane for it.",
        R"(A split whose axis is written with an S goes to the planes that snap() recorded before, and to the faces of
masses that its own one meets. Here no rule says snap(), and there is one mass only.

    FOOTPRINT -> extrude(9) comp { side : FACADE }
    FACADE    -> repeat("XS", 2) { TILE }

Record planes where the lines are: GROUND -> repeat("X", 3.5) { snap("YZ") SHOP }, or write "X".)"},
    CodePage{
        "W028", "Nothing in a part says how long it is, and its size is ':'.",
        R"(A size ':' is as long as what is derived from the part: the fixed sizes of its splits, its elements' meshes.
Where there are none along that axis, as in a plain wall, it takes its share of the room, like 1r.

    FLOOR -> subdiv("X", :, 1r) { WALL | TILE }            // how wide is a WALL?

Say 1r, or give the part a size.)"},
};

}  // namespace

std::span<const CodePage> code_pages() { return rows; }

bool each_text_is_news(std::string_view code) {
  return code == "W012" || code == "W011" || code == "W023" || code == "W024";
}

const CodePage* find_code(std::string_view code) {
  const auto* found = std::find_if(rows.begin(), rows.end(),
                                   [&](const CodePage& page) { return page.code == code; });
  return found == rows.end() ? nullptr : found;
}

}  // namespace mansard
