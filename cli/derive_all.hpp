// Deriving every footprint on all threads, results in order.
#pragma once

#include <functional>
#include <memory>

#include "cli/report.hpp"
#include "cli/session.hpp"
#include "formats/surface_writer.hpp"
#include "interpreter/building.hpp"

namespace mansard {

/// What came of a footprint. Used again for a later one, so that its memory is.
struct Derived {
  Building building;
  const Footprint* footprint = nullptr;  ///< until the next one
  std::size_t number = 0;                ///< its own
  Footprint room;                        ///< where it may lie
  std::optional<Diagnostic> error;
  // ---- for steps that write or count
  std::unique_ptr<SurfacePiece> piece;
  Faces faces;
};

struct Totals {
  std::size_t buildings = 0, failed = 0;
  bool interrupted = false;
};

/// What is done with a footprint's result, one step after the other. All but `number` may be empty,
/// and see only those that were derived.
struct Steps {
  std::function<void(Derived&)> prepare = {};  ///< on any thread
  std::function<void(Derived&)> number = {};   ///< in order, one at a time; also what failed
  std::function<void(Derived&)> format = {};   ///< on any thread
  std::function<void(Derived&)> append =
      {};  ///< in order, one at a time, while others are numbered
};

/// Takes every footprint through the steps, on so many threads (0: all), at most one a core.
/// Without `keep_going` the first error ends it. Ctrl-C ends it too. The same results in the same
/// order for any number of threads; what a step throws comes out as if there were one thread.
Totals derive_all(const Program& program, MeshSource& meshes, const FootprintSource& footprints,
                  const DeriveOptions& options, int threads, bool keep_going, const Steps& steps);

}  // namespace mansard
