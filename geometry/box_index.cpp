#include "geometry/box_index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace mansard {
namespace {

constexpr uint32_t most_in_leaf = 4;

Box3 around(const Box3& a, const Box3& b) {
  return {
      {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
      {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

double middle(const Box3& box, int axis) {
  const Vec3 sum = box.low + box.high;
  return axis == 0 ? sum.x : axis == 1 ? sum.y : sum.z;
}

int longest_side(const Box3& box) {
  const Vec3 size = box.size();
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

}  // namespace

void BoxIndex::build(std::span<const Box3> boxes) {
  boxes_.assign(boxes.begin(), boxes.end());
  order_.resize(boxes_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.clear();
  if (!order_.empty()) add_node(0, static_cast<uint32_t>(order_.size()));
}

void BoxIndex::add_node(uint32_t begin, uint32_t end) {
  const auto number = static_cast<uint32_t>(nodes_.size());
  Node node;
  node.begin = begin;
  node.end = end;
  node.box = boxes_[order_[begin]];
  for (uint32_t i = begin + 1; i < end; ++i) node.box = around(node.box, boxes_[order_[i]]);
  nodes_.push_back(node);
  if (end - begin <= most_in_leaf) return;
  const uint32_t half = begin + (end - begin) / 2;
  const int axis = longest_side(node.box);
  std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                   [&](uint32_t a, uint32_t b) {
                     const double at = middle(boxes_[a], axis), other = middle(boxes_[b], axis);
                     return at != other ? at < other : a < b;
                   });
  add_node(begin, half);
  nodes_[number].right = static_cast<uint32_t>(nodes_.size());
  add_node(half, end);
}

template <class Meets>
void BoxIndex::collect(Meets meets, std::vector<uint32_t>& found) const {
  found.clear();
  if (nodes_.empty()) return;
  std::array<uint32_t, 64> open;  // halving: never deeper than 32
  std::size_t depth = 0;
  open[depth++] = 0;
  while (depth > 0) {
    const uint32_t number = open[--depth];
    const Node& node = nodes_[number];
    if (!meets(node.box)) continue;
    if (node.right != 0) {
      open[depth++] = node.right;
      open[depth++] = number + 1;
      continue;
    }
    for (uint32_t i = node.begin; i < node.end; ++i) {
      if (meets(boxes_[order_[i]])) found.push_back(order_[i]);
    }
  }
  std::sort(found.begin(), found.end());
}

void BoxIndex::near(const Box3& box, std::vector<uint32_t>& found) const {
  collect([&](const Box3& other) { return meet(other, box); }, found);
}

/// Slab by slab (Kay & Kajiya 1986).
void BoxIndex::along(Vec3 from, Vec3 to, std::vector<uint32_t>& found) const {
  const Vec3 way = to - from;
  collect(
      [&](const Box3& box) {
        double enters = 0, leaves = 1;
        const auto slab = [&](double low, double high, double start, double by) {
          if (by == 0) {
            if (start < low || start > high) leaves = -1;
            return;
          }
          const double a = (low - start) / by, b = (high - start) / by;
          enters = std::max(enters, std::min(a, b));
          leaves = std::min(leaves, std::max(a, b));
        };
        slab(box.low.x, box.high.x, from.x, way.x);
        slab(box.low.y, box.high.y, from.y, way.y);
        slab(box.low.z, box.high.z, from.z, way.z);
        return enters <= leaves;
      },
      found);
}

void BoxIndex::across(Vec3 normal, double at, std::vector<uint32_t>& found) const {
  collect(
      [&](const Box3& box) {
        const Vec3 middle = (box.low + box.high) * 0.5, half = box.size() * 0.5;
        const double reach =
            std::abs(normal.x) * half.x + std::abs(normal.y) * half.y + std::abs(normal.z) * half.z;
        return std::abs(dot(normal, middle) - at) <= reach + 1e-9;
      },
      found);
}

}  // namespace mansard
