// What every roof must be, and the options of every kind.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "geometry/clean.hpp"
#include "geometry/roof.hpp"

namespace mansard::test {

inline Vec3 area_vector(const std::vector<Vec3>& loop) {
  Vec3 sum;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    sum = sum + cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]) * 0.5;
  }
  return sum;
}

inline Vec3 area_vector(const RoofFace& face) {
  Vec3 sum = area_vector(face.loop);
  for (const auto& hole : face.holes) sum = sum + area_vector(hole);
  return sum;
}

inline double distance_to_outline(const Polygon& polygon, Vec2 p) {
  double nearest = 1e300;
  for_each_edge(polygon, [&](uint32_t, Vec2 a, Vec2 b) {
    const Vec2 d = b - a;
    const double t = std::clamp(dot(p - a, d) / std::max(dot(d, d), 1e-30), 0.0, 1.0);
    nearest = std::min(nearest, length(p - mix(a, b, t)));
  });
  return nearest;
}

// Faces are finite, planar, not empty, and look where they should.
inline std::string broken_face(const Roof& roof, double flatness) {
  for (const RoofFace& face : roof.faces) {
    for (const Vec3 p : face.loop) {
      if (!std::isfinite(p.x + p.y + p.z)) return "a point is not finite";
    }
    const Vec3 vector = area_vector(face), normal = normalized(vector);
    if (face.loop.size() < 3 || !(length(vector) > 1e-12)) return "a face without area";
    for (const Vec3 p : face.loop) {
      if (std::abs(dot(p - face.loop[0], normal)) > flatness) return "a face is not planar";
    }
    if (face.part == RoofPart::slope && normal.z <= 0) return "a slope looks down";
    if (face.part == RoofPart::soffit && normal.z >= 0) return "a soffit looks up";
    if (face.part == RoofPart::top && normal.z < 0.999) return "a top is not level";
    if (face.part == RoofPart::gable && std::abs(normal.z) > 1e-4) return "a gable is not upright";
    const bool level = normal.z > 1 - 1e-6;  // the upper side of a cornice
    if (face.part == RoofPart::fascia && std::abs(normal.z) > 1e-4 && !level) {
      return "a fascia is neither upright nor level";
    }
  }
  return {};
}

using FootEdge = std::tuple<double, double, double, double, double, double>;

/// Edges without an opposite one, and how often.
inline std::map<FootEdge, int> open_edges(const Roof& roof) {
  std::map<FootEdge, int> count;
  const auto add = [&](const std::vector<Vec3>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 a = loop[i] + Vec3{}, b = loop[(i + 1) % loop.size()] + Vec3{};
      auto opposite = count.find({b.x, b.y, b.z, a.x, a.y, a.z});
      if (opposite == count.end()) {
        ++count[{a.x, a.y, a.z, b.x, b.y, b.z}];
      } else if (--opposite->second == 0) {
        count.erase(opposite);
      }
    }
  };
  for (const RoofFace& face : roof.faces) {
    add(face.loop);
    for (const auto& hole : face.holes) add(hole);
  }
  return count;
}

/// The foot of a roof as asked has the walls' tops edge by edge, so that both make one closed
/// solid.
inline std::string cracked_foot(const Roof& roof, const Polygon& polygon) {
  const std::map<FootEdge, int> open = open_edges(roof);
  std::size_t found = 0, edges = 0;
  for_each_edge(polygon, [&](uint32_t, Vec2 a, Vec2 b) {
    constexpr double same = 1e-8;  // metres
    if (length(b - a) < same) return;
    ++edges;
    found += std::any_of(open.begin(), open.end(), [&](const auto& entry) {
      const auto [ax, ay, az, bx, by, bz] = entry.first;
      return length(a - Vec2{ax, ay}) < same && length(b - Vec2{bx, by}) < same;
    });
  });
  return found == edges && found == open.size() ? "" : "a crack above the walls";
}

// Edges without an opposite one, which must be those that stand on the walls.
inline std::string open_edge(const Roof& roof, const Polygon& polygon, double tolerance) {
  const std::map<FootEdge, int> count = open_edges(roof);
  double around = 0;
  for (const auto& [key, n] : count) {
    const auto [ax, ay, az, bx, by, bz] = key;
    if (az != 0 || bz != 0 || n != 1) return "an edge is open above the walls";
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {
      if (distance_to_outline(polygon, mix(Vec2{ax, ay}, Vec2{bx, by}, t)) > tolerance) {
        return "an edge at the foot misses the walls";
      }
    }
    around += length(Vec2{bx - ax, by - ay});
  }
  const auto cleaned = clean(polygon, {});  // without spikes, which sloped roofs lose
  double error = std::abs(around - perimeter(polygon));
  if (cleaned && cleaned->moved) return {};  // rings may share edges
  // The two sides of a spike may cancel each other.
  if (cleaned && std::abs(perimeter(polygon) - perimeter(cleaned->polygon)) > 0.01) return {};
  if (cleaned) error = std::min(error, std::abs(around - perimeter(cleaned->polygon)));
  if (error > 10 * tolerance * static_cast<double>(polygon.points.size())) {
    return "the foot does not go around the walls";
  }
  return {};
}

