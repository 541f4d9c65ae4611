#include "formats/free_names.hpp"

#include <algorithm>
#include <utility>

namespace mansard {
namespace {

/// FNV-1a (Fowler, Noll, Vo), its bits spread by the finalizer of MurmurHash3. Never 0.
uint64_t hash_of(std::string_view name) {
  uint64_t h = 0xcbf29ce484222325;
  for (const char c : name) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  h = (h ^ h >> 33) * 0xff51afd7ed558ccd;
  h = (h ^ h >> 33) * 0xc4ceb9fe1a85ec53;
  h ^= h >> 33;
  return h == 0 ? 1 : h;
}

/// Where it is, or would be.
std::size_t slot_of(const std::vector<uint64_t>& slots, uint64_t hash) {
  std::size_t at = hash & (slots.size() - 1);
  while (slots[at] != 0 && slots[at] != hash) at = (at + 1) & (slots.size() - 1);
  return at;
}

}  // namespace

std::string FreeNames::next(std::string_view wanted) {
  std::string name(wanted);
  if (take(hash_of(name))) return name;
  for (std::size_t& n = last_.try_emplace(name, 1).first->second;;) {
    name = std::string(wanted) + separator_ + std::to_string(++n);
    if (take(hash_of(name))) return name;
  }
}

bool FreeNames::is_taken(std::string_view name) const {
  return !slots_.empty() && slots_[slot_of(slots_, hash_of(name))] != 0;
}

bool FreeNames::take(uint64_t hash) {
  if (2 * (count_ + 1) > slots_.size()) {
    std::vector<uint64_t> more(std::max<std::size_t>(2 * slots_.size(), 64));
    for (const uint64_t known : slots_) {
      if (known != 0) more[slot_of(more, known)] = known;
    }
    slots_ = std::move(more);
  }
  uint64_t& slot = slots_[slot_of(slots_, hash)];
  if (slot != 0) return false;
  slot = hash;
  ++count_;
  return true;
}

}  // namespace mansard
