// The operations, one C++ function each. Their signatures are their check.
#pragma once

#include "interpreter/context.hpp"

namespace mansard::operation {

// split.cpp
void subdiv(Context&, Value axis, Sizes sizes, Option<std::string_view> to,
            Option<double> tolerance);
void repeat(Context&, Value axis, double size, std::optional<std::string_view> mode,
            Option<std::string_view> to, Option<double> tolerance);
void split(Context&, Value axis, Option<std::string_view> to, Option<double> tolerance);
// snap.cpp
void snap(Context&, std::string_view planes, std::optional<std::string_view> label);
// component.cpp
void comp(Context&, std::optional<Edges> selector);
// mass.cpp
void extrude(Context&, double height, std::optional<std::string_view> corners);
void detrude(Context&, double depth);
void taper(Context&, double height);
// plan.cpp
void offset(Context&, double distance, std::optional<Edges> edges);
void setback(Context&, double distance, std::optional<Edges> edges);
void chamfer(Context&, double distance, std::optional<Edges> edges);
void shape_l(Context&, double front, double left);
void shape_u(Context&, double front, double left, double right);
void shape_o(Context&, double front, double right, double back, double left);
void inner_rectangle(Context&);
void cut(Context&, std::string_view figure);
// roof.cpp
void roof(Context&, std::string_view kind, std::optional<double> pitch,
          std::optional<double> overhang, std::optional<double> height, std::optional<Edges> gables,
          std::optional<double> parapet, std::optional<double> thickness,
          std::optional<double> verge, std::optional<Edges> hips, std::optional<Edges> ridge,
          std::optional<double> upper_pitch, std::optional<double> break_height,
          std::optional<double> break_inset, std::optional<double> clipped,
          std::optional<double> tooth, std::optional<double> parapet_width);
// upright.cpp
void upright(Context&, std::optional<std::string_view> kind, std::optional<double> pitch,
             std::optional<double> overhang, std::optional<double> thickness);
// insert.cpp
void insert(Context&, std::string_view mesh, std::optional<std::string_view> fit);
/// The mesh in place of the shape, without going on with it.
void put_mesh(Context&, std::string_view mesh, std::optional<std::string_view> fit);
void box(Context&);
void quad(Context&);
void cylinder(Context&, std::optional<double> sides);
void sphere(Context&, std::optional<double> sides);
void cone(Context&, std::optional<double> sides);
// transform.cpp
void t(Context&, Length x, Length y, Length z);
void r(Context&, double x, double y, double z);
void s(Context&, Length x, Length y, Length z);
void center(Context&, std::string_view axes);
void mirror(Context&, std::optional<std::string_view> axis);
void align(Context&, std::string_view to);
void pivot(Context&, Length x, Length y, Length z);
// look.cpp
void color(Context&, std::string_view color);
void texture(Context&, std::string_view file, std::optional<double> u, std::optional<double> v);
void material(Context&, Value name);
void uv(Context&, std::optional<double> across, std::optional<double> up, Option<double> turn);
void stain(Context&, double rate);
// control.cpp
void label(Context&, std::string_view name);
void occluder(Context&, Value hides);
void set(Context&, Setting variable, Value value);
// trial.cpp, in the room above
void best(Context&, Score score);
void report(Context&, std::string_view key, Value value);
void print(Context&, Values values);
void fail(Context&, std::string_view message);

}  // namespace mansard::operation
