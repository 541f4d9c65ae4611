// Party walls of more footprints than memory should hold: some hundred at a time, with all that
// bear upon them.
#include <algorithm>
#include <cmath>
#include <utility>

#include "formats/footprints.hpp"
#include "geometry/box_index.hpp"
#include "interpreter/surroundings.hpp"

namespace mansard {
namespace {

constexpr uint32_t at_a_time = 512;

Box3 box_of(const Polygon& polygon) {
  Box3 box{{1e300, 0, 1e300}, {-1e300, 0, -1e300}};
  for (const Vec2 p : polygon.points) {
    if (!std::isfinite(p.x + p.y)) continue;
    box.low = {std::min(box.low.x, p.x), 0, std::min(box.low.z, p.y)};
    box.high = {std::max(box.high.x, p.x), 0, std::max(box.high.z, p.y)};
  }
  return box;
}

class Marking {
 public:
  Marking(const FootprintStore& store, const Streets& streets)
      : store_(store), streets_(streets), reach_(neighbour_reach(streets)) {
    boxes_.reserve(store.size());
    store.for_each([&](uint32_t, const Footprint& f) { boxes_.push_back(box_of(f.polygon)); });
    index_.build(boxes_);
  }

  FootprintStore marked() {
    FootprintStore all;
    const auto count = static_cast<uint32_t>(boxes_.size());
    for (uint32_t begin = 0; begin < count; begin += at_a_time) {
      mark(begin, std::min(begin + at_a_time, count), all);
    }
    return all;
  }

 private:
  /// Those from `begin` to `end`.
  void mark(uint32_t begin, uint32_t end, FootprintStore& to) {
    find_near(begin, end);
    window_.resize(near_.size());
    wanted_.clear();
    for (std::size_t i = 0; i < near_.size(); ++i) {
      store_.get(near_[i], window_[i]);
      wanted_.push_back(near_[i] >= begin && near_[i] < end);
    }
    mark_walls(window_, wanted_, streets_);
    for (std::size_t i = 0; i < near_.size(); ++i) {
      if (wanted_[i]) to.add(window_[i]);
    }
  }

  /// Them and their neighbours, ascending.
  void find_near(uint32_t begin, uint32_t end) {
    near_.clear();
    for (uint32_t i = begin; i < end; ++i) {
      near_.push_back(i);
      index_.near(grown(boxes_[i], reach_), found_);
      near_.insert(near_.end(), found_.begin(), found_.end());
    }
    std::ranges::sort(near_);
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
  }

  const FootprintStore& store_;
  const Streets& streets_;
  double reach_;
  std::vector<Box3> boxes_;  ///< x east, z north
  BoxIndex index_;
  std::vector<uint32_t> near_, found_;
  std::vector<Footprint> window_;
  std::vector<bool> wanted_;
};

}  // namespace

void mark_neighbours(StoredSet& set, const std::vector<StreetLine>& streets) {
  Streets lines(streets);
  set.footprints = Marking(set.footprints, lines).marked();
  set.footprints.set_around(std::make_shared<const Surroundings>(
      std::move(lines), [all = set.footprints](const Surroundings::Take& take) {
        all.for_each([&](uint32_t, const Footprint& footprint) { take(footprint); });
      }));
}

}  // namespace mansard
