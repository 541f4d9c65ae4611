#include "geometry/offset.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/clip.hpp"
#include "geometry/clip_boolean.hpp"
#include "geometry/offset_sides.hpp"

namespace mansard {
namespace {

/// Figures that share less than this width, in metres, only touch.
constexpr double touching = 1e-8;
/// Mitres of outsets, in distances.
constexpr double outset_mitre = 4;

using Segment = std::pair<Vec2, Vec2>;

Box2 grown(std::span<const Vec2> points) {
  const Box2 box = bounds(points);
  return {box.low - Vec2{touching, touching}, box.high + Vec2{touching, touching}};
}

bool boxes_meet(const Box2& a, const Box2& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

Polygon ring_polygon(std::span<const Vec2> points) {
  Polygon result;
  for (const Vec2 p : points) result.add_point(p);
  result.close_ring();
  orient(result);
  return result;
}

/// Which sides sweep over each other, and over which edges of the polygon.
struct Conflicts {
  std::vector<std::vector<uint32_t>> rivals;   ///< of each side: other sides
  std::vector<std::vector<Segment>> blockers;  ///< of each side: edges in its way
  bool none = true;
};

Conflicts find_conflicts(const Polygon& polygon, std::span<const Side> sides) {
  Conflicts result;
  result.rivals.resize(sides.size());
  result.blockers.resize(sides.size());
  std::vector<Box2> boxes;
  for (const Side& side : sides) boxes.push_back(grown(side.swept));
  for (uint32_t i = 0; i < sides.size(); ++i) {
    for (uint32_t j = i + 1; j < sides.size(); ++j) {
      if (!boxes_meet(boxes[i], boxes[j])) continue;
      if (!convex_overlap(sides[i].swept, sides[j].swept, touching)) continue;
      result.rivals[i].push_back(j);
      result.rivals[j].push_back(i);
      result.none = false;
    }
    for_each_edge(polygon, [&](uint32_t edge, Vec2 from, Vec2 to) {
      const Vec2 segment[] = {from, to};
      if (edge == sides[i].edge || !boxes_meet(boxes[i], bounds(segment))) return;
      if (!convex_overlap(sides[i].swept, segment, touching)) return;
      result.blockers[i].push_back({from, to});
      result.none = false;
    });
  }
  return result;
}

/// The part of a segment where dot(normal, p) >= offset; false when that is at most a point.
bool clip_segment(Segment& segment, Vec2 normal, double offset) {
  const double a = dot(normal, segment.first) - offset, b = dot(normal, segment.second) - offset;
  if (a <= 0 && b <= 0) return false;
  if (a < 0) segment.first = mix(segment.first, segment.second, a / (a - b));
  if (b < 0) segment.second = mix(segment.second, segment.first, b / (b - a));
  return true;
}

void add_shadow(std::vector<Polygon>& shadows, const Segment& segment, Vec2 behind_first,
                Vec2 behind_second) {
  const Vec2 corners[] = {segment.first, segment.second, behind_second, behind_first};
  if (std::abs(area(corners)) > 1e-12) shadows.push_back(ring_polygon(corners));
}

/// What `blocker` hides from the side: straight ahead of the edge, and, beyond its ends (where the
/// mitres of reflex corners reach), as seen from the end.
void add_shadows(std::vector<Polygon>& shadows, const Side& side, Segment blocker) {
  const Vec2 along = normalized(side.to - side.from);
  if (!clip_segment(blocker, side.normal, dot(side.normal, side.from))) return;
  const Box2 box = bounds(side.swept);
  const double far = 4 * (length(box.size()) + side.distance);
  const double low = dot(along, side.from), high = dot(along, side.to);

  Segment ahead = blocker;
  if (clip_segment(ahead, along, low) && clip_segment(ahead, along * -1, -high)) {
    const Vec2 up = side.normal * far;
    add_shadow(shadows, ahead, ahead.first + up, ahead.second + up);
  }
  const auto seen_from = [&](Vec2 end, Vec2 outwards) {
    Segment part = blocker;
    if (!clip_segment(part, outwards, dot(outwards, end))) return;
    Vec2 first = part.first - end, second = part.second - end;
    const bool first_there = length(first) < touching, second_there = length(second) < touching;
    if (first_there && second_there) return;
    if (first_there || second_there) {
      // An edge that starts at the end itself hides what lies beyond it.
      (first_there ? first : second) = outwards;
      part = {end, end};
    }
    add_shadow(shadows, part, part.first + normalized(first) * far,
               part.second + normalized(second) * far);
  };
  seen_from(side.from, along * -1);
  seen_from(side.to, along);
}

/// The part of what a side sweeps over that it can see.
std::vector<Polygon> visible(const Side& side, std::span<const Segment> blockers,
                             Precision precision) {
  const Polygon whole = ring_polygon(side.swept);
  std::vector<Polygon> shadows;
  for (const Segment& blocker : blockers) add_shadows(shadows, side, blocker);
  return subtract({&whole, 1}, shadows, precision);
}

/// Where one side arrives before another: dot(normal, p) <= offset, or everywhere, or nowhere.
struct Sooner {
  Vec2 normal;
  double offset = 0;
  bool everywhere = false, nowhere = false;
};

Sooner where_sooner(const Side& first, const Side& second) {
  const Vec2 first_slope = first.normal * (1 / first.distance);
  const Vec2 second_slope = second.normal * (1 / second.distance);
  const Vec2 change = first_slope - second_slope;
  const double size = length(change);
  const double lead = dot(first_slope, first.from) - dot(second_slope, second.from);
  if (size >= 1e-9 * length(second_slope)) return {change * (1 / size), lead / size};
  // Parallel and as fast; when both arrive at once, the earlier edge is the first.
  const bool first_wins = lead > 1e-9 || (lead > -1e-9 && first.edge < second.edge);
  return {{}, 0, first_wins, !first_wins};
}

std::vector<Polygon> clip(const Polygon& polygon, const Sooner& where) {
  if (where.nowhere) return {};
  if (where.everywhere) return {polygon};
  return clip(polygon, where.normal, where.offset);
}

bool inside_convex(std::span<const Vec2> points, std::span<const Vec2> convex) {
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Vec2 along = normalized(convex[(i + 1) % convex.size()] - convex[i]);
    for (const Vec2 p : points) {
      if (cross(along, p - convex[i]) < -touching) return false;
    }
  }
  return true;
}

/// Takes from the strip what the rival, on its figure, reaches before this side does. Where the
/// figure holds all of the strip beyond their bisector, a cut is enough; else what is lost is
/// collected.
void lose_to(const Side& rival, const Side& side, std::span<const Polygon> figure,
             std::vector<Polygon>& strip, std::vector<Polygon>& lost) {
  const Sooner sooner = where_sooner(rival, side);
  const bool convex = figure.size() == 1 && is_convex(figure[0]);
  bool all_held = convex;
  for (std::size_t i = 0; i < strip.size() && all_held; ++i) {
    for (const Polygon& part : clip(strip[i], sooner)) {
      all_held = all_held && inside_convex(part.points, figure[0].points);
    }
  }
  if (all_held) {
    const Sooner later{sooner.normal * -1, -sooner.offset, sooner.nowhere, sooner.everywhere};
    std::vector<Polygon> left;
    for (const Polygon& piece : strip) {
      for (Polygon& part : clip(piece, later)) left.push_back(std::move(part));
    }
    strip = std::move(left);
    return;
  }
  for (const Polygon& piece : figure) {
    for (Polygon& part : clip(piece, sooner)) {
      if (!convex || convex_overlap(side.swept, part.points, 0)) lost.push_back(std::move(part));
    }
  }
}

/// The general case: figures are cut to what their edges see, shared ground goes to the side that
/// reaches it first, and the inside is what no side reaches.
Inset resolve(const Polygon& polygon, std::span<const Side> sides, const Conflicts& conflicts,
              Precision precision) {
  std::vector<std::vector<Polygon>> figures;
  std::vector<Polygon> all;
  std::vector<TaggedEdge> edges = tagged_edges(polygon), inner_edges = edges;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    figures.push_back(visible(sides[i], conflicts.blockers[i], precision));
    if (precision == Precision::grid) {
      // Rings that touch let figures through; rare, and too dear to do always.
      figures.back() = intersect(figures.back(), {&polygon, 1}, precision);
    }
    all.insert(all.end(), figures.back().begin(), figures.back().end());
    const EdgeTag tag = polygon.tags[sides[i].edge];
    inner_edges.push_back({sides[i].moved_from, sides[i].moved_to, tag});
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (TaggedEdge edge : tagged_edges(ring_polygon(sides[i].swept))) {
      edge.tag = polygon.tags[sides[i].edge];
      inner_edges.push_back(edge);
    }
  }

