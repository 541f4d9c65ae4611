#include "geometry/clean.hpp"

#include <algorithm>
#include <cmath>

namespace mansard {
namespace {

struct Corner {
  Vec2 point;
  EdgeTag tag;        // of the longest part of the edge that starts here
  uint32_t edge = 0;  // its number in the original
  double longest = 0;
};
using Ring = std::vector<Corner>;

Ring corners_of(const Polygon& polygon, std::size_t r) {
  Ring ring;
  const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
  for (uint32_t i = begin; i < end; ++i) {
    const Vec2 p = polygon.points[i], q = polygon.points[i + 1 == end ? begin : i + 1];
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return {};
    ring.push_back({p, polygon.tags[i], i, length(q - p)});
  }
  return ring;
}

double signed_area(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    twice +=
        cross(ring[i].point - ring[0].point, ring[(i + 1) % ring.size()].point - ring[0].point);
  }
  return twice / 2;
}

// The edge that starts at `into` takes over the one that started at `dropped`.
void merge(Corner& into, const Corner& dropped) {
  if (dropped.longest <= into.longest) return;
  into.tag = dropped.tag;
  into.edge = dropped.edge;
  into.longest = dropped.longest;
}

// Reversed rings: edge i then starts where it ended.
void reverse(Ring& ring) {
  Ring turned;
  for (std::size_t i = ring.size(); i-- > 0;) {
    Corner c = ring[i];
    c.point = ring[(i + 1) % ring.size()].point;
    turned.push_back(c);
  }
  ring = std::move(turned);
}

void drop_near(Ring& ring, double near) {
  Ring kept;
  for (const Corner& c : ring) {
    if (!kept.empty() && length(c.point - kept.back().point) < near) {
      merge(kept.back(), c);
    } else {
      kept.push_back(c);
    }
  }
  while (kept.size() > 1 && length(kept.back().point - kept.front().point) < near) {
    merge(kept[kept.size() - 2], kept.back());
    kept.pop_back();
  }
  ring = std::move(kept);
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double l2 = dot(d, d);
  const double t = l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0;
  return length(p - (a + d * t));
}

// Drops what lies on the line through its neighbours, forwards (a collinear point) or backwards
// (the tip of a spike), as long as everything dropped before stays within the tolerance too.
void drop_flat(Ring& ring, double flat) {
  std::vector<std::vector<Vec2>> gone(ring.size());  // dropped points along each edge
  bool again = true;
  while (again && ring.size() > 2) {
    again = false;
    for (std::size_t i = 0; i < ring.size() && ring.size() > 2;) {
      const std::size_t n = ring.size(), before = (i + n - 1) % n;
      const Vec2 a = ring[before].point, b = ring[i].point, c = ring[(i + 1) % n].point;
      const bool spike = dot(b - a, c - b) < 0 && std::min(distance_to_segment(c, a, b),
                                                           distance_to_segment(a, b, c)) < flat;
      const auto fits = [&](Vec2 p) { return distance_to_segment(p, a, c) < flat; };
      const bool collinear = fits(b) &&
                             std::all_of(gone[before].begin(), gone[before].end(), fits) &&
                             std::all_of(gone[i].begin(), gone[i].end(), fits);
      if (!spike && !collinear) {
        ++i;
        continue;
      }
      merge(ring[before], ring[i]);
      if (collinear) {
        gone[before].push_back(b);
        gone[before].insert(gone[before].end(), gone[i].begin(), gone[i].end());
      }
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      gone.erase(gone.begin() + static_cast<std::ptrdiff_t>(i));
      again = true;
    }
  }
}

bool clean_ring(Ring& ring, const CleanTolerance& tolerance, bool hole) {
  drop_near(ring, tolerance.near);
  drop_flat(ring, tolerance.flat);
  drop_near(ring, tolerance.near);  // a spike's two sides end in one point
  if (ring.size() < 3) return false;
  const double area = signed_area(ring);
  if (!(std::abs(area) > (hole ? tolerance.hole : 1e-6))) return false;
  if ((area < 0) != hole) reverse(ring);
  return true;
}

void add_ring(Cleaned& cleaned, const Ring& ring) {
  for (const Corner& c : ring) {
    cleaned.polygon.add_point(c.point, c.tag);
    cleaned.edges.push_back(c.edge);
  }
  cleaned.polygon.close_ring();
}

bool inside(Vec2 p, std::span<const Vec2> ring) {
  bool in = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 a = ring[i], b = ring[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) in = !in;
  }
  return in;
}

