// Is a derived mass closed, and does it look outwards?
#pragma once

#include <functional>

#include "geometry/mesh.hpp"

namespace mansard::test {

/// Metres of edges that no opposite edges cover (T-junctions are fine: an edge may be covered by
/// several), besides those whose both ends are `ground`.
double open_length(const Surface& surface, const std::function<bool(Vec3)>& ground);

/// By the divergence theorem about a point of the ground plane, so that the ground needs no face.
double volume_above(const Surface& surface, double ground);

}  // namespace mansard::test
