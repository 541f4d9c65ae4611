// Meshes that stand in many places, for glTF: each is written once, and placed by nodes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "formats/surface_writer.hpp"
#include "geometry/mesh.hpp"

namespace mansard {

/// Where a node stands, as glTF has it: p comes to lie at translation + rotation (scale p).
struct GltfPlace {
  Vec3 translation;
  std::array<double, 4> rotation{};  ///< unit quaternion x, y, z, w
  Vec3 scale;
};

GltfPlace place_of(const Surface::Placed& placed, Vec3 origin);

/// What of a building may be shared, and a hash of the polygons where the mesh is of no file.
struct GltfSharable {
  using Hash = std::array<uint64_t, 2>;
  uint32_t placed = 0;  ///< its number among the surface's
  Hash hash{};
};

/// A mesh that is shared.
struct GltfMesh {
  bool claimed = false;            ///< a building brings it; of number()
  std::optional<uint64_t> number;  ///< in the file; of append()
};

/// Shared meshes by what they look like.
class GltfShared {
 public:
  explicit GltfShared(Instancing instancing) : instancing_(instancing) {}

  /// What is large enough to make sharing worth it. On any thread.
  void find_sharable(const Surface& surface, std::vector<GltfSharable>& sharable) const;
  /// Chooses what of it is written as a shared mesh: meshes of files, and solids that come twice in
  /// the building or that other buildings shared. A mesh, or null, by placed number.
  void find(const Surface& surface, std::span<const GltfSharable> sharable,
            std::vector<GltfMesh*>& meshes);

 private:
  /// The file's mesh, or the hash; material and end of each run.
  using Key = std::tuple<const Mesh*, GltfSharable::Hash, std::vector<uint32_t>>;

  bool is_worth_it(const Surface::Placed& placed) const;
  void set_key(const Surface& surface, const GltfSharable& sharable);

  Instancing instancing_;
  std::map<Key, GltfMesh> all_;
  std::map<Key, std::size_t> once_;  ///< solids of the building that came once so far
  Key key_;
};

/// Polygons of a placed mesh in the mesh's own frame, with their runs.
Surface own_frame(const Surface& surface, const Surface::Placed& placed);

}  // namespace mansard