  Inset result;
  result.inside = subtract({&polygon, 1}, all, precision);
  take_tags(result.inside, inner_edges);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    std::vector<Polygon> strip = figures[i], lost;
    for (const uint32_t rival : conflicts.rivals[i]) {
      lose_to(sides[rival], sides[i], figures[rival], strip, lost);
    }
    strip = subtract(strip, lost, precision);
    take_tags(strip, edges);
    std::move(strip.begin(), strip.end(), std::back_inserter(result.border));
  }
  return result;
}

bool covers(const Polygon& polygon, const Inset& inset) {
  double sum = -area(polygon);
  for (const Polygon& piece : inset.inside) sum += area(piece);
  for (const Polygon& piece : inset.border) sum += area(piece);
  return std::abs(sum) <= touching * (10 + perimeter(polygon));
}

/// The plain case: no figure meets another, and every corner has one new place.
Inset plain_setback(const Polygon& polygon, std::span<const Side> sides,
                    std::span<const MovedCorner> corners) {
  Inset result;
  Polygon inside = polygon;
  for (std::size_t i = 0; i < corners.size(); ++i) inside.points[i] = corners[i].in;
  const std::vector<TaggedEdge> edges = tagged_edges(polygon);
  for (const Side& side : sides) {
    const std::size_t ring =
        std::upper_bound(polygon.ring_ends.begin(), polygon.ring_ends.end(), side.edge) -
        polygon.ring_ends.begin();
    const uint32_t begin = polygon.ring_begin(ring), size = polygon.ring_ends[ring] - begin;
    const uint32_t place = side.edge - begin;
    const TaggedEdge near[] = {edges[side.edge], edges[begin + (place + 1) % size],
                               edges[begin + (place + size - 1) % size]};
    std::vector<Polygon> strip{ring_polygon(side.swept)};
    take_tags(strip, near);
    result.border.push_back(std::move(strip.front()));
  }
  result.inside.push_back(std::move(inside));
  return result;
}

