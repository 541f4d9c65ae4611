// What becomes of the textures of a part's faces when the part is moved. Private to the
// interpreter.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vector.hpp"

namespace mansard {

/// How a face's texture goes on when the face moves.
struct Hang {
  bool on_wall = false;  ///< it runs on from the wall that the part stands on
  bool level = false;    ///< if not: its height counts, from the foot of the building
  Vec3 u, v;             ///< repeats that u and v grow by, a metre

  friend bool operator==(const Hang&, const Hang&) = default;
};

/// A part's way to its place, in metres.
struct Moves {
  Vec3 by;       ///< from the origin
  Vec3 on_wall;  ///< from where the texture begins that it hangs on
  double up;     ///< from the foot of the building

  bool moves_textures() const { return on_wall != Vec3{} || up != 0; }
  Vec2 shift(const Hang& hang) const {
    if (hang.on_wall) return {dot(on_wall, hang.u), dot(on_wall, hang.v)};
    return hang.level ? Vec2{up * hang.u.y, up * hang.v.y} : Vec2{};
  }
};

/// Of many polygons. Kinds are few, and neighbours are mostly of one.
class Hangings {
 public:
  std::size_t size() const { return kind_of_.size(); }
  void clear() {
    kinds_.resize(1);
    kind_of_.clear();
  }

  void add(uint32_t kind) { kind_of_.push_back(kind); }
  void add_loose(std::size_t polygons) { kind_of_.resize(size() + polygons); }
  uint32_t& operator[](std::size_t polygon) { return kind_of_[polygon]; }
  uint32_t operator[](std::size_t polygon) const { return kind_of_[polygon]; }
  const Hang& of_kind(uint32_t kind) const { return kinds_[kind]; }
  uint32_t kind(const Hang& hang);  ///< its number

 private:
  std::vector<Hang> kinds_ = std::vector<Hang>(1);  ///< the first: does not hang at all
  std::vector<uint32_t> kind_of_;
};

/// The kind of hang among the last few; else it is added.
inline uint32_t Hangings::kind(const Hang& hang) {
  constexpr std::size_t looked_at = 8;
  if (!hang.on_wall && !hang.level) return 0;
  const std::size_t end = kinds_.size(), first = end > looked_at ? end - looked_at : 1;
  for (std::size_t i = end; i-- > first;) {
    if (kinds_[i] == hang) return static_cast<uint32_t>(i);
  }
  kinds_.push_back(hang);
  return static_cast<uint32_t>(end);
}

}  // namespace mansard
