// Solids and figures in a unit frame, counter-clockwise seen from outside.
#pragma once

#include <string_view>

#include "geometry/mesh.hpp"

namespace mansard {

/// Standing on y = 0 inside size (width x, height y, depth z), `sides` >= 3 around.
Mesh cylinder(Vec3 size, int sides);
Mesh cone(Vec3 size, int sides);
/// `sides` around and half as many from pole to pole.
Mesh sphere(Vec3 size, int sides);
/// The prism over `base` in the ground frame (see below) drawn up to a point `height` above the
/// centroid of its outline; open at the base.
Mesh tapered(const Polygon& base, double height);
/// The prism over `base`: u = x, v runs from z = depth to z = 0 (the ground frame: x along the
/// footprint's first edge, y up, z out of it), with top and bottom faces. Top faces with holes are
/// triangulated.
Mesh prism(const Polygon& base, double depth, double height);

/// A closed figure that fills width x height: "circle" (an ellipse), "arch" (a rectangle under a
/// half ellipse as wide), "segment" (a rectangle under a flat arc with a rise of a fifth of the
/// width, or half of the height if that is less). Empty for another name.
Polygon figure(std::string_view name, double width, double height, int sides = 24);

/// CGA's L, U and O in width x depth: what remains after wings of the given depths are kept along
/// the edges v = 0 (front), u = 0 (left), u = width (right), v = depth (back).
Polygon shape_l(double width, double depth, double front, double left);
Polygon shape_u(double width, double depth, double front, double left, double right);
Polygon shape_o(double width, double depth, double front, double right, double back, double left);

}  // namespace mansard
