#include "geometry/roof_lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

namespace mansard {
namespace {

// Numbers points so that those within a micrometre have the same number. A point is noted in its
// cell and looked for in all that its surroundings touch: nearly always one.
class Places {
 public:
  uint32_t number(Vec3 p) {
    const std::array<std::array<int64_t, 2>, 3> near{cells(p.x), cells(p.y), cells(p.z)};
    for (int corner = 0; corner < 8; ++corner) {
      const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
      const bool again = (i && near[0][0] == near[0][1]) || (j && near[1][0] == near[1][1]) ||
                         (k && near[2][0] == near[2][1]);
      if (again) continue;
      const auto [first, last] = known_.equal_range(key(near[0][i], near[1][j], near[2][k]));
      for (auto entry = first; entry != last; ++entry) {
        if (length(points_[entry->second] - p) <= 2 * touch) return entry->second;
      }
    }
    const auto fresh = static_cast<uint32_t>(points_.size());
    points_.push_back(p);
    known_.emplace(key(cell(p.x), cell(p.y), cell(p.z)), fresh);
    return fresh;
  }

 private:
  static constexpr double touch = 1e-6, size = 1e-2;
  static int64_t cell(double v) { return static_cast<int64_t>(std::floor(v / size)); }
  static std::array<int64_t, 2> cells(double v) { return {cell(v - touch), cell(v + touch)}; }
  static uint64_t key(int64_t x, int64_t y, int64_t z) {
    return static_cast<uint64_t>(x) * 0x9e3779b97f4a7c15u +
           static_cast<uint64_t>(y) * 0xc2b2ae3d27d4eb4fu + static_cast<uint64_t>(z);
  }

  std::vector<Vec3> points_;
  std::unordered_multimap<uint64_t, uint32_t> known_;
};

// One side of an edge: a face, and the direction within it that leads away from the edge.
struct Flank {
  Vec3 normal, inwards;
  double rise = 0;   // of inwards: sine
  double level = 0;  // of the normal
  bool slope = false;
};

class Classifier {
 public:
  Classifier(std::span<const Vec3> normals, Vec3 up) : normals_(normals), up_(up) {}

  std::optional<RoofLineKind> kind(const BorderEdge& edge, const BorderEdge* other) const {
    const Vec3 along = normalized(edge.to - edge.from);
    Flank a = flank(edge.face, along);
    Flank b = other ? flank(other->face, -along) : wall_below(a, along);
    if (!a.slope) std::swap(a, b);
    if (!a.slope) return std::nullopt;
    if (b.slope) return between_slopes(a, b, along);
    return border(a, b, along);
  }

  bool is_slope(uint32_t face) const { return flank(face, {}).slope; }
  bool lies(uint32_t face) const { return dot(normals_[face], up_) >= 0.9999; }

  Vec3 away(const BorderEdge& edge, const BorderEdge* other) const {
    const Vec3 along = normalized(edge.to - edge.from);
    const Flank a = flank(edge.face, along);
    const Vec3 b = other ? normals_[other->face] : wall_below(a, along).normal;
    const Vec3 sum = a.normal + b;
    return normalized(sum - along * dot(sum, along));
  }

 private:
  static constexpr double opposed = -0.866;    // cosine of 150 degrees
  static constexpr double one_plane = 0.9998;  // of 1 degree
  static constexpr double along_contour = 0.2;

  Flank flank(uint32_t face, Vec3 along) const {
    const Vec3 normal = normals_[face];
    Flank f{normal, cross(normal, along), 0, dot(normal, up_), false};
    f.rise = dot(f.inwards, up_);
    f.slope = f.level > 0.01 && f.level < 0.9999;
    return f;
  }

  // What a border that meets nothing ends over.
  Flank wall_below(const Flank& a, Vec3 along) const {
    const Vec3 out = a.inwards * -1;
    const Vec3 level = normalized(out - up_ * dot(out, up_));
    Flank wall{normalized(level - along * dot(level, along)), -up_, -1, 0, false};
    return wall;
  }

  // Downhill, in plan.
  Vec3 fall(const Flank& f) const { return normalized(f.normal - up_ * f.level); }

  bool is_level(const Flank& f, Vec3 along) const {
    const Vec3 plan = normalized(along - up_ * dot(along, up_));
    return std::abs(dot(plan, fall(f))) < along_contour;
  }

