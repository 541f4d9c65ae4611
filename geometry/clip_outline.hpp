// Cutting solids by the outline of a flat shape.
#pragma once

#include "geometry/mesh.hpp"
#include "geometry/polygon.hpp"

namespace mansard {

/// The part of a solid inside the prism over `outline`, endless along z, closed at the outline by
/// faces that carry EdgeTag::cut where the solid is closed there. The outline may be concave and
/// have holes: then the solid is cut by each of its triangles, and nothing closes what lies between
/// two of them. Empty when nothing is left.
Mesh clip_by_outline(const Mesh& mesh, const Polygon& outline);

/// The part where dot(normal, p) <= offset (normal of unit length), with the cut left open.
Mesh clip_open(const Mesh& mesh, Vec3 normal, double offset, double tolerance = 1e-9);

}  // namespace mansard
