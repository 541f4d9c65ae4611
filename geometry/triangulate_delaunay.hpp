// Constrained Delaunay triangulation: the sure way for polygons with holes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/polygon.hpp"

namespace mansard {

/// Triangles (point numbers) of the even-odd inside of the rings; nullopt when edges cross.
std::optional<std::vector<uint32_t>> triangulate_delaunay(const Polygon& polygon);

}  // namespace mansard
