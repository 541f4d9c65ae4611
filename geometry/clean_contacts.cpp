// Where a polygon touches or crosses itself.
#include <algorithm>

#include "geometry/clean.hpp"

namespace mansard {
namespace {

struct Edge {
  Vec2 from, to;
  uint32_t number, next;
  double low_x, high_x, low_y, high_y;
};

std::vector<Edge> edges_of(const Polygon& polygon) {
  std::vector<Edge> edges;
  edges.reserve(polygon.points.size());
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t next = i + 1 == end ? begin : i + 1;
      const Vec2 a = polygon.points[i], b = polygon.points[next];
      edges.push_back({a, b, i, next, std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y),
                       std::max(a.y, b.y)});
    }
  }
  return edges;
}

// Squared.
double distance(Vec2 p, const Edge& e) {
  const Vec2 d = e.to - e.from, to_p = p - e.from;
  const double l2 = dot(d, d), along = dot(to_p, d);
  const Vec2 off = along <= 0 ? to_p : along >= l2 ? p - e.to : to_p - d * (along / l2);
  return dot(off, off);
}

bool cross_each_other(const Edge& a, const Edge& b) {
  const Vec2 da = a.to - a.from, db = b.to - b.from;
  const double a1 = cross(da, b.from - a.from), a2 = cross(da, b.to - a.from);
  const double b1 = cross(db, a.from - b.from), b2 = cross(db, a.to - b.from);
  return ((a1 > 0) != (a2 > 0)) && ((b1 > 0) != (b2 > 0));
}

void add_contacts(const Edge& a, const Edge& b, double gap, std::vector<Contact>& found) {
  const std::size_t before = found.size();
  const auto try_point = [&](Vec2 p, uint32_t number, const Edge& e) {
    if (number != e.number && number != e.next && distance(p, e) < gap * gap) {
      found.push_back({number, e.number});
    }
  };
  try_point(a.from, a.number, b);
  try_point(a.to, a.next, b);
  try_point(b.from, b.number, a);
  try_point(b.to, b.next, a);
  const bool neighbours = a.next == b.number || b.next == a.number;
  if (found.size() == before && !neighbours && cross_each_other(a, b)) {
    found.push_back({a.number, b.number});
  }
}

}  // namespace

std::vector<Contact> contacts(const Polygon& polygon, double gap) {
  std::vector<Edge> edges = edges_of(polygon);
  constexpr std::size_t few = 24;  // edges, to compare all with all
  const bool sweep = edges.size() > few;
  if (sweep) {
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return a.low_x != b.low_x ? a.low_x < b.low_x : a.number < b.number;
    });
  }
  std::vector<Contact> found;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& a = edges[i];
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Edge& b = edges[j];
      if (b.low_x > a.high_x + gap) {
        if (sweep) break;
        continue;
      }
      if (a.low_x > b.high_x + gap) continue;
      if (b.low_y <= a.high_y + gap && a.low_y <= b.high_y + gap) add_contacts(a, b, gap, found);
    }
    if (found.size() > edges.size()) break;  // hopeless, and quadratic to list
  }
  return found;
}

}  // namespace mansard
