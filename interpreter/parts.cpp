#include "interpreter/parts.hpp"

#include <algorithm>
#include <bit>

namespace mansard {

void PartKey::add(double number) { add(std::bit_cast<uint64_t>(number)); }

void PartKey::add(Vec3 v) {
  add(v.x);
  add(v.y);
  add(v.z);
}

/// Multiplied and folded word by word (as in Yi's wyhash): keys are short and made for each shape.
uint64_t PartStore::hash_of(const PartKey& key) {
  uint64_t hash = key.count;
  for (const uint64_t word : key.all()) {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15ull;
    hash ^= hash >> 32;
  }
  return hash;
}

const Part* PartStore::find(const PartKey& key) const {
  if (slots_.empty()) return nullptr;
  const uint64_t hash = hash_of(key);
  for (std::size_t at = hash & (slots_.size() - 1); slots_[at] != 0;
       at = (at + 1) & (slots_.size() - 1)) {
    const Part& part = parts_[slots_[at] - 1];
    if (part.hash == hash && std::ranges::equal(slice(keys_, part.key), key.all())) return &part;
  }
  return nullptr;
}

Part& PartStore::add(const PartKey& key) {
  if (2 * (parts_.size() + 1) > slots_.size()) rehash();
  Part& part = parts_.emplace_back();
  part.hash = hash_of(key);
  part.key = {static_cast<uint32_t>(keys_.size()), static_cast<uint32_t>(key.count)};
  keys_.insert(keys_.end(), key.all().begin(), key.all().end());
  std::size_t at = part.hash & (slots_.size() - 1);
  while (slots_[at] != 0) at = (at + 1) & (slots_.size() - 1);
  slots_[at] = static_cast<uint32_t>(parts_.size());
  return part;
}

void PartStore::rehash() {
  slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), 0);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    std::size_t at = parts_[i].hash & (slots_.size() - 1);
    while (slots_[at] != 0) at = (at + 1) & (slots_.size() - 1);
    slots_[at] = static_cast<uint32_t>(i + 1);
  }
}

void PartStore::clear() {
  points.clear();
  uvs.clear();
  ends.clear();
  normals.clear();
  hung.clear();
  runs.clear();
  placed.clear();
  counts.clear();
  keys_.clear();
  parts_.clear();
  std::fill(slots_.begin(), slots_.end(), 0);
}

}  // namespace mansard
