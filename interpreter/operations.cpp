// The table of operations. A row is checked while compiling: every parameter has a name, and its
// type and whether it may be left out come from the function's own signature.
#include "interpreter/operation.hpp"

#include <algorithm>

#include "interpreter/operations/functions.hpp"

namespace mansard {
namespace {

template <auto F, class... P>
consteval Operation signature_of(void (*)(Context&, P...)) {
  Operation row;
  static_assert(sizeof...(P) <= max_parameters);
  ((row.parameters[row.count++] = parameter_of<P>::is), ...);
  for (std::size_t i = 0; i < row.count; ++i) {
    const Parameter p = row.parameters[i];
    if (!p.optional) row.required = static_cast<uint8_t>(i + 1);
    if (p.type != ArgType::sizes && p.type != ArgType::values) continue;
    row.variadic = true;
    row.rest = static_cast<uint8_t>(i);
  }
  row.invoke = [](Context& c) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { F(c, taker<P>::take(c, I)...); }
    (std::index_sequence_for<P...>{});
  };
  return row;
}

template <auto F>
constexpr Operation row(std::string_view group, std::string_view name, std::string_view args,
                        PartRule rule, std::string_view parts, std::string_view summary,
                        std::string_view example) {
  Operation r = signature_of<F>(F);
  if (names_in(args) != r.count) throw "every parameter needs a name";
  r.group = group;
  r.name = name;
  r.args = args;
  r.rule = rule;
  r.parts = parts;
  r.summary = summary;
  r.example = example;
  r.is_split = rule == PartRule::sizes || rule == PartRule::pattern || rule == PartRule::selectors;
  return r;
}

template <auto F>
constexpr Operation waiting(std::string_view group, std::string_view name, std::string_view args,
                            PartRule rule, std::string_view parts, std::string_view summary,
                            std::string_view example) {
  Operation r = row<F>(group, name, args, rule, parts, summary, example);
  r.waits = true;
  return r;
}

using enum PartRule;
namespace op = operation;

constexpr std::array rows{
    row<op::subdiv>(
        "split", "subdiv", "axis, size, to, tolerance", sizes, "",
        "Divides the shape along an axis, or an angle in its plane, into one part for each size.",
        "extrude(6) comp { front : subdiv(\"Y\", 3, 1r) { GROUND_FLOOR | UPPER_FLOOR } }"),
    row<op::repeat>("split", "repeat", "axis, size, mode, to, tolerance", body, "",
                    "Divides the shape into as many equal parts of about the size as fit; mode is "
                    "\"nearest\", \"fit\" or \"ceil\".",
                    "extrude(6) comp { front : repeat(\"X\", 2.2) { TILE } }"),
    row<op::split>(
        "split", "split", "axis, to, tolerance", pattern, "",
        "Divides the shape by a pattern of sizes in which groups { ... }* repeat.",
        "extrude(6) comp { front : split(\"X\") { 1 : PIER | { ~2 : BAY | 1 : PIER }* } }"),
    row<op::comp>("components", "comp", "selector", selectors, "",
                  "Takes the shape apart into faces, edges or vertices; the first part that "
                  "selects one gets it.",
                  "extrude(6) comp { side : FACADE | top : ROOF }"),
    row<op::extrude>("mass", "extrude", "height, corners", body, "",
                     "Draws a flat shape upwards where it lies flat, else out of its plane.",
                     "extrude(6) { MASS }"),
    row<op::detrude>("mass", "detrude", "depth", named, "inner | reveal",
                     "Moves a face in by the depth; the reveals are the faces around the recess.",
                     "extrude(6) comp { front : detrude(0.2) { WINDOW | WALL } }"),
    row<op::taper>("mass", "taper", "height", body, "",
                   "Draws a flat shape up to a point above its centre of gravity.",
                   "taper(5) { SPIRE }"),
    row<op::offset>(
        "plan", "offset", "distance, edges", named, "inside | border",
        "Moves the chosen edges (all by default) inwards; a negative distance moves all outwards.",
        "offset(1) { LAWN | PATH }"),
    row<op::setback>("plan", "setback", "distance, edges", named, "kept | strip",
                     "Cuts a strip off along each chosen edge.",
                     "setback(2, \"front\") { LOT | GARDEN }"),
    row<op::chamfer>("plan", "chamfer", "distance, edges", body, "",
                     "Cuts the corners between chosen edges off.", "chamfer(1) { PLAN }"),
    row<op::shape_l>("plan", "shapeL", "front, left", named, "shape | rest",
                     "Keeps an L: wings of the given depths along the front and the left.",
                     "shapeL(4, 3) { extrude(5) { WINGS } | GARDEN }"),
    row<op::shape_u>("plan", "shapeU", "front, left, right", named, "shape | rest",
                     "Keeps a U: wings along the front, the left and the right.",
                     "shapeU(3, 2, 2) { extrude(5) { WINGS } | COURT }"),
    row<op::shape_o>("plan", "shapeO", "front, right, back, left", named, "shape | rest",
                     "Keeps a ring of wings around a court.",
                     "shapeO(2, 2, 2, 2) { extrude(5) { WINGS } | COURT }"),
    row<op::inner_rectangle>("plan", "inner_rectangle", "", named, "inside | rest",
                             "Finds the largest rectangle along the scope's axes that fits.",
                             "inner_rectangle() { HALL | REST }"),
    row<op::cut>("plan", "cut", "figure", named, "inside | outside",
                 "Cuts a figure that fills the scope out of a flat shape: \"arch\", \"circle\" or "
                 "\"segment\".",
                 "extrude(3) comp { front : cut(\"arch\") { OPENING | WALL } }"),
    row<op::roof>(
        "roof", "roof",
        "kind, pitch, overhang, height, gables, parapet, thickness, verge, hips, ridge, "
        "upper_pitch, break_height, break_inset, clipped, tooth, parapet_width",
        named,
        "slope | gable | top | soffit | fascia | parapet | lower | upper | ridge | hip | "
        "valley | eave | rake",
        "Builds a roof over a shape that lies flat; the kind is \"flat\", \"hip\", "
        "\"gable\", \"half_hip\", \"dutch_hip\", \"pyramid\", \"shed\", \"mansard\", "
        "\"gambrel\", \"saltbox\", \"cross_gable\", \"sawtooth\" or \"barrel\", the pitch "
        "in degrees.",
        "roof(\"hip\", 35) { slope : TILES | ridge : s(W, 0.1, 0.2) box() { CAP } }"),
    row<op::upright>(
        "roof", "upright", "kind, pitch, overhang, thickness", named,
        "front | cheek | top | gable | slope | soffit | fascia | rest | ridge | hip | valley "
        "| eave | rake",
        "Stands a dormer on a rectangle of a slope: \"flat\", \"shed\", \"gable\", "
        "\"hip\" or \"eyebrow\"; the pitch of its own roof in degrees.",
        "roof(\"gable\", 45) { slope : subdiv(\"Y\", 0.6, 2, 1r) { TILES | "
        "subdiv(\"X\", 1r, 1.6, 1r) { TILES | upright(\"gable\") { front : WINDOW | cheek "
        ": LEAD | gable : LEAD | slope : TILES } | TILES } | TILES } | gable : WALL }"),
    row<op::insert>("insert", "insert", "mesh, fit", body, "",
                    "Puts a mesh into the scope: \"fit\" fills it, \"keep\" and \"keep_ratio\" "
                    "keep the mesh's size or proportions.",
                    ""),
    row<op::box>("insert", "box", "", body, "", "Fills the scope with a box.",
                 "s(2, 3, 2) box() { SHED }"),
    row<op::quad>("insert", "quad", "", body, "",
                  "Fills width and height of the scope with a rectangle.",
                  "s(2, 3, 0) quad() { SIGN }"),
    row<op::cylinder>("insert", "cylinder", "sides", body, "",
                      "Fills the scope with a standing cylinder of 24 sides, or as many as given.",
                      "s(2, 6, 2) cylinder(12) { COLUMN }"),
    row<op::sphere>("insert", "sphere", "sides", body, "", "Fills the scope with a sphere.",
                    "s(2, 2, 2) sphere() { BALL }"),
    row<op::cone>("insert", "cone", "sides", body, "", "Fills the scope with a standing cone.",
                  "s(2, 3, 2) cone() { CAP }"),
    row<op::t>("transform", "t", "x, y, z", without, "",
               "Moves the scope along its own axes, in metres or per cent of its size.",
               "extrude(4) t(0, 1, 0) RAISED"),
    row<op::r>("transform", "r", "x, y, z", without, "",
               "Turns the scope about its pivot: degrees about x, then y, then z.",
               "extrude(4) r(0, 30, 0) TURNED"),
    row<op::s>("transform", "s", "x, y, z", without, "",
               "Sets the size of the scope, in metres or per cent; the geometry stretches with it.",
               "extrude(4) s(50%, 100%, 50%) SMALLER"),
    row<op::center>("transform", "center", "axes", without, "",
                    "Moves the scope to the middle of the shape that the rule or part began with.",
                    "extrude(4) s(2, 4, 2) center(\"xz\") CORE"),
    row<op::mirror>("transform", "mirror", "axis", without, "",
                    "Mirrors the shape within its scope: \"x\" by default.",
                    "extrude(4) mirror(\"x\") MIRRORED"),
    row<op::align>("transform", "align", "to", without, "",
                   "Gives the shape another frame: \"axes\" (y up), \"world\" or \"geometry\".",
                   "extrude(4) align(\"world\") BLOCK"),
    row<op::pivot>("transform", "pivot", "x, y, z", without, "",
                   "Sets the point about which r() turns, in metres or per cent of the scope.",
                   "extrude(4) pivot(50%, 0, 50%) r(0, 45, 0) TURNED"),
    row<op::color>("look", "color", "color", without, "",
                   "Colours the shape and all that is derived from it.",
                   "extrude(4) color(\"#a08070\") MASS"),
    row<op::texture>("look", "texture", "file, u, v", without, "",
                     "Covers the shape and all that is derived from it with a picture, u and v "
                     "metres for one repeat.",
                     ""),
    row<op::material>("look", "material", "name", without, "",
                      "Gives the shape and all that is derived from it a look of Materials.",
                      "extrude(4) material(BRICK) MASS"),
    row<op::uv>("look", "uv", "across, up, turn", without, "",
                "Begins pictures anew at the shape's lower left corner: so many repeats across and "
                "up it, else as many as their metres make; turned by degrees.",
                "extrude(4) comp { side : uv(1, 1) SIGN }"),
    row<op::stain>("look", "stain", "rate", without, "",
                   "Lets rain that runs off sills, ledges and what the rule emits leave streaks on "
                   "the walls below, from 0, none, to 1.",
                   "extrude(4) stain(0.5) comp { front : subdiv(\"Y\", 2, 0.1, 1r) { WALL | "
                   "extrude(0.08) { LEDGE } | WALL } | side : WALL }"),
    row<op::label>("context", "label", "name", without, "",
                   "Names the shape, for the tree and for later questions.",
                   "extrude(4) label(\"tower\") TOWER"),
    row<op::occluder>("context", "occluder", "hides", without, "",
                      "Whether the solids of this shape, and of all that is derived from it, cover "
                      "others that ask: true or false.",
                      "extrude(4) occluder(false) SCAFFOLD"),
    row<op::snap>("context", "snap", "planes, label", without, "",
                  "Records planes of the scope, on both sides of it, for splits to snap to whose "
                  "axis is written with an S: \"XZ\", \"YZ\", \"XY\" or several.",
                  "extrude(6) comp { front : subdiv(\"Y\", 3.2, 1r) { [ snap(\"XZ\") ] LOW | "
                  "HIGH } | side : FACADE }"),
    row<op::set>("context", "set", "variable, value", without, "",
                 "Gives a variable another value for this shape and all that is derived from it.",
                 "set(Test.Height, 5) extrude(Height) MASS"),
    waiting<op::best>("context", "best", "score", choices, "",
                      "Tries each part to its end and goes on with the one whose score is highest: "
                      "the first of them.",
                      "best(made(\"LOT\")) { subdiv(\"X\", 5, 1r) { LOT | LOT } | LOT }"),
    row<op::report>("control", "report", "key, value", without, "",
                    "Adds a value to the report under a key: numbers are summed, texts counted.",
                    "report(\"plot\", area) PLOT"),
    row<op::print>("control", "print", "value", without, "", "Prints values while deriving.",
                   "print(\"area\", area) PLOT"),
    row<op::fail>("control", "fail", "message", without, "",
                  "Stops the building with a message of the style's own.", ""),
};

constexpr std::array<std::string_view, 5> later{"union", "subtract", "intersect", "layers",
                                                "relayout"};

}  // namespace

std::span<const Operation> operations() { return rows; }

const Operation* find_operation(std::string_view name) {
  const auto it = std::ranges::find(rows, name, &Operation::name);
  return it == rows.end() ? nullptr : &*it;
}

std::size_t Operation::places() const {
  const auto given = std::span(parameters).first(count);
  return static_cast<std::size_t>(std::ranges::count(given, false, &Parameter::named));
}

std::size_t Operation::parameter_at(std::size_t place) const {
  std::size_t i = 0;
  for (; i < count; ++i) {
    if (!parameters[i].named && place-- == 0) break;
  }
  return i < count ? i : variadic ? rest : count;
}

std::size_t Operation::find_parameter(std::string_view word) const {
  std::size_t i = 0;
  while (i < count && parameter_name(i) != word) ++i;
  return i;
}

std::string Operation::names_by_place() const {
  std::string names;
  for (std::size_t i = 0; i < places(); ++i) {
    names += (i == 0 ? "" : ", ") + std::string(parameter_name(parameter_at(i)));
  }
  return names;
}

bool is_later_operation(std::string_view name) {
  return std::ranges::find(later, name) != later.end();
}

}  // namespace mansard
