// Insets, setbacks and other plan figures of polygons.
#pragma once

#include <functional>
#include <vector>

#include "geometry/polygon.hpp"

namespace mansard {

/// What an inset leaves and what it cuts off. `inside` is empty when nothing is left.
struct Inset {
  std::vector<Polygon> inside;
  std::vector<Polygon> border;  ///< strips of the moved edges, in edge order; one may have pieces
};

/// Moves every edge for which `distance(edge)` is positive inwards by that many metres, mitred
/// corners (Kelly & Wonka 2011 §3, without events beyond removal of what is covered). Inside plus
/// border cover the polygon exactly. Edges of `inside` keep the tags of the edges they came from.
Inset setback(const Polygon& polygon, const std::function<double(uint32_t edge)>& distance);

/// Every edge outwards by `distance` metres, mitred up to 4 times the distance, then bevelled.
std::vector<Polygon> outset(const Polygon& polygon, double distance);

/// Cuts off every convex corner both of whose edges are chosen, `distance` metres along each edge
/// (at most half of the shorter one).
Polygon chamfer(const Polygon& polygon, double distance,
                const std::function<bool(uint32_t edge)>& chosen);

/// The largest rectangle with edges along u and v that fits, to within 1 % of the best area;
/// empty polygon when there is none.
Polygon inner_rectangle(const Polygon& polygon);

/// Radius of the largest inscribed circle, within 1 mm or 0.1 %.
double inradius(const Polygon& polygon);

}  // namespace mansard
