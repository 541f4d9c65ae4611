#include "geometry/clip.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/clip_line.hpp"

namespace mansard {
namespace {

constexpr EdgeTag cut_tag{EdgeTag::cut, EdgeTag::no_wall};

/// Where the edge a-b crosses the line. Independent of the direction of the edge and of the line,
/// so that both sides of a cut share the point.
Vec2 crossing_point(Vec2 a, double side_a, Vec2 b, double side_b, Vec2 normal, double offset) {
  if (b.x < a.x || (b.x == a.x && b.y < a.y)) {
    std::swap(a, b);
    std::swap(side_a, side_b);
  }
  Vec2 p = mix(a, b, side_a / (side_a - side_b));
  if (normal.y == 0) p.x = offset / normal.x;
  if (normal.x == 0) p.y = offset / normal.y;
  return p;
}

uint32_t next_in_ring(const Polygon& polygon, uint32_t i) {
  const auto ring = std::upper_bound(polygon.ring_ends.begin(), polygon.ring_ends.end(), i);
  return i + 1 < *ring ? i + 1 : polygon.ring_begin(ring - polygon.ring_ends.begin());
}

/// Closes the ring that starts at `begin` and drops its new edges shorter than `tolerance`.
void close_loop(Polygon& loops, uint32_t begin, double tolerance) {
  auto& [points, tags, ends] = loops;
  uint32_t kept = begin;
  const auto size = static_cast<uint32_t>(points.size());
  for (uint32_t i = begin; i < size; ++i) {
    const Vec2 to = points[i + 1 == size ? begin : i + 1];
    const double limit = tags[i].has(EdgeTag::cut) ? tolerance : 0;
    if (length(to - points[i]) <= limit) continue;
    points[kept] = points[i];
    tags[kept++] = tags[i];
  }
  points.resize(kept);
  tags.resize(kept);
  loops.close_ring();
}

/// Inserts the points where edges cross u = `at` (axis 0) or v = `at`, and puts those within
/// `tolerance` exactly on it. Computed on the whole edges, they are the same for all strips.
Polygon split_edges(const Polygon& polygon, int axis, std::span<const double> cuts,
                    double tolerance) {
  Polygon result;
  const auto coordinate = [&](Vec2& p) -> double& { return axis == 0 ? p.x : p.y; };
  const auto snapped = [&](Vec2 p) {
    for (const double at : cuts) {
      if (std::abs(coordinate(p) - at) <= tolerance) coordinate(p) = at;
    }
    return p;
  };
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const auto ring = polygon.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const EdgeTag tag = polygon.tags[polygon.ring_begin(r) + i];
      Vec2 from = ring[i], to = ring[(i + 1) % ring.size()];
      Vec2 start = snapped(from), end = snapped(to);
      result.add_point(start, tag);
      const bool forwards = coordinate(from) < coordinate(to);
      for (std::size_t c = 0; c < cuts.size(); ++c) {
        const double at = cuts[forwards ? c : cuts.size() - 1 - c];
        if ((coordinate(start) - at) * (coordinate(end) - at) >= 0) continue;
        const Vec2 normal = axis == 0 ? Vec2{1, 0} : Vec2{0, 1};
        result.add_point(
            crossing_point(from, coordinate(from) - at, to, coordinate(to) - at, normal, at), tag);
      }
    }
    result.close_ring();
  }
  return result;
}

}  // namespace

std::vector<Polygon> clip(const Polygon& polygon, Vec2 normal, double offset, double tolerance) {
  if (polygon.points.size() < 3) return {};
  std::vector<double> side(polygon.points.size()), along(polygon.points.size());
  bool any_kept = false, any_cut = false;
  for (std::size_t i = 0; i < side.size(); ++i) {
    side[i] = dot(normal, polygon.points[i]) - offset;
    if (std::abs(side[i]) <= tolerance) side[i] = 0;
    along[i] = dot(Vec2{normal.y, -normal.x}, polygon.points[i]);
    any_kept = any_kept || side[i] < 0;
    any_cut = any_cut || side[i] > 0;
  }
  if (!any_kept) return {};
  if (!any_cut) return {polygon};

  const LineCut cut = cut_by_line(side, along, polygon.ring_ends, tolerance);
  Polygon loops;
  uint32_t corner = 0;
  for (const uint32_t end : cut.loop_ends) {
    const auto begin = static_cast<uint32_t>(loops.points.size());
    for (; corner < end; ++corner) {
      const auto [edge, crossing, cut_follows] = cut.corners[corner];
      Vec2 p = polygon.points[edge];
      if (crossing) {
        const uint32_t to = next_in_ring(polygon, edge);
        p = crossing_point(p, side[edge], polygon.points[to], side[to], normal, offset);
      }
      loops.add_point(p, cut_follows ? cut_tag : polygon.tags[edge]);
    }
    close_loop(loops, begin, tolerance);
  }
  return assemble(loops, tolerance);
}

std::vector<Polygon> clip_strip(const Polygon& polygon, int axis, double low, double high,
                                double tolerance) {
  if (polygon.points.size() < 3 || !(low < high)) return {};
  const Box2 box = bounds(polygon.points);
  const double least = axis == 0 ? box.low.x : box.low.y;
  const double most = axis == 0 ? box.high.x : box.high.y;
  if (most <= low + tolerance || least >= high - tolerance) return {};
  if (low <= least && most <= high) return {polygon};

  const double cuts[] = {low, high};
  const Vec2 normal = axis == 0 ? Vec2{1, 0} : Vec2{0, 1};
  std::vector<Polygon> result;
  for (const Polygon& below :
       clip(split_edges(polygon, axis, cuts, tolerance), normal, high, tolerance)) {
    for (Polygon& piece : clip(below, normal * -1, -low, tolerance)) {
      result.push_back(std::move(piece));
    }
  }
  return result;
}

}  // namespace mansard
