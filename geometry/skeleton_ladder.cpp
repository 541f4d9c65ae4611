// The ladder of fallbacks: as asked, then coarser polygons, which lose details of centimetres.
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/clean.hpp"
#include "geometry/roof.hpp"
#include "geometry/skeleton.hpp"

namespace mansard {
namespace {

// Time grows with the square of the number of points, so each rung has a limit of them.
struct Rung {
  double grid;  // metres, in the frame of the longest wall; 0: none
  CleanTolerance tolerance;
  double jitter;
  int fallback;
};

constexpr std::array rungs{
    Rung{0, {1e-5, 1e-5, 1e-6, 2e-6, 0.02, 400}, 1e-6, 1},
    Rung{1e-3, {5e-4, 5e-4, 1e-3, 1e-4, 0.02, 600}, 1e-5, 2},
    Rung{0, {0.01, 0.005, 0.05, 1e-4, 0.02, 600}, 1e-5, 3},
    Rung{0, {0.02, 0.02, 1, 0.005, 0.03, 600}, 1e-5, 3},
    Rung{0, {0.05, 0.05, 1, 0.01, 0.06, 800}, 1e-5, 3},
    Rung{0, {0.2, 0.2, 4, 0.02, 0.1, 1200}, 1e-5, 3},
};

// Rounds to a grid along the longest wall.
Polygon snapped(const Polygon& polygon, double grid) {
  Vec2 longest;
  for_each_edge(polygon, [&](uint32_t, Vec2 a, Vec2 b) {
    if (length(b - a) > length(longest)) longest = b - a;
  });
  const Vec2 u = normalized(longest), v = left_of(u), origin = polygon.points[0];
  Polygon result = polygon;
  for (Vec2& p : result.points) {
    p = origin + u * (std::round(dot(p - origin, u) / grid) * grid) +
        v * (std::round(dot(p - origin, v) / grid) * grid);
  }
  return result;
}

}  // namespace

std::optional<SkeletonOn> best_skeleton(const Polygon& polygon) {
  for (const Rung& rung : rungs) {
    const bool snaps = rung.grid > 0 && !polygon.empty();
    std::optional<Cleaned> cleaned =
        clean(snaps ? snapped(polygon, rung.grid) : polygon, rung.tolerance);
    if (!cleaned) continue;
    const bool moved = cleaned->moved || snaps;
    SkeletonOn on{{},
                  std::move(cleaned->polygon),
                  std::move(cleaned->points),
                  std::move(cleaned->edges),
                  std::move(cleaned->edge_of),
                  moved,
                  moved ? std::max(rung.fallback, 2) : rung.fallback,
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
