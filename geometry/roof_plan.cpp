// The plan of a hip roof, which all others begin with; and cutting plans at a level.
#include "geometry/roof_plan.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace mansard {

double RoofPlan::highest() const {
  double most = 0;
  for (const Node& node : nodes) most = std::max(most, node.outer.z);
  return most;
}

RoofPlan plan_roof(const SkeletonOn& on) {
  RoofPlan plan;
  const Polygon& polygon = on.polygon;
  const std::size_t n = polygon.points.size();
  plan.footprint = &polygon;
  plan.lines = wall_lines(polygon);
  plan.next = next_points(polygon);
  plan.before.resize(n);
  for (uint32_t i = 0; i < n; ++i) plan.before[plan.next[i]] = i;
  plan.nodes.reserve(on.mesh.nodes.size());
  for (const Vec3 node : on.mesh.nodes) plan.add_node(node);
  plan.faces.resize(n);
  plan.borders.resize(n);
  for (uint32_t e = 0; e < n; ++e) {
    const auto face = on.mesh.face(e);
    plan.faces[e].edge = e;
    plan.faces[e].loop.assign(face.begin(), face.end());
    plan.borders[e] = {e, plan.next[e]};
  }
  plan.ends.assign(n, RoofEnd::hip);
  return plan;
}

namespace {

void insert_everywhere(RoofPlan& plan, uint32_t a, uint32_t b, uint32_t between) {
  for (RoofPlan::Face& face : plan.faces) {
    std::vector<uint32_t>& loop = face.loop;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const uint32_t from = loop[i], to = loop[(i + 1) % loop.size()];
      if ((from != a || to != b) && (from != b || to != a)) continue;
      loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i + 1), between);
      ++i;
    }
  }
}

double distance_to_line(Vec3 p, Vec3 from, Vec3 to) {
  return length(cross(p - from, normalized(to - from)));
}

// A corner where the loop turns back on itself: of the two edges there the longer one runs through
// the end of the shorter, which belongs into it. Returns whether there was one.
bool close_slit(RoofPlan& plan, std::size_t f) {
  constexpr double thin = 1e-6;  // metres
  const std::vector<uint32_t>& loop = plan.faces[f].loop;
  const std::size_t n = loop.size();
  for (std::size_t i = 2; i < n && n > 3; ++i) {
    const uint32_t before = loop[i - 1], tip = loop[i], after = loop[(i + 1) % n];
    const Vec3 p = plan.nodes[before].wall, q = plan.nodes[tip].wall, r = plan.nodes[after].wall;
    if (dot(q - p, r - q) >= 0) continue;
    const bool back = length(r - q) < length(q - p);
    if ((back ? distance_to_line(r, p, q) : distance_to_line(p, q, r)) > thin) continue;
    if (before != after) {
      back ? insert_everywhere(plan, before, tip, after)
           : insert_everywhere(plan, tip, after, before);
    }
    std::vector<uint32_t>& closed = plan.faces[f].loop;  // ... x tip x ... becomes ... x ...
    for (std::size_t k = 1; k < closed.size(); ++k) {
      const std::size_t next = (k + 1) % closed.size();
      if (closed[k] != tip || closed[k - 1] != closed[next]) continue;
      closed.erase(closed.begin() + static_cast<std::ptrdiff_t>(k));
      closed.erase(closed.begin() + static_cast<std::ptrdiff_t>(k - 1));
      return true;
    }
    return false;
  }
  return false;
}

}  // namespace

void close_slits(RoofPlan& plan) {
  for (std::size_t f = 0; f < plan.faces.size(); ++f) {
    while (close_slit(plan, f)) {
    }
  }
}

namespace {

// Where edges between nodes cross a level: one node for each pair, whichever face asks.
class Crossings {
 public:
  Crossings(RoofPlan& plan, double level) : plan_(plan), level_(level) {}

  bool crosses(uint32_t a, uint32_t b) const { return above(a) != above(b); }
  bool above(uint32_t i) const { return plan_.nodes[i].outer.z > level_; }

