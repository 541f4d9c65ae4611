// The straight skeleton as the trace of a wavefront: the polygon's edges move
// inwards at unit speed, and the corners between them draw the skeleton's arcs
// (Aichholzer & Aurenhammer 1996). In doubles and without care for events at
// one time and place: those are the business of whoever jitters the polygon
// before, and checks the result after (Huber 2012 §2 tells what goes wrong). A
// corner looks for what it may run into among all edges, which is quick below
// some hundred.
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/skeleton.hpp"

namespace mansard {
namespace {

constexpr uint32_t none = ~0u;
constexpr double never = std::numeric_limits<double>::infinity();

// A corner of the wavefront, between the edges `left` (which ends here) and
// `right`. It is also the arc that it draws, from the node it is born at to the
// one it dies at: upwards along the face of `left`, downwards along the face of
// `right`.
struct Corner {
  Vec2 at;  // where it was born
  double since;
  Vec2 velocity;
  uint32_t left, right;
  uint32_t before, after;  // its neighbours on the wavefront
  uint32_t born, dead;     // nodes
  uint32_t next_up,
      next_down;              // the half-arcs that follow its own around their faces
  uint32_t twin;              // the next corner in the list of those that begin parts of `right`
  double collapse;            // when the edge to `after` vanishes
  double split;               // when it may run into an edge, which
  uint32_t split_edge;        // is this one
  uint32_t ahead, ahead_end;  // the edges it may run into after that, as far as looked for
  bool reflex;

  Vec2 place(double time) const { return at + velocity * (time - since); }
};

// The times of things, and the earliest: by blocks, so that few are looked at.
class Schedule {
 public:
  explicit Schedule(std::size_t most) { times_.reserve(most + block); }

  void set(uint32_t i, double time) {
    while (i >= times_.size()) {
      times_.resize(times_.size() + block, never);
      earliest_.push_back(stale);
    }
    times_[i] = time;
    earliest_[i / block] = stale;
  }
  double operator[](uint32_t i) const { return times_[i]; }

  /// `none` when nothing will be.
  uint32_t first() {
    std::size_t best = 0;
    double time = never;
    for (std::size_t b = 0; b < earliest_.size(); ++b) {
      if (earliest_[b] == stale) earliest_[b] = *std::min_element(begin(b), begin(b + 1));
      if (earliest_[b] >= time) continue;
      time = earliest_[b];
      best = b;
    }
    if (time == never) return none;
    return static_cast<uint32_t>(std::find(begin(best), begin(best + 1), time) - times_.begin());
  }

 private:
  static constexpr std::size_t block = 32;
  static constexpr double stale = -1;
  std::vector<double>::const_iterator begin(std::size_t b) const {
    return times_.begin() + static_cast<std::ptrdiff_t>(b * block);
  }

  std::vector<double> times_, earliest_;
};

constexpr uint32_t up(uint32_t corner) { return 2 * corner; }
constexpr uint32_t down(uint32_t corner) { return 2 * corner + 1; }

class Wavefront {
 public:
  Wavefront(const Polygon &polygon, double together)
      : polygon_(polygon),
        together_(together),
        size_(polygon.points.size()),
        normal_x_(size_),
        normal_y_(size_),
        offset_(size_),
        waits_(size_),
        parts_(size_, none),
        when_(3 * size_) {
    corners_.reserve(3 * size_);
    nodes_.reserve(3 * size_);
  }

  std::optional<SkeletonMesh> trace() {
    start();
    while (alive_ > 0) {
      const uint32_t next = when_.first();
      // Each event but a split loses a corner, and there are fewer splits than
      // corners.
      if (next == none || corners_.size() > 8 * size_) return std::nullopt;
      now_ = std::max(now_, when_[next]);
      if (corners_[next].collapse <= corners_[next].split) {
        collapse(next);
      } else {
        split(next);
      }
    }
    return mesh();
  }

 private:
  void start() {
    for_each_edge(polygon_, [&](uint32_t e, Vec2 a, Vec2 b) {
      const WallLine line = wall_line(a, b);
      normal_x_[e] = line.normal.x;
      normal_y_[e] = line.normal.y;
      offset_[e] = line.c;
    });
    for (std::size_t r = 0; r < polygon_.rings(); ++r) {
      const uint32_t begin = polygon_.ring_begin(r), end = polygon_.ring_ends[r];
      for (uint32_t i = begin; i < end; ++i) {
        const Vec2 p = polygon_.points[i];
        nodes_.push_back({p.x, p.y, 0});
        const uint32_t before = i == begin ? end - 1 : i - 1, after = i + 1 == end ? begin : i + 1;
        add_corner(before, i, i, before, after);
      }
    }
    for (uint32_t i = 0; i < size_; ++i) schedule(i);
  }