bool plain(std::span<const Side> sides, std::span<const MovedCorner> corners,
           const Conflicts& conflicts) {
  return conflicts.none &&
         std::none_of(sides.begin(), sides.end(), [](const Side& s) { return s.vanished; }) &&
         std::all_of(corners.begin(), corners.end(), [](const MovedCorner& c) { return c.mitred; });
}

/// The new ends of two edges at a convex corner: one mitre, or two ends of a bevel that passes the
/// corner at the distance.
std::pair<Vec2, Vec2> outset_corner(Vec2 v, Vec2 in, Vec2 out, double distance) {
  const double turn = std::atan2(cross(in, out), dot(in, out));
  const bool mitre = 1 <= outset_mitre * std::cos(turn / 2);
  const double reach = distance * std::tan(mitre ? turn / 2 : turn / 4);
  const Vec2 first = v - left_of(in) * distance + in * reach;
  return {first, mitre ? first : v - left_of(out) * distance - out * reach};
}

/// What an outset adds: for every edge its strip up to the mitres of convex corners, and a triangle
/// at each bevel. `edges` collects the new edges.
std::vector<Polygon> outset_pieces(const Polygon& polygon, double distance,
                                   std::vector<TaggedEdge>& edges) {
  std::vector<Polygon> pieces{polygon};
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const auto ring = polygon.ring(r);
    const auto at = [&](std::size_t i) { return ring[i % ring.size()]; };
    const auto along = [&](std::size_t i) { return normalized(at(i + 1) - at(i)); };
    const auto corner = [&](std::size_t i) {  // between edges i and i + 1
      const Vec2 v = at(i + 1), in = along(i), out = along(i + 1);
      if (cross(in, out) > 0) return outset_corner(v, in, out, distance);
      return std::pair{v - left_of(in) * distance, v - left_of(out) * distance};
    };
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const EdgeTag tag = polygon.tags[polygon.ring_begin(r) + i];
      const Vec2 low = corner(i + ring.size() - 1).second;
      const auto [high, beyond] = corner(i);
      pieces.push_back(ring_polygon(std::array{at(i), at(i + 1), high, low}));
      edges.push_back({low, high, tag});
      if (high == beyond || cross(along(i), along(i + 1)) < 0) continue;
      pieces.push_back(ring_polygon(std::array{at(i + 1), high, beyond}));
      edges.push_back({high, beyond, tag});
    }
  }
  return pieces;
}

}  // namespace

