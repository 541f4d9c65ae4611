// The angles at which walls meet, corner.left and corner.right: in degrees through the building, 90
// at the corner of a box, more than 180 where walls meet in a niche. They are 180 where nothing
// turns: inside a wall, and where the next one is a party wall or was made by a split.
#pragma once

#include <span>

#include "interpreter/machine.hpp"

namespace mansard {

/// From one wall to the next in the plan, counter-clockwise.
double corner_angle(Vec2 along, Vec2 then);

/// Of side 0 to 3 of a box. A relief's front keeps those of the wall that it rose from.
void set_box_corners(Shape& wall, const Shape& box, int side);
/// Of the wall on edge i of a prism's outline, which is stretched along u and v.
void set_prism_corners(Shape& wall, const Polygon& plan, Vec2 stretch, uint32_t i);
/// Of all faces of a solid: `faces` and the loops that they were made of, in world coordinates.
void set_mesh_corners(std::span<Shape> faces, std::span<const std::vector<Vec3>> loops);

}  // namespace mansard
