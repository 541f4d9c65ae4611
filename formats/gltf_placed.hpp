// Meshes that stand in many places, for glTF: each is written once, and placed by nodes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/mesh.hpp"

namespace mansard {

/// Where a node stands, as glTF has it: p comes to lie at translation + rotation (scale p).
struct GltfPlace {
  Vec3 translation;
  std::array<double, 4> rotation{};  ///< unit quaternion x, y, z, w
  Vec3 scale;
};

GltfPlace place_of(const Surface::Placed& placed, Vec3 origin);

/// Whether it is worth a node of its own: smaller ones take less room as polygons.
bool is_shared(const Surface::Placed& placed);

/// Polygons of a placed mesh in the mesh's own frame, with their runs.
Surface own_frame(const Surface& surface, const Surface::Placed& placed);

/// Numbers of the meshes that were written, by what they look like.
class GltfShared {
 public:
  /// None before set(); the next set() is for the same.
  std::optional<uint64_t> find(const Surface& surface, const Surface::Placed& placed);
  void set(uint64_t mesh) { known_->second = mesh; }

 private:
  using Key = std::pair<const Mesh*, std::vector<uint32_t>>;  ///< material and end of each run
  std::map<Key, std::optional<uint64_t>> all_;
  std::map<Key, std::optional<uint64_t>>::iterator known_;
  Key key_;
};

}  // namespace mansard
