// The buildings around, as those that are not derived together see each other: footprints drawn up
// to their height.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "geometry/box_index.hpp"
#include "geometry/occlusion.hpp"
#include "interpreter/footprint.hpp"

namespace mansard {

/// Drawn up when the first of them is asked for, by whichever thread: most styles do not ask.
class Surroundings {
 public:
  using Take = std::function<void(const Footprint&)>;
  /// `each` hands out all footprints, in order; called once at most. Those without an outline, or
  /// with coordinates that are not numbers, are not seen.
  Surroundings(Streets streets, std::function<void(const Take&)> each);

  /// Places (in the order of footprints) of the blocks that meet the box, ascending.
  void near(const Box3& box, std::vector<uint32_t>& found) const { index().near(box, found); }
  const BoxIndex& index() const;
  /// Of places that near() or index() found.
  const Prism& block(uint32_t place) const { return blocks_[place]; }
  /// None where nobody gave any.
  const Streets& streets() const { return streets_; }
  const std::string& id(uint32_t place) const { return ids_[place]; }

 private:
  void draw_up() const;

  Streets streets_;
  mutable std::function<void(const Take&)> each_;
  mutable std::once_flag drawn_;
  mutable std::vector<Prism> blocks_;
  mutable std::vector<std::string> ids_;
  mutable BoxIndex index_;
};

}  // namespace mansard
