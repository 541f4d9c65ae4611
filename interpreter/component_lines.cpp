// The edges and vertices of shapes.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "interpreter/component.hpp"

namespace mansard {
namespace {

/// The parent's attributes with another frame and no surface.
Shape bare(const Shape& parent, Form form, const Scope& scope, EdgeTag tag) {
  Shape piece = parent;
  piece.form = form;
  piece.scope = scope;
  piece.ground = false;
  piece.geometry = piece.uv_frame = Shape::none;
  piece.cuts = piece.open = 0;
  piece.tag = tag;
  return piece;
}

/// Places that are equal to a micrometre.
using Place = std::array<int64_t, 3>;
Place place_of(Vec3 p) {
  return {std::llround(p.x * 1e6), std::llround(p.y * 1e6), std::llround(p.z * 1e6)};
}

struct FaceEdge {
  Vec3 from, to, normal;  ///< in the world; the face's normal
  EdgeTag tag;
};

std::vector<FaceEdge> face_edges(Machine& machine, const Shape& shape) {
  const std::size_t first = machine.scratch_shapes.size();
  push_faces(machine, shape);
  std::vector<FaceEdge> edges;
  for (std::size_t f = first; f < machine.scratch_shapes.size(); ++f) {
    const Shape& face = machine.scratch_shapes[f];
    const Polygon plan = plan_of(machine, face);
    for_each_edge(plan, [&](uint32_t i, Vec2 from, Vec2 to) {
      edges.push_back({face.scope.at({from.x, from.y, 0}), face.scope.at({to.x, to.y, 0}),
                       face.scope.z, plan.tags[i]});
    });
  }
  machine.scratch_shapes.resize(first);
  return edges;
}

/// Of a flat shape y points away from it in its plane, of a solid away from the two faces that
/// meet.
Shape line_along(const Shape& shape, const FaceEdge& edge, Vec3 away) {
  const Vec3 x = normalized(edge.to - edge.from);
  away = away - x * dot(away, x);
  const Vec3 y = length(away) > 1e-9 ? normalized(away) : normalized(cross(edge.normal, x));
  const Vec3 size{length(edge.to - edge.from), 0, 0};
  return bare(shape, Form::line, {edge.from, x, y, cross(x, y), size}, edge.tag);
}

}  // namespace

void push_edges(Machine& machine, const Shape& shape) {
  const bool flat = shape.form == Form::rectangle || shape.form == Form::polygon;
  std::vector<FaceEdge> edges;
  std::vector<Vec3> away;
  std::map<std::pair<Place, Place>, std::size_t> known;
  for (const FaceEdge& edge : face_edges(machine, shape)) {
    const std::pair<Place, Place> ends = std::minmax(place_of(edge.from), place_of(edge.to));
    if (ends.first == ends.second) continue;
    const auto [entry, fresh] = known.try_emplace(ends, edges.size());
    if (fresh) {
      edges.push_back(edge);
      away.emplace_back();
    }
    const Vec3 along = normalized(edge.to - edge.from);
    away[entry->second] = away[entry->second] + (flat ? cross(along, edge.normal) : edge.normal);
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    machine.scratch_shapes.push_back(line_along(shape, edges[i], away[i]));
  }
}

void push_vertices(Machine& machine, const Shape& shape) {
  std::set<Place> known;
  for (const FaceEdge& edge : face_edges(machine, shape)) {
    if (!known.insert(place_of(edge.from)).second) continue;
    Scope frame = shape.scope;
    frame.origin = edge.from;
    frame.size = {};
    machine.scratch_shapes.push_back(bare(shape, Form::nothing, frame, edge.tag));
  }
}

}  // namespace mansard
