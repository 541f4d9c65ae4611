#include "interpreter/attribute_table.hpp"

#include <algorithm>
#include <array>

namespace mansard {
namespace {

// clang-format off
constexpr std::array attribute_rows{
    AttributeRow{"W", Attribute::width, "The width of the shape's scope, metres."},
    AttributeRow{"H", Attribute::height, "The height of the shape's scope, metres."},
    AttributeRow{"D", Attribute::depth, "The depth of the shape's scope, metres."},
    AttributeRow{"scope.sx", Attribute::width, "The width of the shape's scope, metres; the same as W."},
    AttributeRow{"scope.sy", Attribute::height, "The height of the shape's scope, metres; the same as H."},
    AttributeRow{"scope.sz", Attribute::depth, "The depth of the shape's scope, metres; the same as D."},
    AttributeRow{"scope.tx", Attribute::tx, "The x of the origin of the scope, metres."},
    AttributeRow{"scope.ty", Attribute::ty, "The y of the origin of the scope, metres."},
    AttributeRow{"scope.tz", Attribute::tz, "The z of the origin of the scope, metres."},
    AttributeRow{"area", Attribute::area, "The area of the geometry, square metres."},
    AttributeRow{"volume", Attribute::volume, "The volume of the geometry, cubic metres."},
    AttributeRow{"perimeter", Attribute::perimeter, "The length of the outline, metres."},
    AttributeRow{"inradius", Attribute::inradius, "The radius of the largest circle inside a flat shape, metres."},
    AttributeRow{"edges", Attribute::edges, "How many edges the shape has."},
    AttributeRow{"is_rectangle", Attribute::is_rectangle, "Whether the shape is a rectangle."},
    AttributeRow{"is_convex", Attribute::is_convex, "Whether the shape's outline is convex."},
    AttributeRow{"is_planar", Attribute::is_planar, "Whether the shape is flat."},
    AttributeRow{"facing", Attribute::facing, "The way the shape looks: degrees from north (0) over east (90)."},
    AttributeRow{"slope", Attribute::slope, "The slope of a face against the horizontal, degrees: walls 90."},
    AttributeRow{"elevation", Attribute::elevation, "The height of the scope above the building's base, metres."},
    AttributeRow{"split.index", Attribute::split_index, "Which part of the last split the shape is, from 0."},
    AttributeRow{"split.count", Attribute::split_count, "How many parts the last split made."},
    AttributeRow{"split.round", Attribute::split_round, "Which repetition of a group of the last split, from 0."},
    AttributeRow{"comp.index", Attribute::comp_index, "Which component of the last comp the shape is, from 0."},
    AttributeRow{"comp.count", Attribute::comp_count, "How many components the last comp made."},
    AttributeRow{"comp.name", Attribute::comp_name, "The selector that chose the shape in the last comp."},
    AttributeRow{"corner.left", Attribute::corner_left, "The angle in degrees, through the building, with the wall at the left end of the facade; 180 inside it."},
    AttributeRow{"corner.right", Attribute::corner_right, "The angle in degrees, through the building, with the wall at the right end of the facade; 180 inside it."},
    AttributeRow{"level", Attribute::level, "The part's number in the nearest split along Y."},
    AttributeRow{"index", Attribute::index, "The index of the shape, which SYMBOL[expr] sets and children inherit."},
    AttributeRow{"symbol", Attribute::symbol, "The symbol of the shape."},
    AttributeRow{"seed", Attribute::seed, "A number in [0, 1) of the shape's own."},
    AttributeRow{"scope.W", Attribute::width, "The width of the shape's scope, metres; the same as W."},
    AttributeRow{"scope.H", Attribute::height, "The height of the shape's scope, metres; the same as H."},
    AttributeRow{"scope.D", Attribute::depth, "The depth of the shape's scope, metres; the same as D."},
    AttributeRow{"scope.x", Attribute::tx, "The x of the origin of the scope, metres."},
    AttributeRow{"scope.y", Attribute::ty, "The y of the origin of the scope, metres."},
    AttributeRow{"scope.z", Attribute::tz, "The z of the origin of the scope, metres."},
};

constexpr std::array input_rows{
    InputRow{"BUILDING_HEIGHT", Input::height, "The property height, less min_height; else 3 m for each of building:levels; else 9."},
    InputRow{"BUILDING_LEVELS", Input::levels, "The property building:levels; else the height / 3, rounded, at least 1."},
    InputRow{"BUILDING_NAME", Input::name, "The property name, else the footprint's id."},
    InputRow{"BUILDING_USE", Input::use, "The property use, else building, else \"yes\"."},
};
// clang-format on

}  // namespace

std::span<const AttributeRow> attributes() { return attribute_rows; }

const AttributeRow* find_attribute(std::string_view name) {
  const auto it = std::ranges::find(attribute_rows, name, &AttributeRow::name);
  return it == attribute_rows.end() ? nullptr : &*it;
}

std::span<const InputRow> inputs() { return input_rows; }

const InputRow* find_input(std::string_view name) {
  const auto it = std::ranges::find(input_rows, name, &InputRow::name);
  return it == input_rows.end() ? nullptr : &*it;
}

}  // namespace mansard
