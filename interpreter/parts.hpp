// Parts of buildings that were derived once, to be placed again: what came of a shape, apart from
// where it stood. Private to the interpreter.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/mesh.hpp"
#include "interpreter/hanging.hpp"

namespace mansard {

/// What a derivation looked at, as bits: one an attribute of the shape, and these.
namespace read_bits {
inline constexpr uint32_t chance = 1u << 31;    ///< it drew
inline constexpr uint32_t building = 1u << 30;  ///< the footprint's properties, what is drawn once
                                                ///< a building, its own materials
inline constexpr uint32_t aloud = 1u << 29;     ///< it left more than surfaces: warnings, counts
inline constexpr uint32_t attributes = aloud - 1;
}  // namespace read_bits

/// All that a part depends on, as words; compared as a whole.
struct PartKey {
  std::array<uint64_t, 40> words;
  std::size_t count = 0;

  void add(std::integral auto word) { words[count++] = static_cast<uint64_t>(word); }
  void add(double number);
  void add(Vec3 v);
  std::span<const uint64_t> all() const { return {words.data(), count}; }
};

/// Counted by symbol or by production.
using PartCount = std::pair<uint32_t, uint32_t>;

/// Where a part lies in the store.
struct Part {
  struct Range {
    uint32_t first = 0, count = 0;
  };
  uint64_t hash = 0;
  Range key, points, polygons, runs, placed, terminals, taken;
  uint32_t shapes = 0, operations = 0, pieces = 0, calls = 0;
  uint32_t depth = 0;  ///< of the shape tree below it
  uint32_t reads = 0;
  bool hangs = false;  ///< some texture moves otherwise than the part
};

/// One a thread. It forgets all when it grows large, which costs time but changes nothing.
class PartStore {
 public:
  const Part* find(const PartKey& key) const;
  /// A part that is to be filled, its key set.
  Part& add(const PartKey& key);
  bool full() const { return points.size() > most_points; }
  void clear();

  std::span<const Vec3> points_of(const Part& p) const { return slice(points, p.points); }

  template <class T>
  static std::span<const T> slice(const std::vector<T>& all, Part::Range range) {
    return {all.data() + range.first, range.count};
  }

  // ---- of all parts, one after the other
  std::vector<Vec3> points;  ///< from the part's own origin
  std::vector<Vec2> uvs;
  std::vector<uint32_t> ends;  ///< from the part's first point
  std::vector<Vec3> normals;
  Hangings hung;                        ///< by polygon
  std::vector<Surface::Run> runs;       ///< ends from the part's first polygon
  std::vector<Surface::Placed> placed;  ///< likewise
  std::vector<PartCount> counts;

 private:
  static constexpr std::size_t most_points = 100'000;
  static uint64_t hash_of(const PartKey& key);
  void rehash();

  std::vector<uint64_t> keys_;
  std::vector<Part> parts_;
  std::vector<uint32_t> slots_;  ///< 1 + number of the part, by hash; 0: free
};

}  // namespace mansard
