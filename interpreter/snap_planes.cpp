#include "interpreter/snap_planes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/oriented_boxes.hpp"
#include "interpreter/component.hpp"
#include "interpreter/question.hpp"
#include "interpreter/random.hpp"
#include "interpreter/slice.hpp"

namespace mansard {
namespace {

/// A line across the axis may lean by 0.1 degree, and a plane that lies within 1 degree of a face
/// has no trace on it that could be told.
constexpr double most_lean = 0.001745, least_angle = 0.01745;
constexpr double touch = 1e-9;  ///< metres; less is no extent

constexpr Vec3 axis_of(const Scope& s, int i) { return i == 0 ? s.x : i == 1 ? s.y : s.z; }
constexpr double size_of(const Scope& s, int i) {
  return i == 0 ? s.size.x : i == 1 ? s.size.y : s.size.z;
}

}  // namespace

void SnapPlanes::clear(Vec3 origin) {
  origin_ = origin;
  fresh_.clear();
  known_.clear();
  faces_.clear();
  masses_.clear();
  boxes_.clear();
  index_.build(boxes_);
  solids_seen_ = 0;
}

SnapPlanes::Plane SnapPlanes::plane(Vec3 normal, Vec3 point, uint64_t label, uint32_t node) const {
  Plane made{normal, dot(normal, point - origin_), label, node, {}};
  constexpr double level = 1e-6;  // less is no direction
  const bool turned =
      normal.y < -level ||
      (normal.y <= level && (normal.x < -level || (normal.x <= level && normal.z < 0)));
  if (turned) {
    made.normal = -made.normal;
    made.at = -made.at;
  }
  const auto rounded = [](double value, double step) {
    return static_cast<int64_t>(std::llround(value / step));
  };
  made.near = {rounded(made.normal.x, 1e-9), rounded(made.normal.y, 1e-9),
               rounded(made.normal.z, 1e-9), rounded(made.at, 1e-6)};
  return made;
}

void SnapPlanes::record(const Scope& scope, Normals normals, uint64_t label, uint32_t node) {
  for (int i = 0; i < 3; ++i) {
    if (!(normals & (1 << i))) continue;
    const Vec3 normal = axis_of(scope, i);
    fresh_.push_back(plane(normal, scope.origin, label, node));
    if (size_of(scope, i) < touch) continue;
    fresh_.push_back(plane(normal, scope.origin + normal * size_of(scope, i), label, node));
  }
}

/// Those that are the same are kept once: the lowest, whichever was recorded first.
void SnapPlanes::freeze(const Machine& machine) {
  if (!fresh_.empty()) {
    known_.insert(known_.end(), fresh_.begin(), fresh_.end());
    fresh_.clear();
    const auto whole = [](const Plane& p) {
      return std::tie(p.label, p.near, p.at, p.normal.x, p.normal.y, p.normal.z, p.node);
    };
    const auto same = [](const Plane& a, const Plane& b) {
      return a.label == b.label && a.near == b.near;
    };
    std::ranges::sort(known_, [&](const Plane& a, const Plane& b) { return whole(a) < whole(b); });
    known_.erase(std::unique(known_.begin(), known_.end(), same), known_.end());
  }
  const std::size_t masses = masses_.size();
  for (; solids_seen_ < machine.world.size(); ++solids_seen_) {
    const Occluder& occluder = machine.world[solids_seen_];
    const Shape& shape = occluder.shape;
    if (!shape.massive || (shape.form != Form::box && shape.form != Form::prism)) continue;
    const auto first = static_cast<uint32_t>(faces_.size());
    add_faces(machine, shape);
    masses_.push_back({solids_seen_, first, static_cast<uint32_t>(faces_.size())});
    boxes_.push_back(occluder.box);
  }
  if (masses_.size() > masses) index_.build(boxes_);
}

/// The planes of all sides of a box or a prism.
void SnapPlanes::add_faces(const Machine& machine, const Shape& mass) {
  const Scope& scope = mass.scope;
  const uint64_t label = mass.label == Shape::none ? 0 : machine.program.symbol_hashes[mass.label];
  const auto add = [&](Vec3 normal, Vec3 point) {
    faces_.push_back(plane(normal, point, label, mass.node));
  };
  const bool is_box = mass.form == Form::box;
  const int up = mass.ground ? 1 : 2;  // of a prism
  for (int i = 0; i < 3; ++i) {
    if (!is_box && i != up) continue;
    add(axis_of(scope, i), scope.origin);
    add(axis_of(scope, i), scope.origin + axis_of(scope, i) * size_of(scope, i));
  }
  if (is_box) return;
  const PooledPolygon& pooled = machine.polygon_of(mass);
  const PlaneMap map(mass, pooled.natural);
  for_each_edge(pooled.polygon, [&](uint32_t, Vec2 from, Vec2 to) {
    const Vec2 along = normalized(map.scaled(to) - map.scaled(from));
    add(scope.direction(map.direction(left_of(along))), scope.at(map(from, 0)));
  });
}

/// A shape as the planes see it: the axis of the split, and what the shape has an extent along
/// beside it.
struct SnapPlanes::Cut {
  Vec3 along;
  double from = 0, whole = 0;  ///< in metres along the axis
  Vec3 point;                  ///< where the axis begins, in the middle of the shape otherwise
  std::array<Vec3, 2> across;
  std::size_t extents = 0;

