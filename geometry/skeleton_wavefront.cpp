// The straight skeleton as the trace of a wavefront: the polygon's edges move inwards at unit
// speed, and the corners between them draw the skeleton's arcs (Aichholzer & Aurenhammer 1996).
// In doubles and without care for events at one time and place: those are the business of whoever
// jitters the polygon before, and checks the result after (Huber 2012 §2 tells what goes wrong).
// Each event looks for the next among all corners, which is quickest below some hundred of them.
#include <algorithm>
#include <limits>

#include "geometry/skeleton.hpp"

namespace mansard {
namespace {

constexpr uint32_t none = ~0u;
constexpr double never = std::numeric_limits<double>::infinity();

// A corner of the wavefront, between the edges `left` (which ends here) and `right`. It is also the
// arc that it draws, from the node it is born at to the one it dies at: upwards along the face of
// `left`, downwards along the face of `right`.
struct Corner {
  Vec2 at;  // where it was born
  double since;
  Vec2 velocity;
  uint32_t left, right;
  uint32_t before, after;       // its neighbours on the wavefront
  uint32_t born, dead;          // nodes
  uint32_t next_up, next_down;  // the half-arcs that follow its own around their faces
  double collapse;              // when the edge to `after` vanishes
  double split;                 // when it may run into an edge, which
  uint32_t split_edge;          // is this one

  Vec2 place(double time) const { return at + velocity * (time - since); }
};

constexpr uint32_t up(uint32_t corner) { return 2 * corner; }
constexpr uint32_t down(uint32_t corner) { return 2 * corner + 1; }

class Wavefront {
 public:
  explicit Wavefront(const Polygon& polygon)
      : polygon_(polygon), size_(static_cast<uint32_t>(polygon.points.size())) {
    lines_.reserve(size_);
    corners_.reserve(3 * size_);
    when_.reserve(3 * size_);
    nodes_.reserve(3 * size_);
  }

  std::optional<SkeletonMesh> trace() {
    start();
    while (alive_ > 0) {
      const uint32_t next = next_corner();
      // Each event but a split loses a corner, and there are fewer splits than corners.
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
    for_each_edge(polygon_, [&](uint32_t, Vec2 a, Vec2 b) { lines_.push_back(wall_line(a, b)); });
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
    const Vec2 n1 = lines_[left].normal, n2 = lines_[right].normal;
    // (n1 + n2) / (1 + n1.n2), whose denominator would lose all digits between edges that run
    // against each other.
    const double along = dot(n1, n2), turn = cross(n1, n2);
    const double scale = along > 0 ? 1 / (1 + along) : (1 - along) / (turn * turn);
    const Vec3 p = nodes_[node];
    corners_.push_back({{p.x, p.y},
                        p.z,
                        (n1 + n2) * scale,
                        left,
                        right,
                        before,
                        after,
                        node,
                        none,
                        none,
                        none,
                        never,
                        turn < 0 ? p.z : never,
                        none});
    when_.push_back(never);
    ++alive_;
    return static_cast<uint32_t>(corners_.size() - 1);
  }

  void kill(uint32_t corner, uint32_t node) {
    corners_[corner].dead = node;
    when_[corner] = never;
    --alive_;
  }

  uint32_t add_node(Vec2 p) {
    nodes_.push_back({p.x, p.y, now_});
    return static_cast<uint32_t>(nodes_.size() - 1);
  }

  void schedule(uint32_t corner) {
    schedule_collapse(corner);
    if (corners_[corner].split != never) schedule_split(corner);
  }

  void schedule_collapse(uint32_t corner) {
    Corner& a = corners_[corner];
    const Corner& b = corners_[a.after];
    const Vec2 normal = lines_[a.right].normal, along{normal.y, -normal.x};
    const double growth = dot(b.velocity - a.velocity, along);
    const double from = std::max(a.since, b.since);
    const double length = dot(b.place(from) - a.place(from), along);
    a.collapse = growth < 0 ? std::max(now_, from - length / growth) : never;
    when_[corner] = std::min(a.collapse, a.split);
  }

  // The next edge's line that a reflex corner runs into, in the order of times and then edges.
  void schedule_split(uint32_t corner) {
    Corner& c = corners_[corner];
    const double last = c.split;
    const uint32_t last_edge = c.split_edge;
    c.split = never;
    for (uint32_t e = 0; e < size_; ++e) {
      const double approach = 1 - dot(lines_[e].normal, c.velocity);
      const double distance = lines_[e].distance(c.at) - c.since;
      const double wait = distance / approach, time = c.since + wait;
      if (!(approach > 0) || !(wait > 0) || !(time < c.split) || time < last) continue;
      if (time == last && last_edge != none && e <= last_edge) continue;
      if (e == c.left || e == c.right) continue;
      c.split = time;
      c.split_edge = e;
    }
    when_[corner] = std::min(c.collapse, c.split);
  }

  uint32_t next_corner() const {
    uint32_t next = none;
    double earliest = never;
    for (uint32_t i = 0; i < when_.size(); ++i) {
      if (when_[i] < earliest) {
        earliest = when_[i];
        next = i;
      }
    }
    return next;
  }

  // The edge between two corners vanishes, and they become one.
  void collapse(uint32_t a) {
    const uint32_t b = corners_[a].after, before = corners_[a].before, after = corners_[b].after;
    const bool calmer = dot(corners_[a].velocity, corners_[a].velocity) <
                        dot(corners_[b].velocity, corners_[b].velocity);
    const uint32_t node = add_node(corners_[calmer ? a : b].place(now_));
    kill(a, node);
    kill(b, node);
    corners_[b].next_up = down(a);
    if (before == after) {  // the last triangle of a ring
      kill(before, node);
      corners_[a].next_up = down(before);
      corners_[before].next_up = down(b);
      return;
    }
    const uint32_t c = add_corner(corners_[a].left, corners_[b].right, node, before, after);
    corners_[a].next_up = up(c);
    corners_[c].next_down = down(b);
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

  // Where the part of an edge begins that holds a place; `none` where no part does.
  uint32_t corner_before(uint32_t v, uint32_t edge, Vec2 place) const {
    const Vec2 normal = lines_[edge].normal, along{normal.y, -normal.x};
    const double time = corners_[v].split;
    for (uint32_t i = 0; i < corners_.size(); ++i) {
      const Corner& c = corners_[i];
      if (c.right != edge || c.dead != none) continue;
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

  bool add_face(SkeletonMesh& mesh, uint32_t from, uint32_t to) const {
    mesh.corners.push_back(from);
    mesh.corners.push_back(to);
    uint32_t half = up(to);
    for (std::size_t steps = 0; half != down(from); ++steps) {
      if (half == none || steps > 2 * corners_.size()) return false;
      const Corner& c = corners_[half / 2];
      const bool upwards = half % 2 == 0;
      mesh.corners.push_back(upwards ? c.dead : c.born);
      half = upwards ? c.next_up : c.next_down;
    }
    mesh.face_ends.push_back(static_cast<uint32_t>(mesh.corners.size()));
    return true;
  }

  const Polygon& polygon_;
  uint32_t size_;
  std::vector<WallLine> lines_;
  std::vector<Corner> corners_;  // all that ever were, those of the polygon first
  std::vector<double> when_;     // the next event of each
  std::vector<Vec3> nodes_;
  uint32_t alive_ = 0;
  double now_ = 0;
};

}  // namespace

std::optional<SkeletonMesh> wavefront_skeleton(const Polygon& polygon) {
  return Wavefront(polygon).trace();
}

}  // namespace mansard