  uint32_t between(uint32_t a, uint32_t b) {
    const std::pair<uint32_t, uint32_t> ends = std::minmax(a, b);
    const auto [entry, fresh] = nodes_.try_emplace(ends, 0u);
    if (fresh) {
      const RoofPlan::Node low = plan_.nodes[ends.first], high = plan_.nodes[ends.second];
      entry->second = plan_.add_node(at_level(low.wall, high.wall));
      plan_.nodes[entry->second].outer = at_level(low.outer, high.outer);
    }
    return entry->second;
  }

 private:
  Vec3 at_level(Vec3 a, Vec3 b) const {
    if (a.z == b.z) return a;
    const double share = std::clamp((level_ - a.z) / (b.z - a.z), 0.0, 1.0);
    if (share == 0) return a;
    if (share == 1) return b;
    Vec3 p = mix(a, b, share);
    p.z = level_;
    return p;
  }

  RoofPlan& plan_;
  double level_;
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> nodes_;
};

// A level beside a node would make slivers, and one between the two places of a node (the tip of a
// ridge that falls towards its verge) would bend the one and not the other: it moves below them.
double clear_of_nodes(const RoofPlan& plan, double level) {
  constexpr double near = 1e-6;
  for (int attempt = 0; attempt < 16; ++attempt) {
    double clear = level;
    for (const RoofPlan::Node& node : plan.nodes) {
      const double low = node.wall.z > 0 ? std::min(node.wall.z, node.outer.z) : node.outer.z;
      const double high = node.wall.z > 0 ? std::max(node.wall.z, node.outer.z) : node.outer.z;
      if (level > low - near && level < high + near) clear = std::min(clear, low - 3 * near);
    }
    if (clear == level) break;
    level = clear;
  }
  return level;
}

// The face's part above the level falls into pieces where its upper border comes down to it;
// a face of a skeleton has one part below, since it is monotone along its wall.
void cut_face(RoofPlan& plan, std::size_t f, Crossings& crossings, RoofPart below, RoofPart above) {
  const RoofPlan::Face old = plan.faces[f];
  const std::size_t n = old.loop.size();
  std::size_t start = 0;
  while (start < n && crossings.above(old.loop[start])) ++start;
  if (start == n) {
    plan.faces[f].part = above;
    return;
  }
  std::vector<uint32_t> low, high;
  std::size_t eave = 0;  // in `low`: where its lowest edge begins
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    const uint32_t a = old.loop[i], b = old.loop[(i + 1) % n];
    if (i == 0 && !crossings.above(a)) eave = low.size();
    (crossings.above(a) ? high : low).push_back(a);
    if (!crossings.crosses(a, b)) continue;
    const uint32_t at = crossings.between(a, b);
    if (i == 0 && crossings.above(a)) eave = low.size();
    low.push_back(at);
    high.push_back(at);
    if (!crossings.above(a)) continue;
    std::rotate(high.begin(), high.end() - 1, high.end());  // its lowest edge first
    if (high.size() > 2) plan.faces.push_back({above, old.edge, false, high});
    high.clear();
  }
  std::rotate(low.begin(), low.begin() + static_cast<std::ptrdiff_t>(eave), low.end());
  plan.faces[f].part = below;
  plan.faces[f].loop = std::move(low);
}

void cut_border(std::vector<uint32_t>& border, bool ring, Crossings& crossings) {
  std::vector<uint32_t> more;
  for (std::size_t i = 0; i < border.size(); ++i) {
    more.push_back(border[i]);
    if (i + 1 == border.size() && !ring) break;
    const uint32_t next = border[(i + 1) % border.size()];
    if (crossings.crosses(border[i], next)) more.push_back(crossings.between(border[i], next));
  }
  border = std::move(more);
}

}  // namespace

double cut_at_level(RoofPlan& plan, double wanted, RoofPart below, RoofPart above) {
  const double level = clear_of_nodes(plan, wanted);
  Crossings crossings(plan, level);
  for (std::size_t f = 0, count = plan.faces.size(); f < count; ++f) {
    if (plan.faces[f].part == RoofPart::gable) {
      cut_border(plan.faces[f].loop, true, crossings);
    } else if (plan.faces[f].part != RoofPart::fascia) {
      cut_face(plan, f, crossings, below, above);
    }
  }
  for (std::vector<uint32_t>& border : plan.borders) cut_border(border, false, crossings);
  return level;
}

}  // namespace mansard
