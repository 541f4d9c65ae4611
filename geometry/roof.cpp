#include "geometry/roof.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/repair.hpp"
#include "geometry/roof_parts.hpp"

namespace mansard {
namespace {

// Far from the origin digits would be lost.
Vec2 origin_of(const Polygon& polygon) {
  if (polygon.points.empty()) return {};
  const Vec2 p = polygon.points[0];
  return std::isfinite(p.x) && std::isfinite(p.y) && length(p) > 1000 ? p : Vec2{};
}

void move(Roof& roof, Vec2 by) {
  const Vec3 up{by.x, by.y, 0};
  for (RoofFace& face : roof.faces) {
    for (Vec3& p : face.loop) p = p + up;
    for (auto& hole : face.holes) {
      for (Vec3& p : hole) p = p + up;
    }
  }
}

std::optional<Roof> sound_roof(const Polygon& polygon, const RoofOptions& options) {
  std::optional<Roof> made;
  if (!is_swept(options.kind)) made = skeleton_roof(polygon, options);
  if (!made) made = swept_roof(polygon, options);
  return made;
}

// One roof for each piece of an outline that crosses itself.
std::optional<Roof> repaired_roof(const Polygon& polygon, RoofOptions options) {
  options.gables.reset();  // they number the edges of the whole
  options.hips.reset();
  options.ridge.reset();
  std::vector<std::vector<Vec2>> rings;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const auto ring = polygon.ring(r);
    for (const Vec2 p : ring) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return std::nullopt;
    }
    if (ring.size() >= 3) rings.emplace_back(ring.begin(), ring.end());
  }
  if (rings.empty()) return std::nullopt;
  Roof whole;
  for (const auto& piece : repair(rings).pieces) {
    Polygon part;
    for (const auto& ring : piece) {
      for (const Vec2 p : ring) part.add_point(p);
      part.close_ring();
    }
    std::optional<Roof> roof = sound_roof(part, options);
    if (!roof) return std::nullopt;
    whole.fallback = std::max({4, whole.fallback, roof->fallback});
    for (RoofFace& face : roof->faces) whole.faces.push_back(std::move(face));
  }
  if (whole.faces.empty()) return std::nullopt;
  return whole;
}

Roof local_roof(const Polygon& polygon, const RoofOptions& options) {
  if (options.kind == RoofKind::flat) return flat_roof(polygon, options);
  std::optional<Roof> made = sound_roof(polygon, options);
  if (!made) made = repaired_roof(polygon, options);
  if (made) return std::move(*made);
  Roof flat = flat_roof(polygon, options);
  flat.fallback = 6;
  return flat;
}

}  // namespace

void add_face(Roof& roof, RoofPart part, EdgeTag tag, std::span<const Vec3> loop) {
  RoofFace face{part, tag, {}, {}, {}};
  face.loop.reserve(loop.size());
  for (const Vec3 p : loop) {
    if (face.loop.empty() || face.loop.back() != p) face.loop.push_back(p);
  }
  while (face.loop.size() > 1 && face.loop.front() == face.loop.back()) face.loop.pop_back();
  if (face.loop.size() >= 3) roof.faces.push_back(std::move(face));
}

bool is_swept(RoofKind kind) {
  return kind == RoofKind::shed || kind == RoofKind::saltbox || kind == RoofKind::sawtooth ||
         kind == RoofKind::barrel;
}

bool has_party_wall(const Polygon& polygon) {
  return std::any_of(polygon.tags.begin(), polygon.tags.end(),
                     [](EdgeTag tag) { return tag.has(EdgeTag::party); });
}

double rise_of(double pitch) {
  constexpr double degree = std::numbers::pi / 180;
  return std::tan(std::clamp(pitch, 0.01, 89.0) * degree);
}

double pitch_of(const RoofOptions& options) {
  if (options.pitch > 0) return options.pitch;
  switch (options.kind) {
    case RoofKind::mansard:
      return 70;
    case RoofKind::gambrel:
    case RoofKind::barrel:
      return 60;
    case RoofKind::saltbox:
      return 45;
    case RoofKind::shed:
      return 15;
    case RoofKind::sawtooth:
      return 30;
    default:
      return 35;
  }
}

double thickness_of(const RoofOptions& options) {
  if (options.overhang <= 0) return 0;
  return options.height > 0 ? std::min(options.thickness, options.height / 2) : options.thickness;
}

Roof roof(const Polygon& polygon, const RoofOptions& options) {
  const Vec2 origin = origin_of(polygon);
  if (origin == Vec2{}) return local_roof(polygon, options);
  Polygon local = polygon;
  translate(local, origin * -1);
  Roof made = local_roof(local, options);
  move(made, origin);
  return made;
}

}  // namespace mansard
