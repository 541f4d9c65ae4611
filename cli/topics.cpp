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
Every word has a page: mansard help override, mansard help ::, mansard help overhang.
See also: mansard help rules, successors, sizes, selectors, variables, inheritance, questions, groups,
snapping, elements, attributes, frames; docs/language.md is the whole of it.)"},
    Topic{
        "rules", "Rules and productions",
        R"(All productions of a symbol whose condition holds are candidates; one is drawn by its probability.
`: else` is tried only where no production before it was a candidate; `fits` is true when no fixed size
of the successor's first split would be cut.

  FACADE : fits -> subdiv("Y", 3, 1r) { GROUND_FLOOR | FLOORS } : 0.7
  FACADE : fits -> subdiv("Y", 4, 1r) { SHOP | FLOORS }         : 0.3
  FACADE : else -> WALL

The same `: else` again, right after it, is an alternative to it. A condition without `else` leaves what
does not fit as a terminal, with a warning; --strict makes it an error. A symbol without rules is a
terminal and is drawn; NIL deletes. Parameters are given in parentheses, FLOOR[2] in a head tests the
index that FLOOR[split.index] sets, FLOOR[i] binds it.

`super` goes on with the rule that this one overrides, Other::SYMBOL with the rules of another style,
style(expr)::SYMBOL with a style by name.)"},
    Topic{
        "successors", "What stands right of the arrow",
        R"(Operations and symbols, one after the other. An operation, written with (...) or { ... }, changes the
current shape; a bare name is a symbol and emits a child. [ ... ] saves the shape and restores it.

  FACADE -> [ t(0, 0, 0.02) subdiv("Y", 0.3, 1r) { PLINTH | NIL } ] WALL

An operation with parts { A | B } gives each part a successor of its own; after the } the shape is what it
was before. Parts go by place or by name: detrude(0.2) { inner : GLASS | reveal : STONE }.

  FACADE -> if W > 9 { BRICK } else { RENDER })"},
    Topic{"sizes", "Sizes in splits",
          R"(  2.5      metres
  30%      of the scope
  1r       a share of what the others leave
  ~1.2     wants 1.2 m and stretches with the other floating sizes to fill; beside an r it only shrinks

r and % stand against a number or a parenthesis: (Share)r. A list of metres is spliced in:
subdiv("Y", Storeys, 1r) with var Storeys = [3, 2.8, 2.8]. One part for several sizes repeats:
{ FLOOR[split.index] }. When there is too little room, sizes are cut at the end, and counted.

  :        as long as what is derived from the part is by itself: what it has in metres, its elements' meshes

subdiv("X", 1r, :, 1r) { WALL | Group | WALL } leaves to Group how wide it is. Rules and elements are drawn
as they will be. Floats and repeats in the part prefer theirs, shares and plain terminals need nothing. In too
little room all ':' shrink, down to what is fixed in them. What is measured can not read its size along the
axis; fits holds meanwhile. repeat("X", :) { BAY } takes the bay's own. mansard tree FILE.style FOOTPRINT
--sizes says what was measured.)"},
    Topic{
        "selectors", "The words of comp, and of edges",
        R"(  side (facades, sidefaces)  front back left right  top bottom  vertical horizontal slanted
  party    walls that touch a neighbour's footprint, within 5 cm
  court    walls around a hole of the footprint
  street   outer walls with no neighbour within 6 m before them; main is the longest of them
  cut      faces that a split made
  faces    all faces; edges and vertices are lines and points; all takes the rest
  ridge hip valley eave rake   lines of roofs: x along them, y away from their faces
  0 1 2    the component of that number

The first part that selects a component gets it, the others are dropped:
  comp { party : WALL | main : FRONT | side : FACADE | top : ROOF }
offset, setback, chamfer and roof (ridge, gables, hips) choose edges by the same words, or a list of them:
  setback(3, ["street", "left"]) { HOUSE | GARDEN })"},
    Topic{
        "variables", "Variables, and where a value comes from",
        R"(Strongest first: --set Style::Block.Name=v for what is derived under one style, --set Block.Name=v,
set(Block.Name, v) on the shape or an ancestor, a footprint's property Block.Name (a bare Name for
variables of the style only), the most derived style, ... the base.

  var Height = attr("height", 9)      reads a property of the footprint, with a default
  @per("shape") var Width = rand(1, 2)   drawn once a shape; without @per once a building