  Cut(const Scope& scope, int axis, Vec3 origin) {
    along = axis_of(scope, axis);
    whole = size_of(scope, axis);
    point = scope.origin - origin;
    for (int i = 0; i < 3; ++i) {
      if (i == axis || size_of(scope, i) < touch) continue;
      point = point + axis_of(scope, i) * (size_of(scope, i) / 2);
      across[extents++] = axis_of(scope, i);
    }
  }
};

void SnapPlanes::cross(const Plane& plane, const Cut& cut, bool face,
                       std::vector<SnapLine>& found) {
  const double along = dot(plane.normal, cut.along);
  if (std::abs(along) < least_angle) return;
  if (face && length(mansard::cross(plane.normal, cut.along)) > most_lean) return;
  for (std::size_t i = 0; i < cut.extents; ++i) {
    if (std::abs(dot(plane.normal, cut.across[i])) > most_lean * std::abs(along)) return;
  }
  const double at = (plane.at - dot(plane.normal, cut.point)) / along;
  if (at > -same_line && at < cut.whole + same_line) found.push_back({at, plane.node, face, false});
}

std::size_t SnapPlanes::lines(const Machine& machine, const Shape& shape, Axis axis,
                              std::optional<uint64_t> label, std::vector<SnapLine>& found) {
  found.clear();
  const Cut cut(shape.scope, static_cast<int>(axis), origin_);
  std::size_t planes = 0;
  const auto cross_if = [&](const Plane& plane, bool face) {
    if (label && plane.label != *label) return;
    ++planes;
    cross(plane, cut, face, found);
  };
  for (const Plane& plane : known_) cross_if(plane, false);
  const World& world = machine.world;
  const Scope& own = shape.solid == Shape::none ? shape.scope : world[shape.solid].shape.scope;
  index_.near(grown(bounds_of(own), contact), near_);
  for (const uint32_t number : near_) {
    const Mass& mass = masses_[number];
    if (world.is_above(mass.solid, shape.solid)) continue;
    if (!meet(own, world[mass.solid].shape.scope, contact)) continue;
    for (uint32_t i = mass.first; i < mass.end; ++i) cross_if(faces_[i], true);
  }
  const auto whole = [](const SnapLine& l) { return std::tie(l.at, l.face, l.by); };
  std::ranges::sort(found,
                    [&](const SnapLine& a, const SnapLine& b) { return whole(a) < whole(b); });
  const auto same = [](const SnapLine& a, const SnapLine& b) { return b.at - a.at < same_line; };
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
  return planes;
}

bool SnapPlanes::any(std::optional<uint64_t> label) const {
  const auto fits = [&](const Plane& plane) { return !label || plane.label == *label; };
  return std::ranges::any_of(known_, fits) || std::ranges::any_of(fresh_, fits);
}

}  // namespace mansard
