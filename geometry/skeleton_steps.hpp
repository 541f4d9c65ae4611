// The steps from a skeleton as it comes to one to build on; all in local coordinates, with the
// polygon's first point near zero.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/skeleton.hpp"

namespace mansard {

/// The corners of faces at each node: the number of the face, and of the node that follows there.
struct Spokes {
  struct Spoke {
    uint32_t face, to;
  };
  std::vector<Spoke> spokes;
  std::vector<uint32_t> ends;  ///< one past the last spoke of each node

  explicit Spokes(const SkeletonMesh& mesh);
  std::span<const Spoke> at(uint32_t node) const {
    const uint32_t begin = node == 0 ? 0 : ends[node - 1];
    return {spokes.data() + begin, spokes.data() + ends[node]};
  }
};

/// A skeleton on its way, its polygon, the lines of the polygon's edges, and the mesh's spokes.
struct Workpiece {
  const Polygon& polygon;
  std::vector<WallLine> lines;
  SkeletonMesh mesh;
  Spokes spokes;
};

/// Moves every node to where the planes of its faces meet, and joins nodes that are then closer
/// than `reach` along an arc. Drops nodes that no face uses.
void settle(Workpiece& piece, double reach);

/// A face for each edge, from its start; closed; planar within 5e-6 m and 1e-3 degrees; no face
/// turned over or across itself; together they cover the polygon within 1e-6 of its area.
bool is_sound(const Workpiece& piece);

}  // namespace mansard