A variable that reads the shape is evaluated at each use. Text such as 12.5 m or 40' reads as a number.
@seed(7) before a style gives it a seed for where --seed is not given.
BUILDING_HEIGHT, BUILDING_LEVELS, BUILDING_NAME and BUILDING_USE are read from height, min_height,
building:levels, name, use and building. See also: mansard help annotations.)"},
    Topic{"inheritance", "Styles that inherit",
          R"(  style Terrace : House, Sills { Tile { var WindowWidth = 1.2 } }

Blocks of one name merge; variables override by name, rules by symbol; `replace Tile { ... }` drops what
was inherited in that block. Expressions are late bound: an inherited expression that reads WindowWidth
sees the child's. Parents are ordered as in Python (C3). `override` says that a parent must have the
member, `final` that no child may; `abstract NAME` must be given by a child. In a mixin `super` goes on
with the next style's rule of the symbol:

  style Cornice { Facade { FACADE -> [ subdiv("Y", 1r, 0.3) { NIL | extrude(0.2) { LEDGE } } ] super } }

mansard explain FILE.style says who gives what, mansard explain FILE.style Tile.WindowWidth why.)"},
    Topic{"questions", "Shapes that ask about others",
          R"(  TILE : Shape.occ("all") == "none" -> WINDOW
  TILE : Shape.occ("all") == "part" -> WALL
  TILE : Shape.occ("all") == "full" -> NIL

How far a shape is covered by solids: a point of a face is, when 1 mm before the face lies inside one. So the
mass behind a face never covers it. Pieces thinner than 1 cm do not count (6 cm beside other buildings).

  "all"         all solids, replaced ones too, and other buildings
  "noparent"    all but those that the shape came from; other buildings
  "active"      solids that are drawn as they are
  "neighbours"  other buildings, as footprints drawn up to their height
  a label       what label(name) names, and the solids derived from it

Shape.occ(set, "distance", d) counts what stands within d metres before the face. inside(set) means "full",
overlaps(set) not "none", touches(set) that a solid ends in the face's plane. Shape.visible(set) says
whether the nearest solid of the set is seen, nearest(set) how many metres away it is; both also
take "street", the lines of --streets. occluder(false) makes solids
that cover nothing.

A shape whose rules ask waits until nothing else is left; all that wait see the same building and are answered
together. @stage(2) before a rule makes it wait for a later round; without it rules that ask are of stage 1.
mansard tree FILE.style FOOTPRINT --rounds says what was asked and answered.)"},
    Topic{
        "groups", "Shapes that decide together, and the best of several alternatives",
        R"(  Site(worth) : group.best(worth + W) -> ENTRANCE                       one in the whole building
  Tile : group.any(Shape.occ("noparent") != "none", "ROW") -> HIGH      for the tiles of one row together

The shapes of one symbol and style that wait for the same round are a group; each is asked with its own size,
parameters and draws. A symbol behind it makes the group those below one ancestor of that symbol.

  group.any(condition)  group.all(condition)  group.count(condition)
  group.sum(x)  group.max(x)  group.min(x)
  group.rank(score)   0 for the greatest        group.best(score)   true for exactly one

Without @stage they are of stage 2, after all that waits for stage 1.

  Plot -> best(reported("lit area")) { Slab | Court | Towers }

derives each part to its end on the side and goes on with the one of the highest score. made("SYMBOL") counts
terminals of a part, reported("key") sums what it reported.)"},
    Topic{"snapping", "Lines that splits snap to",
          R"(  GROUND -> repeat("X", 3.5) { snap("YZ") SHOP }
  FLOOR  -> repeat("XS", 1.6) { TILE }

snap("YZ") records the planes on the left and right of a shape, "XZ" those below and above it, "XY" those behind
and before it; they are infinite and hold for the whole building. Masses, which extrude or box stands on the
ground or on a flat face, record theirs for the masses that they meet. A split whose axis is written with an S
goes to where planes cross its shape:

  repeat("XS", size)      is solved between each line and the next
  subdiv("YS", sizes...)  moves the boundary that is nearest to a line; split("XS") { ... } likewise
  tolerance = 0.3         subdiv, split: how far at most; repeat: nearer lines count as one, the first
  to = "label"            only planes of snap("YZ", "label"), and masses of label("label")

Shapes that snap wait: they see the planes that were recorded before their round. @stage(2) before a rule makes
it wait for a later one. mansard tree FILE.style FOOTPRINT --rounds shows the lines that each split saw.)"},
    Topic{"elements", "Meshes and looks of terminals",
          R"(  Elements  { WINDOW : "near.obj" "far.obj" : 0.7   "other.obj" : 0.3
              DOOR + "door3.obj" : 0.1   remove LEDGE }
  Materials { WALL : color("tan") : 0.6  texture("brick.png", 2, 1) : 0.4  per "building"
              GLASS : color("#31434d") opacity(0.4) roughness(0.05) }

