// Ridges, hips, valleys, eaves and rakes as line shapes.
#pragma once

#include <span>
#include <vector>

#include "geometry/roof_lines.hpp"
#include "interpreter/machine.hpp"

namespace mansard {

/// The edges of planar faces, being gathered.
struct FaceBorders {
  std::vector<BorderEdge> edges;
  std::vector<Vec3> normals;
  std::vector<EdgeTag> tags;  ///< one a face

  /// Adds a face: its normal is that of the outline, which comes first.
  void add_face(std::span<const Vec3> outline, EdgeTag tag);
  /// Adds a ring to the newest face.
  void add_ring(std::span<const Vec3> ring);
};

/// Those of the faces that the shape has, in the world. A flat shape is a single face.
FaceBorders borders_of(Machine& machine, const Shape& shape);

/// A line as a shape: x along it, y away from the faces, size W x 0 x 0.
Shape shape_of(const Shape& parent, const RoofLine& line, EdgeTag tag);

/// Gives the lines of these faces, in the world, to the operation's named parts that begin with
/// `first` and stand in the order of RoofLineKind.
void give_lines(Context& c, const FaceBorders& borders, std::size_t first);
/// Whether the rule names one of those parts.
bool wants_lines(const Context& c, std::size_t first);

}  // namespace mansard
