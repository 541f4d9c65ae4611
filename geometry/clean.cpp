#include "geometry/clean.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mansard {
namespace {

struct Corner {
  Vec2 point;
  uint32_t number;  // of the point in the original
};

// A ring on its way, and which original edges turned out to be sides of spikes.
struct Ring {
  std::vector<Corner> corners;
  uint32_t begin, end;  // its points in the original
  std::vector<char>& spikes;
};

bool finite(const Polygon& polygon) {
  return std::all_of(polygon.points.begin(), polygon.points.end(),
                     [](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

Ring ring_of(const Polygon& polygon, std::size_t r, std::vector<char>& spikes) {
  Ring ring{{}, polygon.ring_begin(r), polygon.ring_ends[r], spikes};
  for (uint32_t i = ring.begin; i < ring.end; ++i) ring.corners.push_back({polygon.points[i], i});
  return ring;
}

double signed_area(const std::vector<Corner>& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    twice +=
        cross(ring[i].point - ring[0].point, ring[(i + 1) % ring.size()].point - ring[0].point);
  }
  return twice / 2;
}

void drop_near(std::vector<Corner>& ring, double near) {
  std::vector<Corner> kept;
  for (const Corner& c : ring) {
    if (kept.empty() || length(c.point - kept.back().point) >= near) kept.push_back(c);
  }
  while (kept.size() > 1 && length(kept.back().point - kept.front().point) < near) kept.pop_back();
  ring = std::move(kept);
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double l2 = dot(d, d);
  const double t = l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0;
  return length(p - (a + d * t));
}

// Of the spike a-b-c what a-c does not replace.
void mark_spike(const Ring& ring, const Polygon& original, const Corner& a, const Corner& b,
                const Corner& c, double near) {
  const Vec2 along = normalized(c.point - a.point);
  const bool there = length(b.point - a.point) > length(c.point - b.point);
  const auto mark = [&](const Corner& from, const Corner& to, bool stays) {
    for (uint32_t i = from.number; i != to.number;) {
      const uint32_t next = i + 1 == ring.end ? ring.begin : i + 1;
      const double reach = std::max(dot(original.points[i] - a.point, along),
                                    dot(original.points[next] - a.point, along));
      const double start = std::min(dot(original.points[i] - a.point, along),
                                    dot(original.points[next] - a.point, along));
      const double end = length(c.point - a.point);
      if (!stays || std::min(reach, end) - std::max(start, 0.0) < near) ring.spikes[i] = 1;
      i = next;
    }
  };
  mark(a, b, there);
  mark(b, c, !there);
}

// Drops what lies on the line through its neighbours, forwards (a collinear point) or backwards
// (the tip of a spike), as long as everything dropped before stays within the tolerance too.
void drop_flat(Ring& whole, const Polygon& original, const CleanTolerance& tolerance) {
  std::vector<Corner>& ring = whole.corners;
  const double flat = tolerance.flat;
  std::vector<std::vector<Vec2>> gone(ring.size());  // dropped points along each edge
  bool again = true;
  while (again && ring.size() > 2) {
    again = false;
    for (std::size_t i = 0; i < ring.size() && ring.size() > 2;) {
      const std::size_t n = ring.size(), before = (i + n - 1) % n, after = (i + 1) % n;
      const Vec2 a = ring[before].point, b = ring[i].point, c = ring[after].point;
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
      if (collinear) {
        gone[before].push_back(b);
        gone[before].insert(gone[before].end(), gone[i].begin(), gone[i].end());
      } else {
        mark_spike(whole, original, ring[before], ring[i], ring[after], tolerance.near);
      }
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      gone.erase(gone.begin() + static_cast<std::ptrdiff_t>(i));
      again = true;
    }
  }
}

bool clean_ring(Ring& ring, const Polygon& original, const CleanTolerance& tolerance, bool hole) {
  drop_near(ring.corners, tolerance.near);
  drop_flat(ring, original, tolerance);
  drop_near(ring.corners, tolerance.near);  // a spike's two sides end in one point
  if (ring.corners.size() < 3) return false;
  const double area = signed_area(ring.corners);
  if (!(std::abs(area) > (hole ? tolerance.hole : 1e-6))) return false;
  if ((area < 0) != hole) std::reverse(ring.corners.begin(), ring.corners.end());
  return true;
}

void add_ring(Cleaned& cleaned, const Ring& ring) {
  for (const Corner& c : ring.corners) {
    cleaned.polygon.add_point(c.point);
    cleaned.points.push_back(c.number);
  }
  cleaned.polygon.close_ring();
}

// Which edge each original edge became part of, and the longest part of each edge.
void map_edges(Cleaned& cleaned, const Polygon& original, const std::vector<char>& spikes) {
  cleaned.edge_of.assign(original.points.size(), Cleaned::no_edge);
  cleaned.edges = cleaned.points;
  std::vector<double> longest(cleaned.points.size(), -1);
  std::size_t ring = 0;
  for (std::size_t r = 0; r < cleaned.polygon.rings(); ++r) {
    const uint32_t begin = cleaned.polygon.ring_begin(r), end = cleaned.polygon.ring_ends[r];
    while (original.ring_ends[ring] <= cleaned.points[begin]) ++ring;
    const uint32_t first = original.ring_begin(ring), last = original.ring_ends[ring];
    // Numbers go down instead of up in rings that were turned round.
    int descents = 0;
    for (uint32_t i = begin; i < end; ++i) {
      descents += cleaned.points[i + 1 == end ? begin : i + 1] < cleaned.points[i];
    }
    for (uint32_t i = begin; i < end; ++i) {
      uint32_t from = cleaned.points[i], to = cleaned.points[i + 1 == end ? begin : i + 1];
      if (descents > 1) std::swap(from, to);
      for (uint32_t e = from; e != to;) {
        const uint32_t next = e + 1 == last ? first : e + 1;
        const double size = length(original.points[next] - original.points[e]);
        if (!spikes[e]) cleaned.edge_of[e] = i;
        if (!spikes[e] && size > longest[i]) {
          longest[i] = size;
          cleaned.edges[i] = e;
        }
        e = next;
      }
      cleaned.polygon.tags[i] = original.tags[cleaned.edges[i]];
    }
  }
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
      kept.points.push_back(cleaned.points[i]);
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

// What a look at every corner says of a ring.
struct Look {
  bool tidy = true;    // nothing to drop or to turn
  bool convex = true;  // so that it can not touch itself
};

// Asks for a little more than drop_near and drop_flat do.
Look look_at(std::span<const Vec2> ring, const CleanTolerance& tolerance, bool hole) {
  const std::size_t n = ring.size();
  if (n < 3) return {false, false};
  Look look;
  const double near = tolerance.near * tolerance.near, flat = tolerance.flat * tolerance.flat;
  double twice = 0, last_x = 0;
  int turns_of_x = 0;
  Vec2 in = ring[0] - ring[n - 1];
  double in2 = dot(in, in);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 out = ring[i + 1 < n ? i + 1 : 0] - ring[i], over = in + out;
    const double out2 = dot(out, out), turn = cross(in, out);
    look.tidy &= out2 > near && turn * turn > flat * std::max({in2, out2, dot(over, over)});
    look.convex &= turn > 0;
    twice += cross(ring[i] - ring[0], out);
    turns_of_x += last_x * out.x < 0;
    if (out.x != 0) last_x = out.x;
    in = out;
    in2 = out2;
  }
  look.convex &= turns_of_x <= 2;  // once around
  look.tidy &= hole ? twice < -2 * tolerance.hole : twice > 2e-6;
  return look;
}

void take_whole(Cleaned& cleaned, const Polygon& polygon) {
  cleaned.polygon = polygon;
  cleaned.points.resize(polygon.points.size());
  std::iota(cleaned.points.begin(), cleaned.points.end(), 0u);
}

bool take_cleaned(Cleaned& cleaned, const Polygon& polygon, const CleanTolerance& tolerance,
                  std::vector<char>& spikes) {
  spikes.assign(polygon.points.size(), 0);
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    Ring ring = ring_of(polygon, r, spikes);
    if (clean_ring(ring, polygon, tolerance, r > 0)) {
      add_ring(cleaned, ring);
    } else if (r == 0) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::optional<Cleaned> clean(const Polygon& polygon, const CleanTolerance& tolerance) {
  constexpr std::size_t hopeless = 20000;  // points: it would take seconds, and then be refused
  if (polygon.empty() || polygon.points.size() > hopeless || !finite(polygon)) return std::nullopt;
  Look look;
  for (std::size_t r = 0; r < polygon.rings() && look.tidy; ++r) {
    look = look_at(polygon.ring(r), tolerance, r > 0);
  }
  Cleaned cleaned;
  std::vector<char> spikes;
  if (look.tidy) {
    take_whole(cleaned, polygon);
  } else if (!take_cleaned(cleaned, polygon, tolerance, spikes)) {
    return std::nullopt;
  }
  if (cleaned.polygon.points.size() > tolerance.most_points) return std::nullopt;
  if (cleaned.polygon.rings() > 1) drop_stray_holes(cleaned);
  if (look.tidy && cleaned.polygon.rings() == polygon.rings()) {
    cleaned.edges = cleaned.edge_of = cleaned.points;
  } else {
    spikes.resize(polygon.points.size());
    map_edges(cleaned, polygon, spikes);
  }
  if (look.tidy && look.convex && polygon.rings() == 1) return cleaned;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const std::vector<Contact> touching = contacts(cleaned.polygon, tolerance.gap);
    if (touching.empty()) return cleaned;
    move_apart(cleaned.polygon, touching, tolerance.part);
    cleaned.moved = true;
  }
  return std::nullopt;
}

}  // namespace mansard
