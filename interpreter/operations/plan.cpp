// Figures in the plane of a flat shape: insets, setbacks, wings, openings.
#include <algorithm>

#include "geometry/clip.hpp"
#include "geometry/offset.hpp"
#include "geometry/solids.hpp"
#include "interpreter/component.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"
#include "interpreter/selectors.hpp"

namespace mansard {
namespace {

Polygon plan_of(Context& c) {
  if (c.shape.form != Form::rectangle && c.shape.form != Form::polygon) {
    c.machine.fail(c.call.at, "'" + std::string(c.call.operation->name) + "' needs a flat shape",
                   "take a face first: comp { top : A }");
  }
  return mansard::plan_of(c.machine, c.shape);
}

void give(Context& c, std::size_t part, std::vector<Polygon> pieces) {
  if (!c.wants(part)) return;
  for (Polygon& polygon : pieces) {
    if (polygon.empty()) continue;
    Shape piece = c.shape;
    piece.form = Form::polygon;
    c.machine.adopt(piece, std::move(polygon));
    c.named_part(part, piece);
  }
}

std::function<bool(uint32_t)> predicate(std::vector<bool> chosen) {
  return
      [chosen = std::move(chosen)](uint32_t edge) { return edge < chosen.size() && chosen[edge]; };
}

std::vector<bool> edges_or_all(Context& c, const std::optional<Edges>& edges, const Polygon& plan) {
  if (!edges) return std::vector<bool>(plan.points.size(), true);
  return chosen_edges(c, 1, *edges, plan);
}

Inset moved_in(Context& c, double distance, const std::optional<Edges>& edges,
               const Polygon& plan) {
  const auto chosen = edges_or_all(c, edges, plan);
  return setback(
      plan, [&](uint32_t edge) { return edge < chosen.size() && chosen[edge] ? distance : 0.0; });
}

void not_negative(Context& c, double distance) {
  if (distance < 0) c.fail(0, "the distance can not be negative, it is " + number_text(distance));
}

}  // namespace

namespace operation {

/// d > 0 inwards; d < 0 outwards, where there is no border.
void offset(Context& c, double distance, std::optional<Edges> edges) {
  const Polygon plan = plan_of(c);
  if (distance < 0) {
    if (edges) c.fail(1, "edges can be chosen only where the distance is positive");
    return give(c, 0, outset(plan, -distance));
  }
  Inset inset = moved_in(c, distance, edges, plan);
  give(c, 0, inset.inside);
  if (!c.wants(1)) return;
  std::vector<Polygon> border{plan};
  for (const Polygon& inside : inset.inside) {
    std::vector<Polygon> rest;
    for (const Polygon& piece : border) {
      for (Polygon& part : mansard::difference(piece, inside)) rest.push_back(std::move(part));
    }
    border = std::move(rest);
  }
  give(c, 1, std::move(border));
}

void setback(Context& c, double distance, std::optional<Edges> edges) {
  not_negative(c, distance);
  Inset inset = moved_in(c, distance, edges, plan_of(c));
  give(c, 0, std::move(inset.inside));
  give(c, 1, std::move(inset.border));
}

void chamfer(Context& c, double distance, std::optional<Edges> edges) {
  not_negative(c, distance);
  const Polygon plan = plan_of(c);
  Shape piece = c.shape;
  piece.form = Form::polygon;
  c.machine.adopt(piece, mansard::chamfer(plan, distance, predicate(edges_or_all(c, edges, plan))));
  c.become(piece);
}

}  // namespace operation

namespace {

/// Figure and rest of the shape.
void divide(Context& c, const Polygon& figure) {
  const Polygon plan = plan_of(c);
  give(c, 0, intersection(plan, figure));
  if (c.wants(1)) give(c, 1, difference(plan, figure));
}

Vec2 plan_size(Context& c) {
  const Vec3 size = c.shape.scope.size;
  return {size.x, c.shape.ground ? size.z : size.y};
}

}  // namespace

namespace operation {

void shape_l(Context& c, double front, double left) {
  const Vec2 size = plan_size(c);
  divide(c, mansard::shape_l(size.x, size.y, front, left));
}

void shape_u(Context& c, double front, double left, double right) {
  const Vec2 size = plan_size(c);
  divide(c, mansard::shape_u(size.x, size.y, front, left, right));
}

void shape_o(Context& c, double front, double right, double back, double left) {
  const Vec2 size = plan_size(c);
  divide(c, mansard::shape_o(size.x, size.y, front, right, back, left));
}

void inner_rectangle(Context& c) {
  const Polygon plan = plan_of(c);
  const Polygon inside = mansard::inner_rectangle(plan);
  if (inside.empty()) return give(c, 1, {plan});
  give(c, 0, {inside});
  if (c.wants(1)) give(c, 1, difference(plan, inside));
}

void cut(Context& c, std::string_view name) {
  const Vec2 size = plan_size(c);
  const Polygon outline = figure(name, size.x, size.y);
  if (outline.empty()) {
    c.fail(0, "\"" + std::string(name) + "\" is no figure to cut",
           "\"arch\", \"circle\" or \"segment\"");
  }
  divide(c, outline);
}

}  // namespace operation
}  // namespace mansard
