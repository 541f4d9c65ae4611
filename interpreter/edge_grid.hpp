// Which edges of many footprints come near a line: a hashed grid of square cells.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/polygon.hpp"

namespace mansard {

struct GridEdge {
  Vec2 from, to;
  uint32_t footprint = 0;
};

class EdgeGrid {
 public:
  /// Finds edges within `reach` metres of a segment, besides some that are farther away.
  EdgeGrid(std::vector<GridEdge> edges, double reach) : edges_(std::move(edges)), reach_(reach) {
    if (edges_.empty()) return;
    std::vector<double> lengths;
    for (const GridEdge& e : edges_) lengths.push_back(length(e.to - e.from));
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    cell_ = std::max({*middle, 4 * reach, 1e-3});
    for (uint32_t i = 0; i < edges_.size(); ++i) {
      const GridEdge& e = edges_[i];
      if (!walkable(e.from, e.to)) {
        long_.push_back(i);
        continue;
      }
      walk(e.from, e.to, reach_, [&](uint64_t key) { entries_.emplace_back(key, i); });
    }
    std::sort(entries_.begin(), entries_.end());
  }

  const GridEdge& edge(uint32_t i) const { return edges_[i]; }

  /// Numbers of the edges near the segment, ascending, into `found` (cleared first).
  void near(Vec2 from, Vec2 to, std::vector<uint32_t>& found) const {
    found.clear();
    if (!walkable(from, to)) {
      for (uint32_t i = 0; i < edges_.size(); ++i) found.push_back(i);
      return;
    }
    found = long_;
    walk(from, to, 0, [&](uint64_t key) {
      auto entry = std::lower_bound(entries_.begin(), entries_.end(), std::pair{key, 0u});
      for (; entry != entries_.end() && entry->first == key; ++entry) {
        found.push_back(entry->second);
      }
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }

 private:
  // Few edges are long beside the median one; they are kept apart, as are those too far away for
  // the numbers of cells.
  bool walkable(Vec2 a, Vec2 b) const {
    const double far = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
    return far < 1e9 * cell_ && length(b - a) < 256 * cell_;
  }
  static uint64_t key(int64_t x, int64_t y) {
    return static_cast<uint64_t>(x) << 32 | (static_cast<uint64_t>(y) & 0xffffffffu);
  }
  int64_t cell(double x) const { return static_cast<int64_t>(std::floor(x / cell_)); }

  // Every cell within `reach` of the segment, column by column.
  template <class F>
  void walk(Vec2 a, Vec2 b, double reach, F f) const {
    if (a.x > b.x) std::swap(a, b);
    const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
    for (int64_t x = cell(a.x - reach), last = cell(b.x + reach); x <= last; ++x) {
      const double left = std::clamp(static_cast<double>(x) * cell_ - reach, a.x, b.x);
      const double right = std::clamp(static_cast<double>(x + 1) * cell_ + reach, a.x, b.x);
      double y1 = a.y + (left - a.x) * slope, y2 = a.y + (right - a.x) * slope;
      if (b.x == a.x) y2 = b.y;
      const int64_t top = cell(std::max(y1, y2) + reach);
      for (int64_t y = cell(std::min(y1, y2) - reach); y <= top; ++y) f(key(x, y));
    }
  }

  std::vector<GridEdge> edges_;
  double reach_ = 0, cell_ = 1;
  std::vector<std::pair<uint64_t, uint32_t>> entries_;  // cell and edge, sorted
  std::vector<uint32_t> long_;
};

}  // namespace mansard
