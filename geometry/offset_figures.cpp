#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/offset.hpp"

namespace mansard {
namespace {

/// How near a boundary may come to a rectangle's inside, in metres.
constexpr double touching = 1e-9;

struct Span {
  double low = 0, high = 0;
  double size() const { return high - low; }
};

struct Best {
  Span u, v;
  double area = 0;
};

/// Tries rectangles between two verticals: each fills the highest gap between the parts of the
/// border that cross the strip.
class RectangleSearch {
 public:
  explicit RectangleSearch(const Polygon& polygon)
      : polygon_(polygon), box_(bounds(polygon.points)) {}

  Best run() {
    const std::vector<double> us = candidates();
    std::vector<Best> found;
    for (std::size_t i = 0; i < us.size(); ++i) {
      for (std::size_t j = i + 1; j < us.size(); ++j) {
        const Best tried = try_strip({us[i], us[j]}, least_of(found));
        if (tried.area > 0) keep(found, tried);
      }
    }
    Best best;
    for (const Best& start : found) {
      const Best refined = refine(start, box_.size().x / 16);
      if (refined.area > best.area) best = refined;
    }
    return best;
  }

 private:
  static constexpr std::size_t most_starts = 6;

  /// Verticals at the corners (exact for right-angled plans) and evenly between.
  std::vector<double> candidates() const {
    std::vector<double> us;
    const bool few = polygon_.points.size() <= 32;
    if (few) {
      for (const Vec2 p : polygon_.points) us.push_back(p.x);
    }
    const int steps = few ? 24 : 48;
    for (int i = 0; i <= steps; ++i) us.push_back(box_.low.x + box_.size().x * i / steps);
    std::sort(us.begin(), us.end());
    us.erase(
        std::unique(us.begin(), us.end(), [](double a, double b) { return b - a <= touching; }),
        us.end());
    return us;
  }

  static double least_of(const std::vector<Best>& found) {
    return found.size() < most_starts ? 0 : found.back().area;
  }

  static void keep(std::vector<Best>& found, const Best& tried) {
    const auto place = std::find_if(found.begin(), found.end(),
                                    [&](const Best& b) { return b.area < tried.area; });
    found.insert(place, tried);
    if (found.size() > most_starts) found.pop_back();
  }

  /// The largest rectangle in the strip, if it is larger than `least`.
  Best try_strip(Span u, double least) {
    Best best;
    if (u.size() <= touching || u.size() * box_.size().y <= least) return best;
    block(u);
    double covered = box_.low.y;
    for (const Span& blocked : blocked_) {
      const Span gap{covered, blocked.low};
      covered = std::max(covered, blocked.high);
      const double area = gap.size() * u.size();
      if (gap.size() <= touching || area <= std::max(least, best.area)) continue;
      if (!contains(polygon_, {(u.low + u.high) / 2, (gap.low + gap.high) / 2})) continue;
      best = {u, gap, area};
    }
    return best;
  }

  /// Heights at which the border runs through the open strip, from the lowest.
  void block(Span u) {
    blocked_.clear();
    for_each_edge(polygon_, [&](uint32_t, Vec2 from, Vec2 to) {
      if (from.x > to.x) std::swap(from, to);
      if (to.x <= u.low + touching || from.x >= u.high - touching) return;
      const double run = to.x - from.x;
      const auto height = [&](double at) {
        const double t = run > 0 ? std::clamp((at - from.x) / run, 0.0, 1.0) : 0;
        return from.y + (to.y - from.y) * t;
      };
      double a = height(u.low), b = height(u.high);
      if (run <= touching) a = from.y, b = to.y;
      blocked_.push_back({std::min(a, b), std::max(a, b)});
    });
    std::sort(blocked_.begin(), blocked_.end(),
              [](const Span& a, const Span& b) { return a.low < b.low; });
  }

  /// Moves the two verticals, alone and together, by smaller and smaller steps.
  Best refine(Best best, double step) {
    while (step > box_.size().x * 1e-5) {
      Best better = best;
      for (const auto& [a, b] :
           {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}) {
        const Span u{std::max(best.u.low + a * step, box_.low.x),
                     std::min(best.u.high + b * step, box_.high.x)};
        const Best tried = try_strip(u, better.area);
        if (tried.area > better.area) better = tried;
      }
      if (better.area > best.area * (1 + 1e-6)) {
        best = better;
      } else {
        step /= 2;
      }
    }
    return best;
  }

  const Polygon& polygon_;
  Box2 box_;
  std::vector<Span> blocked_;
};

/// The tag of an edge that cuts a corner: of the wall before it, with what both walls have in
/// common.
EdgeTag corner_tag(EdgeTag before, EdgeTag after) {
  return {static_cast<uint16_t>(before.flags & after.flags & ~EdgeTag::main), before.wall};
}

}  // namespace

Polygon chamfer(const Polygon& polygon, double distance,
                const std::function<bool(uint32_t edge)>& chosen) {
  if (!(distance > 0)) return polygon;
  Polygon result;
  const auto add = [&](Vec2 p, EdgeTag tag) {
    const uint32_t begin = result.ring_ends.empty() ? 0 : result.ring_ends.back();
    // Two cuts that meet in the middle of an edge leave nothing of it.
    if (result.points.size() > begin && length(p - result.points.back()) <= touching) {
      result.tags.back() = tag;
    } else {
      result.add_point(p, tag);
    }
  };
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const auto ring = polygon.ring(r);
    const uint32_t begin = polygon.ring_begin(r);
    const auto n = static_cast<uint32_t>(ring.size());
    for (uint32_t i = 0; i < n; ++i) {
      const uint32_t before = (i + n - 1) % n;
      const Vec2 in = ring[i] - ring[before], out = ring[(i + 1) % n] - ring[i];
      const EdgeTag tag = polygon.tags[begin + i];
      const double scale = length(in) * length(out);
      if (cross(in, out) <= 1e-9 * scale || !chosen(begin + before) || !chosen(begin + i)) {
        add(ring[i], tag);
        continue;
      }
      const double cut = std::min({distance, length(in) / 2, length(out) / 2});
      add(ring[i] - normalized(in) * cut, corner_tag(polygon.tags[begin + before], tag));
      add(ring[i] + normalized(out) * cut, tag);
    }
    const std::size_t first = result.ring_ends.empty() ? 0 : result.ring_ends.back();
    while (result.points.size() > first + 1 &&
           length(result.points.back() - result.points[first]) <= touching) {
      result.points.pop_back();
      result.tags.pop_back();
    }
    result.close_ring();
  }
  return result;
}

Polygon inner_rectangle(const Polygon& polygon) {
  if (polygon.points.size() < 3) return {};
  const Best best = RectangleSearch(polygon).run();
  if (!(best.area > 0)) return {};
  Polygon result = rectangle(best.u.size(), best.v.size());
  const Vec2 low{best.u.low, best.v.low}, high{best.u.high, best.v.high};
  result.points = {low, {high.x, low.y}, high, {low.x, high.y}};
  return result;
}

}  // namespace mansard
