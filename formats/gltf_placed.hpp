// Meshes that stand in many places, for glTF: each is written once, and placed by nodes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
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

/// Numbers of the meshes that were written, by what they look like.
class GltfShared {
 public:
  explicit GltfShared(Instancing instancing) : instancing_(instancing) {}

  /// Chooses what of the building is written as a shared mesh: meshes of files, and solids that
  /// come twice in it or that other buildings shared; all as large as makes sharing worth it.
  void find(const Surface& surface);
  /// Whether the building's placed mesh of this number is shared.
  bool is_shared(std::size_t number) const { return kinds_[number] != nullptr; }
  /// Its mesh; none before set_mesh().
  std::optional<uint64_t> mesh(std::size_t number) const { return *kinds_[number]; }
  void set_mesh(std::size_t number, uint64_t mesh) { *kinds_[number] = mesh; }

 private:
  using Hash = std::array<uint64_t, 2>;
  /// The file's mesh, or a hash of the polygons in their own frame; material and end of each run.
  using Key = std::tuple<const Mesh*, Hash, std::vector<uint32_t>>;

  bool is_worth_it(const Surface::Placed& placed) const;
  void set_key(const Surface& surface, const Surface::Placed& placed);

  Instancing instancing_;
  std::map<Key, std::optional<uint64_t>> all_;
  std::vector<std::optional<uint64_t>*> kinds_;  ///< of the building's placed meshes, into all_
  std::map<Key, std::size_t> once_;              ///< solids of the building that came once so far
  Key key_;
};

/// Polygons of a placed mesh in the mesh's own frame, with their runs.
Surface own_frame(const Surface& surface, const Surface::Placed& placed);

}  // namespace mansard
