// Random streams of shapes: an edit in one branch re-rolls no other.
#pragma once

#include <cstdint>
#include <string_view>

#include "geometry/random.hpp"

namespace mansard {

/// FNV-1a, scrambled: the same on every machine.
constexpr uint64_t hash_of(std::string_view text) {
  uint64_t h = 0xcbf29ce484222325ull;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return scramble(h);
}

}  // namespace mansard
