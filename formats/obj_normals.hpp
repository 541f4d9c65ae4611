// The normals of one building in an OBJ, equal ones once.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vector.hpp"

namespace mansard {

/// A small table without chains: a normal that was pushed out is written again, which costs bytes
/// only.
class ObjNormals {
 public:
  void find(std::span<const Vec3> normals) {
    ++age_;
    count_ = 0;
    numbers_.clear();
    for (const Vec3& n : normals) {
      Slot& slot = slots_[hash(n) % slots_.size()];
      if (slot.age != age_ || slot.normal != n) slot = {n, count_++, age_};
      numbers_.push_back(slot.number);
    }
  }

  /// Of each polygon's normal, from 0; a new number is one more than the last new one.
  std::span<const uint32_t> numbers() const { return numbers_; }
  uint32_t count() const { return count_; }

 private:
  struct Slot {
    Vec3 normal;
    uint32_t number = 0, age = 0;
  };
  static uint64_t hash(const Vec3& n) {
    // + 0.0 makes -0 the same as 0.
    const uint64_t h = std::bit_cast<uint64_t>(n.x + 0.0) * 0x9e3779b97f4a7c15 +
                       std::bit_cast<uint64_t>(n.y + 0.0) * 0xc2b2ae3d27d4eb4f +
                       std::bit_cast<uint64_t>(n.z + 0.0) * 0x165667b19e3779f9;
    return h >> 48;
  }
  std::array<Slot, 512> slots_;
  std::vector<uint32_t> numbers_;
  uint32_t count_ = 0, age_ = 0;
};

}  // namespace mansard
