// Randomness without a generator: a draw is a hash of where it is made. So the order of work and
// the number of threads can not matter.
#pragma once

#include <cstdint>

namespace mansard {

/// SplitMix64's finaliser (Steele et al. 2014): every bit of the input moves every bit of the
/// output.
constexpr uint64_t scramble(uint64_t x) {
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9ull;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebull;
  x ^= x >> 31;
  return x;
}

constexpr uint64_t mix(uint64_t a, uint64_t b) {
  return scramble(a + 0x9e3779b97f4a7c15ull + scramble(b ^ 0xd1b54a32d192ed03ull));
}

/// In [0, 1), with 53 bits.
constexpr double unit_interval(uint64_t hash) {
  return static_cast<double>(hash >> 11) * 0x1.0p-53;
}

}  // namespace mansard