Inset setback(const Polygon& polygon, const std::function<double(uint32_t edge)>& distance) {
  if (polygon.points.size() < 3) return {};
  // Nothing is left further in than the polygon is long; more only costs digits.
  const double most = 2 * length(bounds(polygon.points).size());
  std::vector<double> distances;
  for (uint32_t i = 0; i < polygon.points.size(); ++i) {
    const double d = distance(i);
    distances.push_back(d > touching ? std::min(d, most) : 0);
  }
  const std::vector<MovedCorner> corners = move_corners(polygon, distances);
  const std::vector<Side> sides = moved_sides(polygon, distances, corners);
  if (sides.empty()) return {{polygon}, {}};
  const Conflicts conflicts = find_conflicts(polygon, sides);
  if (plain(sides, corners, conflicts)) return plain_setback(polygon, sides, corners);
  const std::vector<Side> wide =
      moved_sides(polygon, distances, widen(polygon, distances, corners));
  const Conflicts wide_conflicts = find_conflicts(polygon, wide);
  Inset result = resolve(polygon, wide, wide_conflicts, Precision::floating);
  if (!covers(polygon, result)) result = resolve(polygon, wide, wide_conflicts, Precision::grid);
  return result;
}

std::vector<Polygon> outset(const Polygon& polygon, double distance) {
  if (polygon.points.size() < 3) return {};
  if (!(distance > touching)) return {polygon};
  const std::vector<double> distances(polygon.points.size(), -distance);
  const std::vector<MovedCorner> corners = move_corners(polygon, distances);
  const std::vector<Side> sides = moved_sides(polygon, distances, corners);
  bool short_mitres = true;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double reach = length(corners[i].in - polygon.points[i]);
    short_mitres = short_mitres && reach <= outset_mitre * distance;
  }
  if (short_mitres && plain(sides, corners, find_conflicts(polygon, sides))) {
    Polygon moved = polygon;
    for (std::size_t i = 0; i < corners.size(); ++i) moved.points[i] = corners[i].in;
    return {moved};
  }
  std::vector<TaggedEdge> edges;
  const std::vector<Polygon> pieces = outset_pieces(polygon, distance, edges);
  std::vector<Polygon> result = unite(pieces, Precision::floating);
  if (result.size() != 1) result = unite(pieces, Precision::grid);
  take_tags(result, edges);
  return result;
}

}  // namespace mansard
