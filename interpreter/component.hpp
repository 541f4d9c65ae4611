// The faces, edges and vertices of shapes, each as a shape with its own frame: x along its first
// (lowest) edge, y up the face, z its outward normal.
#pragma once

#include <span>

#include "interpreter/machine.hpp"
#include "interpreter/outline.hpp"

namespace mansard {

/// Side 0 to 5 (front, right, back, left, top, bottom) of a box: its frame, and it as a rectangle.
Scope box_side_scope(const Scope& box, int side);
Shape box_side(const Shape& box, int side);

/// The side of a prism from which it was drawn.
inline uint8_t prism_base(const Shape& prism) { return prism.ground ? side_bottom : side_back; }
/// Height of a prism along the direction it was drawn.
double prism_height(const Shape& prism);
uint32_t prism_walls(const Machine& machine, const Shape& prism);
/// Wall i stands on edge i of the polygon.
Shape prism_wall(Machine& machine, const Shape& prism, uint32_t i);

/// The flat shape lying on the ground as a face that looks up: x stays, y runs into the depth.
Shape lying_face(const Shape& flat);
/// The face that looks up as a flat shape on the ground (the frame of footprints), and back.
Shape standing_ground(const Shape& face);

/// A planar loop in world coordinates (counter-clockwise from outside), with holes, as a shape.
/// `edges` are the tags of its edges, ring by ring; empty: they are as the face's.
Shape face_of(Machine& machine, const Shape& parent, std::span<const Vec3> loop,
              std::span<const std::vector<Vec3>> holes, EdgeTag tag,
              std::span<const EdgeTag> edges = {});

/// Pushes every face that is a surface onto machine.scratch_shapes.
void push_faces(Machine& machine, const Shape& shape);
/// Pushes every edge (a line shape, y away from the face) or vertex (a frame).
void push_edges(Machine& machine, const Shape& shape);
void push_vertices(Machine& machine, const Shape& shape);

}  // namespace mansard
