// Whether a skeleton is right: what every one has to pass, whoever made it.
#include <algorithm>
#include <cmath>

#include "geometry/skeleton_steps.hpp"

namespace mansard {
namespace {

// Metres off a plane, and a share of the face's depth: 1e-3 degrees at most.
constexpr double flat = 5e-6, flat_share = 3e-5;
constexpr double backwards = 1e-6;  // metres

// Every arc has a face at each side, and the eaves one face.
bool is_closed(const Workpiece& piece) {
  const auto& [polygon, lines, mesh, spokes] = piece;
  const auto count = [&](uint32_t from, uint32_t to) {
    const auto at = piece.spokes.at(from);
    return std::count_if(at.begin(), at.end(), [&](Spokes::Spoke s) { return s.to == to; });
  };
  bool closed = true;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
    for (uint32_t e = begin; e < end; ++e) {
      const auto face = mesh.face(e);
      closed =
          closed && face.size() >= 3 && face[0] == e && face[1] == (e + 1 == end ? begin : e + 1);
      for (std::size_t i = 1; i < face.size() && closed; ++i) {
        const uint32_t a = face[i], b = face[i + 1 < face.size() ? i + 1 : 0];
        closed = count(a, b) == 1 && count(b, a) == 1;
      }
    }
  }
  return closed;
}

// A face seen from its wall: s along it, t away from it. Faces of straight skeletons are monotone
// along their walls (Aichholzer et al. 1995 §2), so their outlines go right once and left once.
struct FaceView {
  std::vector<Vec2> corners;  // (s, t)

  const Vec2& at(std::size_t i) const { return corners[i % corners.size()]; }

  double height_of_chain(std::size_t from, std::size_t to, double s) const {
    for (std::size_t i = from; i < to; ++i) {
      const Vec2 a = at(i), b = at(i + 1);
      if (std::min(a.x, b.x) > s || std::max(a.x, b.x) < s) continue;
      return b.x == a.x ? std::max(a.y, b.y) : a.y + (b.y - a.y) * ((s - a.x) / (b.x - a.x));
    }
    return std::min(at(from).y, at(to).y);  // beyond the ends
  }

  bool is_simple() const {
    const auto less = [](Vec2 a, Vec2 b) { return a.x < b.x; };
    const auto first = corners.begin();
    const auto low = static_cast<std::size_t>(std::min_element(first, corners.end(), less) - first);
    auto high = static_cast<std::size_t>(std::max_element(first, corners.end(), less) - first);
    const std::size_t n = corners.size();
    if (high < low) high += n;
    for (std::size_t i = low; i < high; ++i) {
      if (at(i + 1).x < at(i).x - backwards) return false;
    }
    for (std::size_t i = high; i < low + n; ++i) {
      if (at(i + 1).x > at(i).x + backwards) return false;
    }
    for (std::size_t i = high + 1; i < low + n; ++i) {
      double lower = height_of_chain(low, high, at(i).x);
      for (const double s : {at(i).x - backwards, at(i).x + backwards}) {
        lower = std::min(lower, height_of_chain(low, high, s));
      }
      if (lower > at(i).y + flat) return false;
    }
    return true;
  }
};

// Twice the face's area, or a negative number where it is broken.
double checked_face(const SkeletonMesh& mesh, uint32_t f, const WallLine& line, FaceView& view) {
  const auto face = mesh.face(f);
  const Vec3 first = mesh.nodes[face[0]];
  const Vec2 along{line.normal.y, -line.normal.x};
  view.corners.clear();
  double off = 0, depth = 0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vec3 p = mesh.nodes[face[i]];
    const double t = line.distance({p.x, p.y});
    if (i > 1 && !(p.z > 0)) return -1;
    off = std::max(off, std::abs(t - p.z));
    depth = std::max(depth, p.z);
    view.corners.push_back({dot(Vec2{p.x - first.x, p.y - first.y}, along), t});
  }
  if (!(off < flat) || (depth > 0.01 && off > flat_share * depth)) return -1;
  const std::vector<Vec2>& c = view.corners;
  double twice = 0;
  for (std::size_t i = 2; i < c.size(); ++i) twice += cross(c[i - 1], c[i]);
  if (c.size() > 3 && !view.is_simple()) return -1;
  return twice > 0 ? twice : -1;
}

}  // namespace

bool is_sound(const Workpiece& piece) {
  const Polygon& polygon = piece.polygon;
  const std::size_t n = polygon.points.size();
  if (piece.mesh.faces() != n || !is_closed(piece)) return false;
  FaceView view;
  double covered = 0;
  for (uint32_t e = 0; e < n; ++e) {
    const double twice = checked_face(piece.mesh, e, piece.lines[e], view);
    if (!(twice > 0)) return false;
    covered += twice / 2;
  }
  const double whole = area(polygon);
  return std::abs(covered - whole) <= 1e-6 * whole;
}

}  // namespace mansard
