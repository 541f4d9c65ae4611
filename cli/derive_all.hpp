// Deriving every footprint on all threads, results in order.
#pragma once

#include <functional>

#include "cli/session.hpp"
#include "interpreter/building.hpp"

namespace mansard {

/// What came of a footprint.
struct Derived {
  Building building;
  const Footprint* footprint = nullptr;
  std::optional<Diagnostic> error;
};

struct Totals {
  std::size_t buildings = 0, failed = 0;
  bool interrupted = false;
};

/// Calls `use` for every footprint in order, from one thread at a time. Without `keep_going` the
/// first error ends it. Ctrl-C ends it too. The same results in the same order for any number of
/// threads.
Totals derive_all(const Program& program, MeshSource& meshes,
                  const std::vector<Footprint>& footprints, const DeriveOptions& options,
                  int threads, bool keep_going, const std::function<void(Derived&)>& use);

}  // namespace mansard
