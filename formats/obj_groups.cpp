#include "formats/obj_groups.hpp"

namespace mansard {

void ObjGroups::sort(std::span<const Surface::Run> runs) {
  for (const Group& group : groups_) heads_[group.symbol] = none;
  groups_.clear();
  next_run_.assign(runs.size(), none);
  for (uint32_t r = 0; r < runs.size(); ++r) {
    Group& group = groups_[find_or_add(runs[r])];
    if (group.first == none) {
      group.first = r;
    } else {
      next_run_[group.last] = r;
    }
    group.last = r;
  }
}

uint32_t ObjGroups::find_or_add(const Surface::Run& run) {
  if (run.symbol >= heads_.size()) heads_.resize(run.symbol + 1, none);
  uint32_t last = none;
  for (uint32_t g = heads_[run.symbol]; g != none; last = g, g = groups_[g].next) {
    if (groups_[g].material == run.material) return g;
  }
  const auto fresh = static_cast<uint32_t>(groups_.size());
  groups_.push_back({run.symbol, run.material, none, none, none, last == none});
  (last == none ? heads_[run.symbol] : groups_[last].next) = fresh;
  return fresh;
}

}  // namespace mansard
