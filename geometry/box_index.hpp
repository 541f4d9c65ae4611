// Which of many boxes come near a given one: a tree of bounding boxes, split at the median of the
// longest side (Kay & Kajiya 1986; a query visits O(log n + found) nodes).
#pragma once

#include <cstdint>
#include <span>
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

class BoxIndex {
 public:
  /// Keeps its memory from one build to the next.
  void build(std::span<const Box3> boxes);
  /// Numbers of the boxes that meet `box`, ascending, into `found` (cleared first).
  void near(const Box3& box, std::vector<uint32_t>& found) const;

 private:
  struct Node {
    Box3 box;
    uint32_t begin = 0, end = 0;  ///< of a leaf: in order_
    uint32_t right = 0;           ///< 0: a leaf; the left child is the next node
  };
  void add_node(uint32_t begin, uint32_t end);

  std::vector<Box3> boxes_;
  std::vector<uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace mansard
