// Which of many boxes come near a given one: a tree of bounding boxes, split at the median of the
// longest side (Kay & Kajiya 1986; a query visits O(log n + found) nodes).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/mesh.hpp"

namespace mansard {

/// Closed boxes: they meet where they only touch.
constexpr bool meet(const Box3& a, const Box3& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}
/// By `by` metres on every side.
constexpr Box3 grown(const Box3& box, double by) {
  return {box.low - Vec3{by, by, by}, box.high + Vec3{by, by, by}};
}

/// Metres between them, 0 where they meet.
inline double distance(const Box3& a, const Box3& b) {
  const auto gap = [](double low_a, double high_a, double low_b, double high_b) {
    return std::max({0.0, low_b - high_a, low_a - high_b});
  };
  return length(Vec3{gap(a.low.x, a.high.x, b.low.x, b.high.x),
                     gap(a.low.y, a.high.y, b.low.y, b.high.y),
                     gap(a.low.z, a.high.z, b.low.z, b.high.z)});
}

class BoxIndex {
 public:
  /// Keeps its memory from one build to the next.
  void build(std::span<const Box3> boxes);
  /// Numbers of the boxes that meet `box`, ascending, into `found` (cleared first).
  void near(const Box3& box, std::vector<uint32_t>& found) const;
  /// The same for the boxes that the line from-to meets.
  void along(Vec3 from, Vec3 to, std::vector<uint32_t>& found) const;
  /// The same for those that the plane dot(normal, p) = at meets; `normal` has length 1.
  void across(Vec3 normal, double at, std::vector<uint32_t>& found) const;
  /// Calls distance(number), which may be a bound from below, for the boxes that may be as near
  /// to `box` as `within` and as all before; returns the least.
  template <class Distance>
  double nearest(const Box3& box, double within, Distance distance) const;

 private:
  struct Node {
    Box3 box;
    uint32_t begin = 0, end = 0;  ///< of a leaf: in order_
    uint32_t right = 0;           ///< 0: a leaf; the left child is the next node
  };
  void add_node(uint32_t begin, uint32_t end);
  template <class Meets>
  void collect(Meets meets, std::vector<uint32_t>& found) const;

  std::vector<Box3> boxes_;
  std::vector<uint32_t> order_;
  std::vector<Node> nodes_;
};

template <class Distance>
double BoxIndex::nearest(const Box3& box, double within, Distance measure) const {
  if (nodes_.empty()) return within;
  struct Open {
    uint32_t node;
    double distance;
  };
  std::array<Open, 64> open;  // halving: never deeper than 32
  std::size_t depth = 0;
  open[depth++] = {0, distance(nodes_[0].box, box)};
  while (depth > 0) {
    const Open at = open[--depth];
    if (at.distance > within) continue;
    const Node& node = nodes_[at.node];
    if (node.right != 0) {
      Open first{at.node + 1, distance(nodes_[at.node + 1].box, box)};
      Open second{node.right, distance(nodes_[node.right].box, box)};
      if (second.distance < first.distance) std::swap(first, second);
      open[depth++] = second;
      open[depth++] = first;
      continue;
    }
    for (uint32_t i = node.begin; i < node.end; ++i) {
      if (distance(boxes_[order_[i]], box) <= within) within = std::min(within, measure(order_[i]));
    }
  }
  return within;
}

}  // namespace mansard
