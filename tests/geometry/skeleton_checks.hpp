// What every skeleton must be, found without the means of those who make them.
#pragma once

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <string>
#include <utility>

#include "geometry/skeleton.hpp"

namespace mansard::test {

inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

inline Vec2 flat(Vec3 p) { return {p.x, p.y}; }

inline double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double t = std::clamp(dot(p - a, d) / std::max(dot(d, d), 1e-300), 0.0, 1.0);
  return length(p - mix(a, b, t));
}

/// How far inwards of the edge's line a point lies; by differences, so that it is good to the last
/// digits far away, too.
inline double inwards(Vec2 from, Vec2 to, Vec2 p) { return cross(normalized(to - from), p - from); }

inline bool face_holds(const SkeletonMesh& mesh, std::size_t f, Vec2 p, double within) {
  const auto face = mesh.face(f);
  bool inside = false;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vec2 a = flat(mesh.nodes[face[i]]), b = flat(mesh.nodes[face[(i + 1) % face.size()]]);
    if (distance_to_segment(p, a, b) <= within) return true;
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) {
      inside = !inside;
    }
  }
  return inside;
}

/// The inset distance at a point, from the faces that hold it; -1 where none does.
inline double height_at(const SkeletonMesh& mesh, Vec2 p) {
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    if (!face_holds(mesh, f, p, 1e-6)) continue;
    return inwards(flat(mesh.nodes[mesh.face(f)[0]]), flat(mesh.nodes[mesh.face(f)[1]]), p);
  }
  return -1;
}

/// The most that the heights of two skeletons differ at the nodes of both.
inline double difference(const SkeletonMesh& a, const SkeletonMesh& b) {
  double most = 0;
  for (const Vec3 p : a.nodes) most = std::max(most, std::abs(height_at(b, flat(p)) - p.z));
  for (const Vec3 p : b.nodes) most = std::max(most, std::abs(height_at(a, flat(p)) - p.z));
  return most;
}

/// Planar within 1e-5 m, and 1e-3 degrees at 45 where it is deeper than 1 cm.
inline bool is_planar(const SkeletonMesh& mesh, std::size_t f) {
  const auto face = mesh.face(f);
  double off = 0, depth = 0;
  for (const uint32_t i : face) {
    const Vec3 p = mesh.nodes[i];
    const double t = inwards(flat(mesh.nodes[face[0]]), flat(mesh.nodes[face[1]]), flat(p));
    off = std::max(off, std::abs(t - p.z));
    depth = std::max(depth, p.z);
  }
  return off <= 1e-5 && (depth < 0.01 || std::atan2(off, 2 * depth) * 180 / M_PI <= 1e-3);
}

/// The first promise that a skeleton over its polygon does not keep, or nothing.
inline std::string broken_skeleton(const SkeletonMesh& mesh, const Polygon& polygon) {
  if (mesh.faces() != polygon.points.size()) return "not a face for each edge";
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  std::string why;
  double covered = 0;
  for_each_edge(polygon, [&](uint32_t e, Vec2 a, Vec2 b) {
    const auto face = mesh.face(e);
    if (face.size() < 3 || face[0] != e || flat(mesh.nodes[face[0]]) != a ||
        flat(mesh.nodes[face[1]]) != b) {
      why = "a face does not start with its eave";
      return;
    }
    double twice = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const uint32_t next = face[(i + 1) % face.size()];
      const Vec3 p = mesh.nodes[face[i]], q = mesh.nodes[next];
      if (!std::isfinite(p.x + p.y + p.z)) why = "not finite";
      if (i > 1 && p.z <= 0) why = "a node is not above the eaves";
      if (i > 0) ++edges[{face[i], next}];
      twice += cross(flat(p) - a, flat(q) - a);
    }
    if (!(twice > 0)) why = "a face without area";
    if (!is_planar(mesh, e)) why = "a face is not planar";
    covered += twice / 2;
  });
  if (!why.empty()) return why;
  for (const auto& [edge, n] : edges) {
    if (n != 1 || !edges.contains({edge.second, edge.first})) return "an arc without two faces";
  }
  const double whole = area(polygon);
  return std::abs(covered - whole) <= 1e-6 * whole ? "" : "the faces do not cover the polygon";
}

/// The first edge of the original that has no eave to be on, or an eave that is no edge's.
inline std::string broken_map(const SkeletonOn& on, const Polygon& original) {
  const std::size_t n = on.polygon.points.size();
  if (on.points.size() != n || on.edges.size() != n ||
      on.edge_of.size() != original.points.size()) {
    return "the lists do not fit";
  }
  for (uint32_t e = 0; e < n; ++e) {
    if (on.edge_of[on.edges[e]] != e) return "an eave of no edge";
    if (!on.moved && on.polygon.points[e] != original.points[on.points[e]]) return "a moved corner";
  }
  std::string why;
  for_each_edge(original, [&](uint32_t e, Vec2 a, Vec2 b) {
    const uint32_t to = on.edge_of[e];
    if (to == ~0u || on.fallback > 1) return;
    const auto face = on.mesh.face(to);
    const Vec2 from = flat(on.mesh.nodes[face[0]]), until = flat(on.mesh.nodes[face[1]]);
    for (const Vec2 p : {a, b}) {
      if (std::abs(inwards(from, until, p)) > 1.1e-5 && length(b - a) > 0)
        why = "an edge is off its eave";
    }
  });
  return why;
}

}  // namespace mansard::test
