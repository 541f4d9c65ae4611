// Cutting polygons and solids by planes and outlines.
#pragma once

#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/polygon.hpp"

namespace mansard {

/// The part of `polygon` where dot(normal, p) <= offset (normal of unit length), as polygons in a
/// stable order. New edges carry EdgeTag::cut. Points within `tolerance` metres of the line are on
/// it; pieces thinner than that are dropped. Areas of both sides add up to the whole.
std::vector<Polygon> clip(const Polygon& polygon, Vec2 normal, double offset,
                          double tolerance = 1e-9);

/// The part of `polygon` with low <= p.u <= high (axis 0) or low <= p.v <= high (axis 1).
std::vector<Polygon> clip_strip(const Polygon& polygon, int axis, double low, double high,
                                double tolerance = 1e-9);

/// Intersection and difference of any two polygons, exact in topology. Edges keep the tag of the
/// polygon they came from; those of `b` that are new to `a` also carry EdgeTag::cut.
std::vector<Polygon> intersection(const Polygon& a, const Polygon& b);
std::vector<Polygon> difference(const Polygon& a, const Polygon& b);

/// The part of a closed or open solid where dot(normal, p) <= offset, with the cut closed by faces
/// that carry EdgeTag::cut where the solid is closed there. Empty when nothing is left. UVs and
/// materials are kept (a cap has uv 0 and the material of the face beside it).
Mesh clip(const Mesh& mesh, Vec3 normal, double offset, double tolerance = 1e-9);

/// Triangles (point numbers) that cover a polygon with holes exactly; never fails: what can not be
/// triangulated (crossing rings) is covered as well as can be. Adds no points.
std::vector<uint32_t> triangulate(const Polygon& polygon);

/// Triangles of a loop in space, by its own plane: numbers into the loop. A convex loop is a fan.
std::vector<uint32_t> triangulate(std::span<const Vec3> loop);

}  // namespace mansard
