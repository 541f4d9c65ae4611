// The axes of a scope, and the words that scripts have for them and for the planes they span.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/vector.hpp"

namespace mansard {

enum class Axis : uint8_t { x, y, z };

inline double& along(Vec3& v, Axis axis) {
  return axis == Axis::x ? v.x : axis == Axis::y ? v.y : v.z;
}
inline double along(const Vec3& v, Axis axis) {
  return axis == Axis::x ? v.x : axis == Axis::y ? v.y : v.z;
}

/// "X", as scripts write it.
inline char letter_of(Axis axis) { return "XYZ"[static_cast<int>(axis)]; }

/// "X", or "XS" of a split that snaps, in any case.
std::optional<Axis> axis_named(std::string_view word);
bool is_snapping_axis(std::string_view word);
/// What is wrong with a word that names no axis, and what to write instead.
std::string wrong_axis(std::string_view word);
std::string axis_help(std::string_view word);

/// Planes of a scope: a bit for each axis that stands upright on one, 1 for x, 2 for y, 4 for z.
using Normals = uint8_t;
/// "XZ", in any order and case; several with spaces or commas between them.
std::optional<Normals> normals_named(std::string_view planes);
std::string wrong_planes(std::string_view planes);
inline constexpr std::string_view planes_help =
    "two axes span a plane: \"XZ\" bounds the shape below and above, \"YZ\" on the left and right";

}  // namespace mansard
