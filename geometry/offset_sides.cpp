#include "geometry/offset_sides.hpp"

#include <algorithm>
#include <cmath>

namespace mansard {
namespace {

/// A mitre longer than this many moved distances is no mitre, at corners that open as they move.
constexpr double mitre_limit = 4;
/// Nearly straight corners whose edges move differently get a step when the mitre would be longer.
constexpr double step_limit = 10;

/// The corner v between directions `in` and `out` whose edges move left by d_in and d_out.
MovedCorner move_corner(Vec2 v, Vec2 in, Vec2 out, double d_in, double d_out) {
  const Vec2 n_in = left_of(in), n_out = left_of(out);
  const MovedCorner step{v + n_in * d_in, v + n_out * d_out, v, false};
  if (d_in == 0 && d_out == 0) return {v, v, v};
  const double turn = cross(in, out), ahead = dot(in, out);
  const double most = std::max(std::abs(d_in), std::abs(d_out));
  if (std::abs(turn) < 1e-9) {
    if (ahead > 0 && d_in != d_out) return step;
    const Vec2 p = v + n_in * d_in;
    if (ahead > 0) return {p, p, v};
  } else {
    // n_in . x = d_in and n_out . x = d_out
    const Vec2 x =
        Vec2{d_in * n_out.y - d_out * n_in.y, n_in.x * d_out - n_out.x * d_in} * (1 / turn);
    const bool opens = turn * (d_in + d_out) < 0;
    const double limit =
        ahead >= 0 ? (d_in == d_out ? 1e9 : step_limit) : (opens ? mitre_limit : 1e9);
    if (length(x) <= limit * most) return {v + x, v + x, v};
    if (ahead >= 0) return step;
  }
  // A needle: cut its mitre off square, `most` metres before the point.
  const Vec2 reach = normalized(in - out) * most;
  return {v + n_in * d_in + reach, v + n_out * d_out + reach, v + reach, false};
}

/// Drops the part of a swept figure where its two mitres have already met.
void add_top(Side& side, const MovedCorner& first, const MovedCorner& last) {
  const Vec2 along = side.to - side.from;
  side.vanished = dot(side.moved_to - side.moved_from, along) <= 1e-9 * length(along);
  if (!side.vanished) {
    if (last.between != side.to) side.swept.push_back(last.between);
    side.swept.push_back(side.moved_to);
    side.swept.push_back(side.moved_from);
    if (first.between != side.from) side.swept.push_back(first.between);
    return;
  }
  const Vec2 a = side.moved_from - side.from, b = side.moved_to - side.to;
  const double turn = cross(a, b);
  if (turn == 0) return;
  side.swept.push_back(side.from + a * (cross(along, b) / turn));
}

/// Calls f(edge before, edge after, direction in, direction out) for every point; the edge after a
/// point has its number.
template <class F>
void for_each_corner(const Polygon& polygon, F f) {
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), n = polygon.ring_ends[r] - begin;
    for (uint32_t i = 0; i < n; ++i) {
      const uint32_t before = begin + (i + n - 1) % n, at = begin + i, after = begin + (i + 1) % n;
      f(before, at, normalized(polygon.points[at] - polygon.points[before]),
        normalized(polygon.points[after] - polygon.points[at]));
    }
  }
}

}  // namespace

std::vector<MovedCorner> move_corners(const Polygon& polygon, std::span<const double> distances) {
  std::vector<MovedCorner> corners(polygon.points.size());
  for_each_corner(polygon, [&](uint32_t before, uint32_t i, Vec2 in, Vec2 out) {
    corners[i] = move_corner(polygon.points[i], in, out, distances[before], distances[i]);
    corners[i].convex = cross(in, out) > 0;
  });
  return corners;
}

std::vector<MovedCorner> widen(const Polygon& polygon, std::span<const double> distances,
                               std::vector<MovedCorner> corners) {
  for_each_corner(polygon, [&](uint32_t before, uint32_t i, Vec2 in, Vec2 out) {
    if (!corners[i].convex) return;
    const Vec2 v = polygon.points[i];
    if (dot(corners[i].in - v, in) < 0) corners[i].in = v + left_of(in) * distances[before];
    if (dot(corners[i].out - v, out) > 0) corners[i].out = v + left_of(out) * distances[i];
  });
  return corners;
}

std::vector<Side> moved_sides(const Polygon& polygon, std::span<const double> distances,
                              std::span<const MovedCorner> corners) {
  std::vector<Side> sides;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t next = i + 1 == end ? begin : i + 1;
      const double distance = distances[i];
      const Vec2 along = polygon.points[next] - polygon.points[i];
      if (distance == 0 || length(along) == 0) continue;
      Side side{i,
                polygon.points[i],
                polygon.points[next],
                {},
                std::abs(distance),
                corners[i].out,
                corners[next].in,
                false,
                {}};
      side.normal = left_of(normalized(along)) * (distance > 0 ? 1 : -1);
      side.swept = {side.from, side.to};
      add_top(side, corners[i], corners[next]);
      if (area(side.swept) < 0) std::reverse(side.swept.begin(), side.swept.end());
      if (side.swept.size() >= 3) sides.push_back(std::move(side));
    }
  }
  return sides;
}

bool convex_overlap(std::span<const Vec2> a, std::span<const Vec2> b, double tolerance) {
  for (int turn = 0; turn < 2; ++turn, std::swap(a, b)) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Vec2 along = a[(i + 1) % a.size()] - a[i];
      const double size = length(along);
      if (size == 0) continue;
      const Vec2 normal = Vec2{along.y, -along.x} * (1 / size);
      double highest = -1e300, lowest = 1e300;
      for (const Vec2 p : a) highest = std::max(highest, dot(normal, p - a[i]));
      for (const Vec2 p : b) lowest = std::min(lowest, dot(normal, p - a[i]));
      if (lowest >= highest - tolerance) return false;
    }
  }
  return true;
}

}  // namespace mansard
