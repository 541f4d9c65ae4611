// The planes of a building that splits snap to: those that snap() recorded, and the faces of masses
// (Müller et al. 2006 §3.3). They are infinite and hold for the whole building.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/box_index.hpp"
#include "interpreter/axes.hpp"
#include "interpreter/shape.hpp"
#include "interpreter/snap_lines.hpp"

namespace mansard {

class Machine;

/// Nothing is asked of the heap once it has held as much.
class SnapPlanes {
 public:
  /// Distances are measured from `origin`, so that far from the world's origin they stay exact.
  void clear(Vec3 origin);
  /// The two planes that bound the scope across each of the normals, one where they are the same.
  /// `label` is hash_of its name, 0 if it has none.
  void record(const Scope& scope, Normals normals, uint64_t label, uint32_t node);
  /// What was recorded, and the masses that there are, is what splits see until the next freeze.
  void freeze(const Machine& machine);

  /// Ascending into `found` (cleared first): where planes cross the shape in a line across the
  /// axis, between its ends or at them. Of all planes that were recorded, or of those with the
  /// label; and of the faces of masses that come into contact with the solid that the shape came
  /// from, if they stand across the axis. Returns how many planes there were to choose from.
  std::size_t lines(const Machine& machine, const Shape& shape, Axis axis,
                    std::optional<uint64_t> label, std::vector<SnapLine>& found);
  /// Whether any plane was recorded by now, with the label if there is one.
  bool any(std::optional<uint64_t> label) const;

 private:
  struct Plane {
    Vec3 normal;    ///< unit, into the half space of positive coordinates
    double at = 0;  ///< along the normal from the origin
    uint64_t label = 0;
    uint32_t node = 0;
    std::array<int64_t, 4> near{};  ///< rounded, so that what is the same stands together
  };
  struct Mass {
    uint32_t solid = 0;  ///< in the world
    uint32_t first = 0, end = 0;
  };
  struct Cut;

  Plane plane(Vec3 normal, Vec3 point, uint64_t label, uint32_t node) const;
  void add_faces(const Machine& machine, const Shape& mass);
  static void cross(const Plane& plane, const Cut& cut, bool face, std::vector<SnapLine>& found);

  Vec3 origin_;
  std::vector<Plane> fresh_, known_, faces_;
  std::vector<Mass> masses_;
  std::vector<Box3> boxes_;
  BoxIndex index_;
  uint32_t solids_seen_ = 0;
  std::vector<uint32_t> near_;
};

}  // namespace mansard
