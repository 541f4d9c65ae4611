// The buildings around, as those that are not derived together see each other: footprints drawn up
// to their height.
#pragma once

#include <string>
#include <vector>

#include "geometry/box_index.hpp"
#include "geometry/occlusion.hpp"
#include "interpreter/footprint.hpp"

namespace mansard {

class Surroundings {
 public:
  /// Footprints without an outline, or with coordinates that are not numbers, are not seen.
  Surroundings(const std::vector<Footprint>& footprints, Streets streets);

  /// Places (in the vector of footprints) of the blocks that meet the box, ascending.
  void near(const Box3& box, std::vector<uint32_t>& found) const { index_.near(box, found); }
  const Prism& block(uint32_t place) const { return blocks_[place]; }
  const BoxIndex& index() const { return index_; }
  /// None where nobody gave any.
  const Streets& streets() const { return streets_; }
  const std::string& id(uint32_t place) const { return ids_[place]; }

 private:
  std::vector<Prism> blocks_;
  std::vector<std::string> ids_;
  BoxIndex index_;
  Streets streets_;
};

}  // namespace mansard