/// The largest error of the slopes in degrees, where they rise by over a centimetre's depth; less
/// what corners off their plane by `flatness` metres can make of it.
inline double pitch_error(const Roof& roof, double pitch, double flatness) {
  const double least = 0.01 * std::tan(pitch * std::numbers::pi / 180);
  double most = 0;
  for (const RoofFace& face : roof.faces) {
    double low = 1e300, high = -1e300;
    for (const Vec3 p : face.loop) {
      low = std::min(low, p.z);
      high = std::max(high, p.z);
    }
    if (face.part != RoofPart::slope || high - low < least) continue;
    const double up = normalized(area_vector(face)).z;
    const double error = std::abs(std::acos(up) * 180 / std::numbers::pi - pitch);
    most = std::max(most, error - flatness / (high - low) * 180 / std::numbers::pi);
  }
  return most;
}

inline std::string wrong_pitch(const Roof& roof, double pitch) {
  return pitch_error(roof, pitch, 1e-5) > (roof.fallback == 1 ? 1e-3 : 0.1) ? "a wrong pitch" : "";
}

inline double tolerance_of(const Roof& roof) {
  return std::array{1e-3, 0.06, 0.5}[static_cast<std::size_t>(std::min(roof.fallback, 3)) - 1];
}

inline bool swept(RoofKind kind) {
  return kind == RoofKind::shed || kind == RoofKind::saltbox || kind == RoofKind::sawtooth ||
         kind == RoofKind::barrel || kind == RoofKind::cross_gable || kind == RoofKind::flat;
}

inline bool one_pitch(RoofKind kind) {
  return kind == RoofKind::hip || kind == RoofKind::gable || kind == RoofKind::half_hip ||
         kind == RoofKind::dutch_hip;
}

// The first law that the roof breaks, or nothing.
inline std::string broken_law(const Polygon& polygon, const RoofOptions& options, const Roof& made,
                              double flatness) {
  if (made.fallback >= 5 || !clean(polygon, {})) return {};
  const double tolerance = tolerance_of(made), whole = area(polygon);
  const double least = made.fallback == 1 ? flatness : 1e-4;  // the outline moved by more
  if (std::string why = broken_face(made, std::max(flatness, least)); !why.empty()) return why;
  if (std::string why = open_edge(made, polygon, tolerance); !why.empty()) return why;
  const bool spiky = std::abs(perimeter(polygon) - perimeter(clean(polygon, {})->polygon)) > 0.01;
  if (made.fallback == 1 && !swept(options.kind) && !spiky) {
    if (std::string why = cracked_foot(made, polygon); !why.empty()) return why;
  }
  if (one_pitch(options.kind) && options.height == 0) {
    if (std::string why = wrong_pitch(made, options.pitch); !why.empty()) return why;
  }
  Vec3 sum;
  for (const RoofFace& face : made.faces) sum = sum + area_vector(face);
  if (length(sum - Vec3{0, 0, whole}) > 1e-6 * whole + tolerance * perimeter(polygon)) {
    return "the roof does not cover the footprint";
  }
  return {};
}

inline std::string broken_law(const Polygon& polygon, const RoofOptions& options, double flatness) {
  return broken_law(polygon, options, roof(polygon, options), flatness);
}

inline constexpr std::array kinds{RoofKind::hip,      RoofKind::gable,       RoofKind::flat,
                                  RoofKind::half_hip, RoofKind::dutch_hip,   RoofKind::pyramid,
                                  RoofKind::shed,     RoofKind::mansard,     RoofKind::gambrel,
                                  RoofKind::saltbox,  RoofKind::cross_gable, RoofKind::sawtooth,
                                  RoofKind::barrel};

// Every kind without and with an overhang; some by height, some with verges of their own.
inline std::vector<RoofOptions> all_kinds() {
  std::vector<RoofOptions> all;
  for (const RoofKind kind : kinds) {
    for (const double overhang : {0.0, 0.4}) {
      RoofOptions options;
      options.kind = kind;
      options.overhang = overhang;
      if (one_pitch(kind)) options.pitch = 40;
      if (kind == RoofKind::flat && overhang > 0) options.parapet = 0.8;
      if (kind == RoofKind::gable && overhang == 0) options.height = 3;
      if (kind == RoofKind::half_hip) options.verge = 0.1;
      all.push_back(options);
    }
  }
  return all;
}

}  // namespace mansard::test