A weight or a bar ends an alternative; : sets, + adds, - takes away. An element's meshes are its levels of
detail, nearest first; a flat scope keeps the mesh's own depth, and a face that is no rectangle cuts it off at
its outline. insert(file, "fit" | "keep" | "keep_ratio") does so in a rule. Looks are drawn per "shape", "building" or
the nearest shape above of a symbol. See mansard help files for where meshes are looked for.

  color("tan")  opacity(0.4)  roughness(0.3)  metallic(1)      numbers from 0 to 1; matt, no metal by default
  texture("brick.png", 2, 1)  metres(2, 1)                     one repeat covers 2 by 1 metres
  normals("brick_normal.png")  roughness("brick_rough.png")    repeat with it; green of a normal is up

A color() behind a texture() tints it, one before it stands in where the picture is missing. In rules,
material(BRICK) gives a look of Materials to all that is derived from the shape. Pictures run on over all that a
wall is split into; uv(1, 1) shows one once on the shape, uv(turn = 90) lays it across. The library has brick,
ashlar, slate, tiles, render, timber and glass in textures/.

Pictures show looks in sunlight: lighter than written where it falls, darker in the shade. A model has them
as written.)"},
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
    Topic{"footprints", "What a building can stand on",
          R"(A file, or a literal in metres:

  rect:10x8        width and depth
  L:12x9x5x4       width, depth, width and depth of the missing corner
  T:14x10x4x6  U:14x10x6x5  ring:20x16x8x6  WKT:POLYGON((0 0, 10 0, 10 8, 0 8, 0 0))

GeoJSON, Shapefile, GeoPackage, FlatGeobuf and OpenStreetMap files (of these the areas tagged building),
and the faces of an OBJ. Degrees become metres about the middle of the set. --layer and --where choose
what is read, --select id=ID and --limit N what is derived, --attr gives every footprint a property.

The id is --id's property, else osm_id, the feature's id, id, or its place in the file; with --seed it
decides every draw. Crossing rings are repaired with a note; what can not be repaired is an error, or left
out under --keep-going. --drop-small leaves out what has less than a tenth of the mean area, before party
walls are found; the mean is that of all that is read, whatever is selected.)"},
    Topic{
        "output", "What derive writes",
        R"(An OBJ with its MTL beside it, textures copied beside them: an object o for each building, named by its
id, a group g for each symbol, polygons as they are, with normals and texture coordinates. Metres, y up
(--up z: z up); the first lines say which style, seed and origin. It appears whole or not at all.

--lod 1 keeps the masses, 2 leaves out relief, 3 is everything, all writes the three. glTF, PLY and STL: see
mansard help models. --report FILE.json has the counts and
areas of every terminal and the sums of report(). The same inputs give the same bytes on any number of
threads. Exit status: 0 done, 1 something in the input is wrong, 2 wrong usage, 3 an internal failure.)"},
    Topic{
        "editors", "Scripts in an editor",
        R"(mansard lsp speaks the Language Server Protocol: problems as you type, hover with documentation and
where a value comes from, definition, declaration (what a member overrides), implementation (what overrides
it), references, rename across files, completion, signatures, outlines, formatting, quick fixes.

  editors/vscode     an extension for Visual Studio Code
  editors/neovim     a set-up for Neovim's own client

For any other editor: start 'mansard lsp' for files that end in .style. See docs/editors.md.)"},
    Topic{
        "variations", "Contact sheets, and styles that keep a variation",
        R"(mansard vary draws what differs side by side, by one camera, on one ground: seeds (--count), styles
(--styles A,B,C), the values of a variable (--sweep). Two of these make rows and columns.

  --sweep Tile.Width=0.6:1.4:0.2    from, to, step
  --sweep Roof.Kind=gable,hip       values; a word is text, unless the style knows it as a name
  --sweep Tile.Width                what @range(0.6, 1.4, 0.2) or @choice(...) before it says; of a long
                                    range nine values

Each picture is derived from a child style of three lines, which --export DIR writes beside its model:

  // made by mansard vary
  import "../terrace.style"
  @seed(7) style Terrace_03 : Terrace { Tile { var Width = 0.8 } }

Derived on the same footprint, with the same --attr and --lod, it gives the same bytes. So --sweep and --set
say here what a style says: set() in a rule and a footprint's property are stronger. Files in DIR are written
over only when they begin with this first line.)"},
    Topic{
        "models", "The formats of models, instances, levels of detail",
        R"(  -o town.obj     Wavefront OBJ with its .mtl: an object a building, a group a symbol, polygons kept
  -o town.glb     glTF 2.0 in one file, textures in it; at most 4 GB
  -o town.gltf    glTF 2.0 as text, with town.bin and textures beside it
  -o town.ply     PLY, binary, by Assimp: triangles with normals and nothing else, no names and no looks
  -o town.stl     STL, binary, by Assimp: triangles and nothing else; both at most 10 million, held in memory

In glTF every building is a node with its id, style and the footprint's attributes as extras; below it is a
node for each symbol, and a node for each element or inserted mesh, which share one mesh. So do solids of
eight faces and more that come twice, such as columns and balls. Metres, y up, colours linear. Textures
are PNG or JPEG. --up z turns OBJ, PLY and STL.

  --instancing gpu    EXT_mesh_gpu_instancing: a node for all that is alike in a symbol of a building; boxes,
                      such as sills, too. What a client picks is the building (the parent's parent's extras), the
                      symbol (extras) and the instance's number. three.js and Cesium read it, Blender does not.
  --instancing none   every copy by itself
  --compress draco    KHR_draco_mesh_compression: places to a tenth of a millimetre, texture coordinates to
                      1/4096 of a picture. Blender, three.js, Cesium and Unreal read it.

--lod all writes town_lod1.glb, town_lod2.glb and town_lod3.glb, which all programs can read, each level by
itself; --report says how many faces and vertices each has. One file of all three (MSFT_lod) is read by
hardly any program.)"},
    Topic{
        "files", "Where imports, meshes and textures are looked for",
        R"(  import "parts.style"             beside the importing file, in --style-path, in the library
                                   It stands at the top of a script, which then knows that one's styles:
                                   style Mine : House { Tile { override var Width = 0.9 } }
  Elements { WINDOW : "w.mesh" }   the same places; then w.obj and w.glb; if missing, warning W008
  insert("tree.obj"), texture("brick.png")   beside the script, then in --style-path

Meshes, and what they name, are read only from below the folders of the scripts, of --style-path and of the
library, links followed: --style-path DIR adds one. A mesh file has at most 256 MB.

The library is share/mansard/styles beside an installed program, else styles/library of the sources.)"},
};

}  // namespace

std::span<const Topic> topics() { return rows; }

}  // namespace mansard
