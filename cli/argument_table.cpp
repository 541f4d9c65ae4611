#include "cli/argument_table.hpp"

#include <algorithm>
#include <array>

namespace mansard {
namespace {

// clang-format off
constexpr std::array arguments{
    ArgumentRow{"subdiv", "axis", "\"X\" across, \"Y\" up, \"Z\" into the depth, or degrees in a face's plane; \"XS\" snaps"},
    ArgumentRow{"subdiv", "size", "one for each part: 2.5 (metres), 30%, 1r (a share of the rest), ~1.2 (about)"},
    ArgumentRow{"repeat", "axis", "\"X\" across, \"Y\" up, \"Z\" into the depth, or degrees in a face's plane; \"XS\" snaps"},
    ArgumentRow{"repeat", "size", "metres, about: the parts stretch to fill"},
    ArgumentRow{"repeat", "mode", "how the number is rounded: \"nearest\" (if nothing is said), \"fit\" down, \"ceil\" up; at least 1"},
    ArgumentRow{"split", "axis", "\"X\" across, \"Y\" up, \"Z\" into the depth; \"XS\" snaps"},
    ArgumentRow{"subdiv", "tolerance", "metres, 0 to 100, that a boundary moves at most to snap; 0.3 if nothing is said"},
    ArgumentRow{"split", "tolerance", "metres, 0 to 100, that a boundary moves at most to snap; 0.3 if nothing is said"},
    ArgumentRow{"repeat", "tolerance", "metres, 0 to 100: lines nearer together, or to an end, count as one; 0.3 if nothing is said"},
    ArgumentRow{"subdiv", "to", "a label: snap only to planes that snap() recorded with it and to masses of this label()"},
    ArgumentRow{"repeat", "to", "a label: snap only to planes that snap() recorded with it and to masses of this label()"},
    ArgumentRow{"split", "to", "a label: snap only to planes that snap() recorded with it and to masses of this label()"},
    ArgumentRow{"snap", "planes", "\"XZ\" below and above the shape, \"YZ\" left and right, \"XY\" behind and before; \"XZ YZ\" both"},
    ArgumentRow{"snap", "label", "text: splits with to = \"...\" snap only to planes of that label"},
    ArgumentRow{"comp", "selector", "the faces that the one part takes, comp(\"facades\") { A }; without it every part has its selector"},
    ArgumentRow{"extrude", "height", "metres, 0 or more"},
    ArgumentRow{"extrude", "corners", "of a wall's band: \"square\" (if nothing is said) or \"mitre\""},
    ArgumentRow{"detrude", "depth", "metres into the wall, 0 or more"},
    ArgumentRow{"taper", "height", "metres to the point, 0 or more"},
    ArgumentRow{"offset", "distance", "metres; inwards, a negative one outwards"},
    ArgumentRow{"setback", "distance", "metres of the strip"},
    ArgumentRow{"chamfer", "distance", "metres from the corner"},
    ArgumentRow{"*", "edges", "which edges: a word (\"front\", \"street\"; mansard help selectors), a number, or a list; all if nothing is said"},
    ArgumentRow{"*", "front", "metres: depth of the wing along the front"},
    ArgumentRow{"*", "right", "metres: depth of the wing on the right"},
    ArgumentRow{"*", "back", "metres: depth of the wing along the back"},
    ArgumentRow{"*", "left", "metres: depth of the wing on the left"},
    ArgumentRow{"cut", "figure", "\"arch\", \"circle\" or \"segment\""},
    ArgumentRow{"roof", "kind", "\"flat\" \"hip\" \"gable\" \"half_hip\" \"dutch_hip\" \"pyramid\" \"shed\" \"mansard\" \"gambrel\" \"saltbox\" \"cross_gable\" \"sawtooth\" \"barrel\""},
    ArgumentRow{"roof", "pitch", "degrees from level, between 0 and 90; 35 if nothing is said, mansard 70, gambrel and barrel 60, saltbox 45, sawtooth 30, shed 15"},
    ArgumentRow{"roof", "overhang", "metres beyond the walls, 0 to 10; 0 if nothing is said. It makes soffit and fascia"},
    ArgumentRow{"roof", "height", "metres from the walls' top to the highest point, more than 0; instead of a pitch"},
    ArgumentRow{"roof", "gables", "the ends that are gables, whatever the kind says: words, numbers or a list"},
    ArgumentRow{"roof", "parapet", "metres: height of the wall around a flat roof, 0 to 100; 0 if nothing is said"},
    ArgumentRow{"roof", "thickness", "metres, upright, of the roof's edge where it overhangs, 0.001 to 10; 0.15 if nothing is said"},
    ArgumentRow{"roof", "verge", "metres beyond the gables, 0 to 10; as the overhang if nothing is said"},
    ArgumentRow{"roof", "hips", "the ends that stay hips, whatever the kind says: words, numbers or a list"},
    ArgumentRow{"roof", "ridge", "the edge that the ridge runs along: \"longest\" (if nothing is said), a number, or words for edges"},
    ArgumentRow{"roof", "upper_pitch", "degrees of the upper slopes of mansard (25 if nothing is said), gambrel and saltbox (30)"},
    ArgumentRow{"roof", "break_height", "metres above the walls where the upper slopes begin; 0.4 of the way up if nothing is said"},
    ArgumentRow{"roof", "break_inset", "metres inside the walls where the upper slopes begin; instead of break_height"},
    ArgumentRow{"roof", "clipped", "share of a gable's height, between 0 and 1, that a half_hip leans back or a dutch_hip keeps; 0.4 if nothing is said"},
    ArgumentRow{"roof", "tooth", "metres: width of the teeth of a sawtooth roof, about, 0.5 or more; 6 if nothing is said"},
    ArgumentRow{"roof", "parapet_width", "metres: how thick the parapet is, 0.01 to 10; 0.25 if nothing is said"},
    ArgumentRow{"upright", "kind", "\"flat\" (if nothing is said), \"shed\", \"gable\", \"hip\" or \"eyebrow\""},
    ArgumentRow{"upright", "pitch", "degrees of the dormer's own roof; that of the slope if nothing is said, of a shed a third of its rise"},
    ArgumentRow{"upright", "overhang", "metres of the dormer's roof beyond its walls, 0 to 10; 0 if nothing is said"},
    ArgumentRow{"upright", "thickness", "metres, upright, of the edge of the dormer's roof, 0.001 to 10"},
    ArgumentRow{"insert", "mesh", "the file, .obj or .glb, beside the script or in the style path"},
    ArgumentRow{"insert", "fit", "\"fit\" (if nothing is said) fills the scope, \"keep\" keeps the mesh's size, \"keep_ratio\" its proportions"},
    ArgumentRow{"*", "sides", "how many, 3 to 256; 24 if nothing is said"},
    ArgumentRow{"t", "x", "metres, or 50% of the scope"},
    ArgumentRow{"t", "y", "metres, or 50% of the scope"},
    ArgumentRow{"t", "z", "metres, or 50% of the scope"},
    ArgumentRow{"r", "x", "degrees about the x axis"},
    ArgumentRow{"r", "y", "degrees about the y axis"},
    ArgumentRow{"r", "z", "degrees about the z axis"},
    ArgumentRow{"s", "x", "metres of width, or 50% of what it is"},
    ArgumentRow{"s", "y", "metres of height, or 50% of what it is"},
    ArgumentRow{"s", "z", "metres of depth, or 50% of what it is"},
    ArgumentRow{"pivot", "x", "metres, or 50% of the scope"},
    ArgumentRow{"pivot", "y", "metres, or 50% of the scope"},
    ArgumentRow{"pivot", "z", "metres, or 50% of the scope"},
    ArgumentRow{"center", "axes", "the letters of the axes: \"x\", \"xz\", \"xyz\""},
    ArgumentRow{"mirror", "axis", "\"x\" (if nothing is said), \"y\" or \"z\""},
    ArgumentRow{"align", "to", "\"axes\" (y up), \"world\" or \"geometry\""},
    ArgumentRow{"color", "color", "\"#445566\", \"#456\", or a name of CSS: \"slategray\""},
    ArgumentRow{"stain", "rate", "0, none, to 1: how dark and long the streaks are"},
    ArgumentRow{"texture", "file", "the picture, .png or .jpg, beside the script"},
    ArgumentRow{"texture", "u", "metres across of one repeat, more than 0; 1 if nothing is said"},
    ArgumentRow{"texture", "v", "metres up of one repeat, more than 0; as u if nothing is said"},
    ArgumentRow{"material", "name", "an entry of Materials: BRICK, or \"BRICK\""},
    ArgumentRow{"uv", "across", "repeats across the shape, more than 0; by metres if nothing is said"},
    ArgumentRow{"uv", "up", "repeats up the shape, more than 0"},
    ArgumentRow{"uv", "turn", "degrees against the clock; 0 if nothing is said"},
    ArgumentRow{"best", "score",
                "a number, in which made(...) and reported(...) tell what came of a part"},
    ArgumentRow{"label", "name", "text"},
    ArgumentRow{"occluder", "hides", "true or false, also \"yes\" or \"no\"; true if nothing is said"},
    ArgumentRow{"set", "variable", "its name, without quotes: Tile.Width"},
    ArgumentRow{"set", "value", "what the variable is worth from here on down"},
    ArgumentRow{"report", "key", "text: under which key"},
    ArgumentRow{"report", "value", "a number, which is summed, or a text, which is counted"},
    ArgumentRow{"print", "value", "any number of values"},
    ArgumentRow{"fail", "message", "text: what the error says"},
};

constexpr std::array parts{
    ArgumentRow{"detrude", "inner", "the face, moved in"},
    ArgumentRow{"detrude", "reveal", "each face around the recess, from the wall to the inner face"},
    ArgumentRow{"offset", "inside", "what lies inside of the new outline"},
    ArgumentRow{"offset", "border", "what lies between the two outlines"},
    ArgumentRow{"setback", "kept", "what is left without the strips"},
    ArgumentRow{"setback", "strip", "each strip"},
    ArgumentRow{"*", "shape", "the wings"},
    ArgumentRow{"upright", "rest", "what the rectangle has beside an eyebrow"},
    ArgumentRow{"*", "rest", "what the first part leaves"},
    ArgumentRow{"inner_rectangle", "inside", "the rectangle"},
    ArgumentRow{"cut", "inside", "the figure"},
    ArgumentRow{"cut", "outside", "what the figure leaves"},
    ArgumentRow{"*", "slope", "each sloping face"},
    ArgumentRow{"*", "gable", "each upright face below the roof's ends"},
    ArgumentRow{"roof", "top", "the level face of a flat roof"},
    ArgumentRow{"upright", "top", "the level face of a flat dormer"},
    ArgumentRow{"upright", "front", "the face in which the window stands"},
    ArgumentRow{"upright", "cheek", "the triangles at the sides"},
    ArgumentRow{"*", "soffit", "the underside of an overhang"},
    ArgumentRow{"*", "fascia", "the upright edge of an overhang"},
    ArgumentRow{"roof", "parapet", "the faces of the wall around a flat roof"},
    ArgumentRow{"roof", "lower", "the steep slopes of a kind with two, instead of slope"},
    ArgumentRow{"roof", "upper", "the upper slopes of a kind with two, instead of slope"},
    ArgumentRow{"*", "ridge", "the line along the top"},
    ArgumentRow{"*", "hip", "the line where two slopes meet in an outer corner"},
    ArgumentRow{"*", "valley", "the line where two slopes meet in an inner corner"},
    ArgumentRow{"*", "eave", "the lower edge of a slope"},
    ArgumentRow{"*", "rake", "the edge of a slope along a gable"},
};
// clang-format on

std::string_view find(std::span<const ArgumentRow> rows, std::string_view operation,
                      std::string_view name) {
  const auto it = std::ranges::find_if(rows, [&](const ArgumentRow& row) {
    return row.name == name && (row.operation == "*" || row.operation == operation);
  });
  return it == rows.end() ? std::string_view{} : it->summary;
}

}  // namespace

std::span<const ArgumentRow> argument_rows() { return arguments; }
std::span<const ArgumentRow> part_rows() { return parts; }

std::string_view argument_summary(const Operation& operation, std::string_view name) {
  return find(arguments, operation.name, name);
}
std::string_view part_summary(const Operation& operation, std::string_view name) {
  return find(parts, operation.name, name);
}

}  // namespace mansard