  std::optional<RoofLineKind> between_slopes(const Flank& a, const Flank& b, Vec3 along) const {
    if (dot(a.normal, b.normal) > one_plane) return std::nullopt;
    const double falls = dot(fall(a), fall(b));
    const bool broken = falls > 0 && is_level(a, along) && is_level(b, along);
    if (broken) return std::nullopt;
    if (dot(b.normal, a.inwards) >= 0) return RoofLineKind::valley;
    return falls < opposed ? RoofLineKind::ridge : RoofLineKind::hip;
  }

  std::optional<RoofLineKind> border(const Flank& slope, const Flank& beside, Vec3 along) const {
    const bool inner = dot(beside.normal, slope.inwards) > 1e-9;
    if (is_level(slope, along)) {
      if (slope.rise <= 0) return std::nullopt;
      const bool wall_above = inner && std::abs(beside.level) < 0.01;
      return wall_above ? RoofLineKind::valley : RoofLineKind::eave;
    }
    if (inner) return std::nullopt;
    return RoofLineKind::rake;
  }

  std::span<const Vec3> normals_;
  Vec3 up_;
};

struct Pair {
  uint32_t first = 0, second = 0, count = 0;
};

// Edges by the places of their ends, in order of appearance.
std::vector<Pair> paired(std::span<const BorderEdge> edges) {
  Places places;
  std::map<std::pair<uint32_t, uint32_t>, std::size_t> known;
  std::vector<Pair> pairs;
  for (uint32_t i = 0; i < edges.size(); ++i) {
    const uint32_t from = places.number(edges[i].from), to = places.number(edges[i].to);
    if (from == to) continue;
    const auto [entry, fresh] = known.try_emplace(std::minmax(from, to), pairs.size());
    if (fresh) pairs.push_back({i, i, 0});
    Pair& pair = pairs[entry->second];
    pair.second = i;
    ++pair.count;
  }
  std::erase_if(pairs, [](const Pair& pair) { return pair.count > 2; });
  return pairs;
}

// The foot of a slope on a level ledge, as the ledge's loop has it.
struct Foot {
  Vec3 from, to;
};

// Whether an edge of the ledge runs along its outer side, against the foot and before it.
bool runs_before(const BorderEdge& edge, const Foot& foot) {
  constexpr double widest = 2;  // metres
  const Vec3 along = normalized(edge.to - edge.from), back = normalized(foot.to - foot.from);
  if (dot(along, back) > -0.99) return false;
  const Vec3 out = edge.from - foot.to;
  return length(out - back * dot(out, back)) < widest;
}

}  // namespace

std::vector<RoofLine> roof_lines(std::span<const BorderEdge> edges, std::span<const Vec3> normals,
                                 Vec3 up) {
  const std::vector<Pair> pairs = paired(edges);
  const Classifier classifier(normals, up);
  std::vector<RoofLine> lines;
  std::map<uint32_t, Foot> ledges;  // by face
  for (const Pair& pair : pairs) {
    const BorderEdge& edge = edges[pair.first];
    const BorderEdge* const other = pair.count == 2 ? &edges[pair.second] : nullptr;
    const auto kind = classifier.kind(edge, other);
    if (!kind) continue;
    const bool turned =
        other && !classifier.is_slope(edge.face) && classifier.is_slope(other->face);
    const BorderEdge& shown = turned ? *other : edge;
    const BorderEdge* const beside = turned ? &edge : other;
    if (*kind == RoofLineKind::eave && beside && classifier.lies(beside->face)) {
      ledges[beside->face] = {beside->from, beside->to};
      continue;
    }
    RoofLine line{*kind, shown.from, shown.to, classifier.away(edge, other), pair.first};
    const double rise = dot(line.to - line.from, up);
    const bool inclined = *kind == RoofLineKind::hip || *kind == RoofLineKind::rake ||
                          (*kind == RoofLineKind::valley && std::abs(rise) > 1e-6);
    if (inclined && rise < 0) std::swap(line.from, line.to);
    lines.push_back(line);
  }
  if (ledges.empty()) return lines;
  for (const Pair& pair : pairs) {
    for (const uint32_t i : {pair.first, pair.second}) {
      const auto ledge = ledges.find(edges[i].face);
      if (ledge == ledges.end() || !runs_before(edges[i], ledge->second)) continue;
      const BorderEdge& other = edges[pair.first + pair.second - i];
      lines.push_back({RoofLineKind::eave, edges[i].from, edges[i].to,
                       classifier.away(edges[i], pair.count == 2 ? &other : nullptr), pair.first});
      break;
    }
  }
  std::ranges::stable_sort(lines, {}, &RoofLine::edge);
  return lines;
}

}  // namespace mansard