// By its middle, since corners may touch other rings.
bool holds(const Polygon& polygon, std::size_t ring, std::size_t hole) {
  const std::span<const Vec2> points = polygon.ring(hole);
  return inside(mix(mix(points[0], points[1], 0.5), points[2], 1e-3), polygon.ring(ring));
}

// Holes outside of the outline or inside of other holes are none.
void drop_stray_holes(Cleaned& cleaned) {
  const Polygon& old = cleaned.polygon;
  Cleaned kept;
  for (std::size_t r = 0; r < old.rings(); ++r) {
    bool stray = r > 0 && !holds(old, 0, r);
    for (std::size_t other = 1; other < old.rings() && r > 0 && !stray; ++other) {
      stray = other != r && std::abs(area(old.ring(other))) > std::abs(area(old.ring(r))) &&
              holds(old, other, r);
    }
    if (stray) continue;
    for (uint32_t i = old.ring_begin(r); i < old.ring_ends[r]; ++i) {
      kept.polygon.add_point(old.points[i], old.tags[i]);
      kept.edges.push_back(cleaned.edges[i]);
    }
    kept.polygon.close_ring();
  }
  cleaned = std::move(kept);
}

struct Corners {
  std::vector<uint32_t> before, after, ring;  // of each point
};

Corners corners_of(const Polygon& polygon) {
  const std::size_t n = polygon.points.size();
  Corners corners{std::vector<uint32_t>(n), std::vector<uint32_t>(n), std::vector<uint32_t>(n)};
  for (uint32_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) {
      corners.ring[i] = r;
      corners.after[i] = i + 1 == end ? begin : i + 1;
      corners.before[corners.after[i]] = i;
    }
  }
  return corners;
}

// Whether the polygon lies between a point and the edge it touches, and not the outside.
bool pinched(const Polygon& polygon, const Corners& corners, const Contact& contact) {
  const uint32_t p = contact.point, from = contact.edge, to = corners.after[contact.edge];
  if (corners.ring[p] != corners.ring[from]) return true;
  const auto at = [&](uint32_t i) { return polygon.points[i]; };
  const auto left_of_edge = [&](uint32_t i, Vec2 d) {
    return cross(at(corners.after[i]) - at(i), d) > 0;
  };
  const Vec2 arm = at(corners.after[p]) - at(p);
  for (const uint32_t q : {from, to}) {
    if (length(at(q) - at(p)) > 1e-3) continue;
    const uint32_t before = corners.before[q];
    const bool convex = left_of_edge(before, at(corners.after[q]) - at(q));
    const bool left1 = left_of_edge(before, arm), left2 = left_of_edge(q, arm);
    return convex ? left1 && left2 : left1 || left2;
  }
  return left_of_edge(from, arm);
}

// Where the polygon is pinched to nothing between a point and an edge, the point moves outwards;
// where two parts of its outline touch from outside, inwards. Either opens a gap of about `part`.
void move_apart(Polygon& polygon, const std::vector<Contact>& touching, double part) {
  const Polygon old = polygon;
  const Corners corners = corners_of(old);
  std::vector<char> moved(old.points.size(), 0);
  for (const Contact& contact : touching) {
    const uint32_t i = contact.point;
    if (moved[i]) continue;
    moved[i] = 1;
    const Vec2 p = old.points[i];
    const Vec2 n1 = left_of(normalized(p - old.points[corners.before[i]]));
    const Vec2 n2 = left_of(normalized(old.points[corners.after[i]] - p));
    const Vec2 inwards = normalized(n1 + n2);
    polygon.points[i] = p + inwards * (pinched(old, corners, contact) ? -part : part);
  }
}

}  // namespace

std::optional<Cleaned> clean(const Polygon& polygon, const CleanTolerance& tolerance) {
  constexpr std::size_t hopeless = 20000;  // points: it would take seconds, and then be refused
  if (polygon.points.size() > hopeless) return std::nullopt;
  Cleaned cleaned;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    Ring ring = corners_of(polygon, r);
    if (clean_ring(ring, tolerance, r > 0)) {
      add_ring(cleaned, ring);
    } else if (r == 0) {
      return std::nullopt;
    }
  }
  if (cleaned.polygon.empty() || cleaned.polygon.points.size() > tolerance.most_points) {
    return std::nullopt;
  }
  if (cleaned.polygon.rings() > 1) drop_stray_holes(cleaned);
  for (int attempt = 0; attempt < 3; ++attempt) {
    const std::vector<Contact> touching = contacts(cleaned.polygon, tolerance.gap);
    if (touching.empty()) return cleaned;
    move_apart(cleaned.polygon, touching, tolerance.part);
    cleaned.moved = true;
  }
  return std::nullopt;
}

}  // namespace mansard