  uint32_t add_corner(uint32_t left, uint32_t right, uint32_t node, uint32_t before,
                      uint32_t after) {
    const Vec2 n1 = normal(left), n2 = normal(right);
    // (n1 + n2) / (1 + n1.n2), whose denominator would lose all digits between
    // edges that run against each other.
    const double along = dot(n1, n2), turn = cross(n1, n2);
    const double scale = along > 0 ? 1 / (1 + along) : (1 - along) / (turn * turn);
    const Vec3 p = nodes_[node];
    const auto corner = static_cast<uint32_t>(corners_.size());
    corners_.push_back({.at = {p.x, p.y},
                        .since = p.z,
                        .velocity = (n1 + n2) * scale,
                        .left = left,
                        .right = right,
                        .before = before,
                        .after = after,
                        .born = node,
                        .dead = none,
                        .next_up = none,
                        .next_down = none,
                        .twin = parts_[right],
                        .collapse = never,
                        .split = never,
                        .split_edge = none,
                        .ahead = 0,
                        .ahead_end = 0,
                        .reflex = turn < 0});
    parts_[right] = corner;
    ++alive_;
    return corner;
  }

  Vec2 normal(uint32_t edge) const { return {normal_x_[edge], normal_y_[edge]}; }

  void kill(uint32_t corner, uint32_t node) {
    corners_[corner].dead = node;
    when_.set(corner, never);
    --alive_;
  }

  uint32_t add_node(Vec2 p) {
    nodes_.push_back({p.x, p.y, now_});
    return static_cast<uint32_t>(nodes_.size() - 1);
  }

  void schedule(uint32_t corner) {
    schedule_collapse(corner);
    if (corners_[corner].reflex) schedule_split(corner);
  }

  void schedule_collapse(uint32_t corner) {
    Corner &a = corners_[corner];
    const Corner &b = corners_[a.after];
    const Vec2 inwards = normal(a.right), along{inwards.y, -inwards.x};
    const double growth = dot(b.velocity - a.velocity, along);
    const double from = std::max(a.since, b.since);
    const double length = dot(b.place(from) - a.place(from), along);
    // Where three or more corners meet but for the jitter, a step without width can remain that
    // would run on across the roof, and part the slopes of walls along one line askew.
    const bool stuck = length < together_ && std::abs(growth) < 1e-3;
    a.collapse = stuck ? now_ : growth < 0 ? std::max(now_, from - length / growth) : never;
    when_.set(corner, std::min(a.collapse, a.split));
  }

  // The next edge's line that a reflex corner runs into.
  void schedule_split(uint32_t corner) {
    Corner &c = corners_[corner];
    if (c.ahead == c.ahead_end) look_ahead(c);
    if (c.ahead == c.ahead_end) {
      c.split = never;
    } else {
      c.split = c.since + ahead_[c.ahead].wait;
      c.split_edge = ahead_[c.ahead++].edge;
    }
    when_.set(corner, std::min(c.collapse, c.split));
  }

  // The lines that a corner meets after those it has met, a few at a time.
  void look_ahead(Corner &c) {
    for (uint32_t e = 0; e < size_; ++e) {
      const double approach = 1 - (normal_x_[e] * c.velocity.x + normal_y_[e] * c.velocity.y);
      const double distance = normal_x_[e] * c.at.x + normal_y_[e] * c.at.y + offset_[e] - c.since;
      waits_[e] = distance / (approach > 0 ? approach : 0);
    }
    waits_[c.left] = waits_[c.right] = never;
    constexpr uint32_t few = 4;
    const double last = c.ahead_end > 0 ? ahead_[c.ahead_end - 1].wait : 0;
    c.ahead = static_cast<uint32_t>(ahead_.size());
    double most = never;
    for (uint32_t e = 0; e < size_; ++e) {
      if (!(waits_[e] > last) || !(waits_[e] < most)) continue;
      ahead_.push_back({waits_[e], e});
      for (auto a = ahead_.end() - 1; a > ahead_.begin() + c.ahead && (a - 1)->wait > a->wait;
           --a) {
        std::swap(*a, *(a - 1));
      }
      if (ahead_.size() > c.ahead + few) ahead_.pop_back();
      if (ahead_.size() == c.ahead + few) most = ahead_.back().wait;
    }
    c.ahead_end = static_cast<uint32_t>(ahead_.size());
  }

  // The edge between two corners vanishes, and they become one.
  void collapse(uint32_t a) {
    const uint32_t b = corners_[a].after;
    const bool calmer = dot(corners_[a].velocity, corners_[a].velocity) <
                        dot(corners_[b].velocity, corners_[b].velocity);
    const uint32_t node = add_node(corners_[calmer ? a : b].place(now_));
    kill(a, node);
    kill(b, node);
    corners_[b].next_up = down(a);
    rejoin(a, b, node);
  }

