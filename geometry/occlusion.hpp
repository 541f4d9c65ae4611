// How far a face is covered by solids: their cross-sections with a plane just before it, laid on
// it.
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/scope.hpp"

namespace mansard {

/// A base drawn along an axis: u and v of the base run along `a` and `b`; a, b and axis are
/// orthonormal, of either handedness. Metres, in the world.
struct Prism {
  Vec3 origin, a, b, axis;
  Polygon base;
  double height = 0;
};

/// The cross-section of a solid with the plane z = `above` of the frame, in x and y of the frame,
/// outlines counter-clockwise. Empty where the plane misses it. A mesh has world coordinates; one
/// that is open where the plane meets it has no section there.
std::vector<Polygon> section(const Prism& prism, const Scope& frame, double above);
std::vector<Polygon> section(const Mesh& mesh, const Scope& frame, double above);

/// What a closed mesh fills between z = low and z = high of the frame, seen along z, and all within
/// `beside` metres of that (mitred at corners).
std::vector<Polygon> shadow(const Mesh& mesh, const Scope& frame, double low, double high,
                            double beside);
Mesh to_mesh(const Prism& prism);

enum class Cover : uint8_t { nothing, part, full };

/// How much of the face the pieces cover together. What is thinner than `tolerance` metres, or than
/// a tenth of a face that is itself hardly thicker, counts neither as covered nor as free.
Cover covered(const Polygon& face, std::span<const Polygon> by, double tolerance);

/// Twice the area by the perimeter: the width of a long strip, half that of a square.
double thickness(const Polygon& polygon);

}  // namespace mansard
