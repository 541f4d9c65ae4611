#include "interpreter/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "interpreter/building_height.hpp"

namespace mansard {
namespace {

bool has_outline(const Polygon& polygon) {
  return polygon.points.size() >= 3 && std::ranges::all_of(polygon.points, [](Vec2 p) {
           return std::isfinite(p.x) && std::isfinite(p.y);
         });
}

/// North is -z.
Prism block_of(const Footprint& footprint) {
  Prism block;
  block.origin = {0, base_of(footprint), 0};
  block.a = {1, 0, 0};
  block.b = {0, 0, -1};
  block.axis = {0, 1, 0};
  block.base = footprint.polygon;
  block.height = height_of(footprint);
  return block;
}

}  // namespace

Surroundings::Surroundings(Streets streets, std::function<void(const Take&)> each)
    : streets_(std::move(streets)), each_(std::move(each)) {}

const BoxIndex& Surroundings::index() const {
  std::call_once(drawn_, [&] { draw_up(); });
  return index_;
}

void Surroundings::draw_up() const {
  constexpr double nowhere = 1e300;  // meets no box
  std::vector<Box3> boxes;
  each_([&](const Footprint& footprint) {
    ids_.push_back(footprint.id);
    if (!has_outline(footprint.polygon)) {
      blocks_.emplace_back();
      boxes.push_back({{nowhere, nowhere, nowhere}, {nowhere, nowhere, nowhere}});
      return;
    }
    const Prism& block = blocks_.emplace_back(block_of(footprint));
    const Box2 plan = bounds(block.base.points);
    const double low = block.origin.y;
    boxes.push_back(
        {{plan.low.x, low, -plan.high.y}, {plan.high.x, low + block.height, -plan.low.y}});
  });
  index_.build(boxes);
  each_ = nullptr;
}

}  // namespace mansard