  // Closes the wavefront between what comes before v and what comes after w, which have died.
  void rejoin(uint32_t v, uint32_t w, uint32_t node) {
    const uint32_t before = corners_[v].before, after = corners_[w].after;
    if (before == after) {  // the last triangle of a ring, or a strip without width
      kill(before, node);
      corners_[v].next_up = down(before);
      corners_[before].next_up = down(w);
      return;
    }
    const uint32_t c = add_corner(corners_[v].left, corners_[w].right, node, before, after);
    corners_[v].next_up = up(c);
    corners_[c].next_down = down(w);
    join(before, c);
    join(c, after);
    schedule_collapse(before);
    schedule(c);
  }

  // A reflex corner runs into an edge, and the ring falls into two (or two rings become one).
  void split(uint32_t v) {
    const uint32_t edge = corners_[v].split_edge, left = corners_[v].left,
                   right = corners_[v].right;
    const Vec2 place = corners_[v].place(corners_[v].split);
    const uint32_t from = corner_before(v, edge, place);
    if (from == none) return schedule_split(v);
    const uint32_t to = corners_[from].after, before = corners_[v].before,
                   after = corners_[v].after;
    // On the edge beside its own it is together with their common corner.
    if (from == after) return collapse(v);
    if (to == before) return collapse(before);
    const uint32_t node = add_node(place);
    kill(v, node);
    const uint32_t c1 = add_corner(left, edge, node, before, to);
    const uint32_t c2 = add_corner(edge, right, node, from, after);
    corners_[v].next_up = up(c1);
    corners_[c2].next_down = down(v);
    corners_[c1].next_down = up(c2);
    join(before, c1);
    join(c1, to);
    join(from, c2);
    join(c2, after);
    schedule_collapse(before);
    schedule_collapse(from);
    schedule(c1);
    schedule(c2);
  }

  void join(uint32_t a, uint32_t b) {
    corners_[a].after = b;
    corners_[b].before = a;
  }

  // Where the part of an edge begins that holds a place; `none` where no part
  // does.
  uint32_t corner_before(uint32_t v, uint32_t edge, Vec2 place) const {
    const Vec2 inwards = normal(edge), along{inwards.y, -inwards.x};
    const double time = corners_[v].split;
    for (uint32_t i = parts_[edge]; i != none; i = corners_[i].twin) {
      const Corner &c = corners_[i];
      if (c.dead != none) continue;
      if (!(dot(place - c.place(time), along) >= 0)) continue;
      if (!(dot(corners_[c.after].place(time) - place, along) >= 0)) continue;
      return i;
    }
    return none;
  }

  std::optional<SkeletonMesh> mesh() {
    SkeletonMesh mesh;
    mesh.corners.reserve(6 * size_);
    mesh.face_ends.reserve(size_);
    for (std::size_t r = 0; r < polygon_.rings(); ++r) {
      const uint32_t begin = polygon_.ring_begin(r), end = polygon_.ring_ends[r];
      for (uint32_t i = begin; i < end; ++i) {
        if (!add_face(mesh, i, i + 1 == end ? begin : i + 1)) return std::nullopt;
      }
    }
    mesh.nodes = std::move(nodes_);
    return mesh;
  }

  bool add_face(SkeletonMesh &mesh, uint32_t from, uint32_t to) const {
    mesh.corners.push_back(from);
    mesh.corners.push_back(to);
    uint32_t half = up(to);
    for (std::size_t steps = 0; half != down(from); ++steps) {
      if (half == none || steps > 2 * corners_.size()) return false;
      const Corner &c = corners_[half / 2];
      const bool upwards = half % 2 == 0;
      mesh.corners.push_back(upwards ? c.dead : c.born);
      half = upwards ? c.next_up : c.next_down;
    }
    mesh.face_ends.push_back(static_cast<uint32_t>(mesh.corners.size()));
    return true;
  }

  const Polygon &polygon_;
  double together_;
  std::size_t size_;
  std::vector<double> normal_x_, normal_y_,
      offset_;                 // of the edges' lines; apart, to be quick
  std::vector<double> waits_;  // until a corner reaches each of them
  struct Ahead {
    double wait;
    uint32_t edge;
  };
  std::vector<Ahead> ahead_;     // of all corners, a few for each
  std::vector<uint32_t> parts_;  // the first corner that begins a part of each
  std::vector<Corner> corners_;  // that ever were, the polygon's first
  Schedule when_;                // the next event of each
  std::vector<Vec3> nodes_;
  uint32_t alive_ = 0;
  double now_ = 0;
};

}  // namespace

std::optional<SkeletonMesh> wavefront_skeleton(const Polygon &polygon, double together) {
  return Wavefront(polygon, together).trace();
}

}  // namespace mansard
