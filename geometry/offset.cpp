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
    const Vec2 first = part.first - end, second = part.second - end;
    if (length(first) < touching || length(second) < touching) return;
    add_shadow(shadows, part, part.first + normalized(first) * far,
               part.second + normalized(second) * far);
  };
  seen_from(side.from, along * -1);
  seen_from(side.to, along);
}

/// The part of what a side sweeps over that it can see.
std::vector<Polygon> visible(const Side& side, std::span<const Segment> blockers) {
  const Polygon whole = ring_polygon(side.swept);
  std::vector<Polygon> shadows;
  for (const Segment& blocker : blockers) add_shadows(shadows, side, blocker);
  return subtract({&whole, 1}, shadows);
}

/// The part of the rival's figure that the rival reaches before this side does (the earlier one
/// when both arrive at the same time).
std::vector<Polygon> lost_to(const Side& rival, const Side& side, std::span<const Polygon> figure) {
  const auto time = [](const Side& s) {
    const Vec2 slope = s.normal * (1 / s.distance);
    return std::pair{slope, dot(slope, s.from)};
  };
  const auto [rival_slope, rival_start] = time(rival);
  const auto [slope, start] = time(side);
  const Vec2 change = rival_slope - slope;
  const double size = length(change);
  if (size < 1e-9 * length(slope)) {
    const double sooner = rival_start - start;
    const bool rival_first = sooner > 1e-9 || (sooner > -1e-9 && rival.edge < side.edge);
    return rival_first ? std::vector<Polygon>(figure.begin(), figure.end())
                       : std::vector<Polygon>{};
  }
  std::vector<Polygon> lost;
  for (const Polygon& piece : figure) {
    for (Polygon& part : clip(piece, change * (1 / size), (rival_start - start) / size)) {
      lost.push_back(std::move(part));
    }
  }
  return lost;
}

/// The general case: figures are cut to what their edges see, shared ground goes to the side that
/// reaches it first, and the inside is what no side reaches.
Inset resolve(const Polygon& polygon, std::span<const Side> sides, const Conflicts& conflicts) {
  std::vector<std::vector<Polygon>> figures;
  std::vector<Polygon> all;
  std::vector<TaggedEdge> edges = tagged_edges(polygon), inner_edges = edges;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    figures.push_back(visible(sides[i], conflicts.blockers[i]));
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
  result.inside = subtract({&polygon, 1}, all);
  take_tags(result.inside, inner_edges);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    std::vector<Polygon> lost;
    for (const uint32_t rival : conflicts.rivals[i]) {
      for (Polygon& part : lost_to(sides[rival], sides[i], figures[rival])) {
        if (part.has_holes() || !is_convex(part) ||
            convex_overlap(sides[i].swept, part.points, 0)) {
          lost.push_back(std::move(part));
        }
      }
    }
    std::vector<Polygon> strip = subtract(figures[i], lost);
    take_tags(strip, edges);
    std::move(strip.begin(), strip.end(), std::back_inserter(result.border));
  }
  return result;
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

/// What an outset adds: for every edge its strip up to the mitres of convex corners, and a triangle
/// at each bevel. `edges` collects the new edges.
std::vector<Polygon> outset_pieces(const Polygon& polygon, std::span<const MovedCorner> corners,
                                   double distance, std::vector<TaggedEdge>& edges) {
  std::vector<Polygon> pieces{polygon};
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), size = polygon.ring_ends[r] - begin;
    const auto out = [&](uint32_t i) {
      const Vec2 along = polygon.points[begin + (i + 1) % size] - polygon.points[begin + i % size];
      return left_of(normalized(along)) * -distance;
    };
    const auto has_mitre = [&](uint32_t i) {
      const uint32_t v = begin + i % size;
      return corners[v].mitred && cross(out(i + size - 1), out(i)) > 0 &&
             length(corners[v].in - polygon.points[v]) <= outset_mitre * distance;
    };
    for (uint32_t i = 0; i < size; ++i) {
      const uint32_t v = begin + i, next = begin + (i + 1) % size;
      const Vec2 from = polygon.points[v], to = polygon.points[next];
      const EdgeTag tag = polygon.tags[v];
      if (from == to) continue;
      const Vec2 low = has_mitre(i) ? corners[v].in : from + out(i);
      const Vec2 high = has_mitre(i + 1) ? corners[next].in : to + out(i);
      pieces.push_back(ring_polygon(std::array{from, to, high, low}));
      edges.push_back({low, high, tag});
      if (has_mitre(i + 1) || cross(out(i), out(i + 1)) < 0) continue;
      pieces.push_back(ring_polygon(std::array{to, to + out(i), to + out(i + 1)}));
      edges.push_back({to + out(i), to + out(i + 1), tag});
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
  return resolve(polygon, sides, conflicts);
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
  const std::vector<Polygon> pieces = outset_pieces(polygon, corners, distance, edges);
  std::vector<Polygon> result = unite(pieces);
  take_tags(result, edges);
  return result;
}

}  // namespace mansard
