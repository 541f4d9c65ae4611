// Derives a building from a footprint.
#pragma once

#include <memory>

#include "interpreter/building.hpp"
#include "interpreter/footprint.hpp"
#include "interpreter/program.hpp"

namespace mansard {

struct DeriveOptions {
  uint64_t seed = 0;
  int lod = 3;                         ///< 1 to 3
  uint32_t max_depth = 1000;           ///< of the shape tree
  std::size_t max_shapes = 5'000'000;  ///< a building
  bool strict = false;                 ///< no candidate production is an error
  bool keep_tree = false;
  bool share_parts = true;  ///< false: nothing is copied; slower, and the same to the last bit
};

/// One a thread; keeps its pools from building to building, so that after the first few nothing is
/// allocated. The program and the mesh source must outlive it.
class Derivation {
 public:
  Derivation(const Program& program, MeshSource& meshes, const DeriveOptions& options);
  ~Derivation();

  /// Fills `building` (cleared first). Throws Failure for what the script or footprint has wrong;
  /// the building is then empty but for its warnings.
  void derive(const Footprint& footprint, Building& building);

 private:
  friend class Machine;
  std::unique_ptr<class Machine> machine_;
};

}  // namespace mansard
