#include <algorithm>
#include <cmath>
#include <queue>

#include "geometry/offset.hpp"

namespace mansard {
namespace {

/// A square of the search, with the largest distance to the border that it can hold.
struct Cell {
  Vec2 centre;
  double half = 0;
  double distance = 0;  ///< from the centre to the border, negative outside
  double most = 0;
};

Vec2 nearest_on(Vec2 p, Vec2 from, Vec2 to) {
  const Vec2 along = to - from;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - from, along) / squared, 0.0, 1.0) : 0;
  return mix(from, to, t);
}

/// Bounds the distance in a square by the border points nearest to its centre: the nearest of all,
/// and the nearest one on the other side of it. In a corridor the two pull against each other, so
/// that the bound is good to second order and the corridor need not be searched finely.
class Searcher {
 public:
  explicit Searcher(const Polygon& polygon) : polygon_(polygon) {}

  Cell cell(Vec2 centre, double half) const {
    Vec2 nearest = centre;
    double least = 1e300;
    bool inside = false;
    for_each_edge(polygon_, [&](uint32_t, Vec2 from, Vec2 to) {
      const Vec2 q = nearest_on(centre, from, to);
      const double squared = dot(q - centre, q - centre);
      if (squared < least) {
        least = squared;
        nearest = q;
      }
      if ((from.y > centre.y) == (to.y > centre.y)) return;
      const double t = (centre.y - from.y) / (to.y - from.y);
      if (centre.x < from.x + (to.x - from.x) * t) inside = !inside;
    });
    const double distance = std::sqrt(least);
    Cell result{centre, half, inside ? distance : -distance, 0};
    result.most = result.distance + half * std::sqrt(2.0);
    if (inside) result.most = std::min(result.most, opposite_bound(centre, half, nearest));
    return result;
  }

 private:
  /// min(|p-a|, |p-b|)^2 <= s |p-a|^2 + (1-s) |p-b|^2 for every s in 0..1 and all p in the square.
  double opposite_bound(Vec2 centre, double half, Vec2 a) const {
    const Vec2 away = centre - a;
    double best = 1e300;
    for_each_edge(polygon_, [&](uint32_t, Vec2 from, Vec2 to) {
      const Vec2 pull = centre - nearest_on(centre, from, to);
      if (dot(pull, away) >= 0) return;
      const Vec2 change = away - pull;
      const double s = std::clamp(dot(Vec2{} - pull, change) / dot(change, change), 0.0, 1.0);
      const Vec2 rest = pull + change * s;
      const double squared = s * dot(away, away) + (1 - s) * dot(pull, pull) +
                             2 * half * (std::abs(rest.x) + std::abs(rest.y)) + 2 * half * half;
      best = std::min(best, squared);
    });
    return std::sqrt(best);
  }

  const Polygon& polygon_;
};

}  // namespace

/// Best-first search of a quadtree (after Agafonkin's polylabel, 2016).
double inradius(const Polygon& polygon) {
  if (polygon.points.size() < 3) return 0;
  constexpr int most_cells = 20000;
  const Box2 box = bounds(polygon.points);
  const double half = std::min(box.size().x, box.size().y) / 2;
  if (!(half > 0)) return 0;

  const Searcher searcher(polygon);
  const auto less = [](const Cell& a, const Cell& b) { return a.most < b.most; };
  std::priority_queue<Cell, std::vector<Cell>, decltype(less)> open(less);
  double best = 0;
  const auto add = [&](Vec2 centre, double size) {
    const Cell cell = searcher.cell(centre, size);
    best = std::max(best, cell.distance);
    open.push(cell);
  };
  const double longest = std::max(box.size().x, box.size().y) / 2;
  const double start = std::max(half, longest / 64);
  for (double u = box.low.x; u < box.high.x; u += 2 * start) {
    for (double v = box.low.y; v < box.high.y; v += 2 * start) add({u + start, v + start}, start);
  }
  for (int cells = 0; !open.empty() && cells < most_cells; ++cells) {
    const Cell cell = open.top();
    open.pop();
    if (cell.most - best <= std::max(1e-3, best * 1e-3) * 0.9) break;
    const double quarter = cell.half / 2;
    for (const Vec2 d : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{1, 1}}) {
      add(cell.centre + d * quarter, quarter);
    }
  }
  return best;
}

}  // namespace mansard
