// The ladder of fallbacks: as asked, then coarser polygons, which lose details of centimetres.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/clean.hpp"
#include "geometry/skeleton.hpp"

namespace mansard {
namespace {

// The first two serve all 86,000 real footprints and variants of the tests; the others are for what
// nobody has seen yet. Exact numbers would come after CGAL's doubles; nothing was found that asks
// for them.
constexpr std::array ways{
    SkeletonWay{SkeletonMaker::closed_form, 0, 0, 0},
    SkeletonWay{SkeletonMaker::wavefront, 1e-8, 1e-5, 1e-7},
    SkeletonWay{SkeletonMaker::wavefront, 1e-8, 1e-5, 0},
    SkeletonWay{SkeletonMaker::wavefront, 1e-7, 1e-6, 0},
    SkeletonWay{SkeletonMaker::cgal, 1e-6, 1e-6, 0},
};
constexpr std::size_t most_for_cgal = 400;  // points, a fifth of a second

// Time grows with the square of the number of points, so there is a limit of them: no footprint
// takes a second, up to the 20,000 points that cleaning takes.
struct Rung {
  double grid;  // metres, in the frame of the longest wall; 0: none
  CleanTolerance tolerance;
  int fallback;
};

constexpr std::array rungs{
    Rung{0, {1e-5, 1e-5, 1e-6, 2e-6, 0.02, 4000}, 1},
    Rung{1e-3, {5e-4, 5e-4, 1e-3, 1e-4, 0.02, 4000}, 2},
    Rung{0, {0.01, 0.005, 0.05, 1e-4, 0.02, 4000}, 3},
    Rung{0, {0.02, 0.02, 1, 0.005, 0.03, 4000}, 3},
    Rung{0, {0.05, 0.05, 1, 0.01, 0.06, 4000}, 3},
    Rung{0, {0.2, 0.2, 4, 0.02, 0.1, 4000}, 3},
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

bool add_skeleton(SkeletonOn& on) {
  for (const SkeletonWay& way : ways) {
    if (way.maker == SkeletonMaker::cgal && on.polygon.points.size() > most_for_cgal) continue;
    auto mesh = checked_skeleton(on.polygon, way);
    if (!mesh) continue;
    on.mesh = std::move(*mesh);
    on.maker = way.maker;
    if (way.maker != SkeletonMaker::closed_form) return true;
    for (uint32_t e = 0; e < 4; ++e) {
      if (on.mesh.face(e).size() == 3 && on.mesh.face(e)[2] == 4) on.quad_first = e;
    }
    return true;
  }
  return false;
}

}  // namespace

std::optional<SkeletonOn> best_skeleton(const Polygon& polygon) {
  for (const Rung& rung : rungs) {
    const bool snaps = rung.grid > 0 && !polygon.empty();
    std::optional<Cleaned> cleaned =
        clean(snaps ? snapped(polygon, rung.grid) : polygon, rung.tolerance);
    if (!cleaned) continue;
    SkeletonOn on;
    on.polygon = std::move(cleaned->polygon);
    on.points = std::move(cleaned->points);
    on.edges = std::move(cleaned->edges);
    on.edge_of = std::move(cleaned->edge_of);
    on.moved = cleaned->moved || snaps;
    on.fallback = on.moved ? std::max(rung.fallback, 2) : rung.fallback;
    if (add_skeleton(on)) return on;
  }
  return std::nullopt;
}

}  // namespace mansard
