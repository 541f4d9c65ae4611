// The ladder of fallbacks: as asked, then coarser polygons, which lose details of centimetres.
#include <algorithm>
#include <array>

#include "geometry/clean.hpp"
#include "geometry/roof.hpp"
#include "geometry/skeleton.hpp"

namespace mansard {
namespace {

// Time grows with the square of the number of points, so each rung has a limit of them.
struct Rung {
  CleanTolerance tolerance;
  double jitter;
  int fallback;
};

constexpr std::array rungs{
    Rung{{1e-4, 1e-4, 1e-3, 2e-6, 0.02, 400}, 1e-6, 1},
    Rung{{0.01, 0.005, 0.05, 1e-4, 0.02, 600}, 1e-5, 2},
    Rung{{0.02, 0.02, 1, 0.005, 0.03, 600}, 1e-5, 3},
    Rung{{0.05, 0.05, 1, 0.01, 0.06, 800}, 1e-5, 3},
    Rung{{0.2, 0.2, 4, 0.02, 0.1, 1200}, 1e-5, 3},
};

}  // namespace

std::optional<SkeletonOn> best_skeleton(const Polygon& polygon) {
  for (const Rung& rung : rungs) {
    std::optional<Cleaned> cleaned = clean(polygon, rung.tolerance);
    if (!cleaned) continue;
    SkeletonOn on{{},
                  std::move(cleaned->polygon),
                  std::move(cleaned->edges),
                  cleaned->moved ? std::max(rung.fallback, 2) : rung.fallback,
                  {}};
    if (auto quad = quad_skeleton(on.polygon)) {
      on.mesh = std::move(quad->mesh);
      on.quad_first = quad->first;
      return on;
    }
    if (auto mesh = checked_skeleton(on.polygon, rung.jitter)) {
      on.mesh = std::move(*mesh);
      return on;
    }
  }
  return std::nullopt;
}

std::optional<Skeleton> straight_skeleton(const Polygon& polygon) {
  const std::optional<SkeletonOn> on = best_skeleton(polygon);
  if (!on) return std::nullopt;
  Skeleton skeleton;
  skeleton.fallback = on->fallback;
  skeleton.faces.resize(polygon.points.size());
  for (std::size_t f = 0; f < on->mesh.faces(); ++f) {
    std::vector<Vec3>& loop = skeleton.faces[on->edges[f]];
    for (const uint32_t i : on->mesh.face(f)) {
      if (loop.empty() || loop.back() != on->mesh.nodes[i]) loop.push_back(on->mesh.nodes[i]);
    }
  }
  return skeleton;
}

}  // namespace mansard
