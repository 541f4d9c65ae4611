#include "tests/laws/closed.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

namespace mansard::test {
namespace {

constexpr double touch = 1e-6;  // metres

/// Places, each once: points nearer than `touch` are one.
class Places {
 public:
  uint32_t number(Vec3 p) {
    for (const double dx : {0.0, -touch, touch}) {
      for (const double dy : {0.0, -touch, touch}) {
        for (const double dz : {0.0, -touch, touch}) {
          const auto it = cells_.find(cell({p.x + dx, p.y + dy, p.z + dz}));
          if (it != cells_.end() && length(places_[it->second] - p) <= touch) return it->second;
        }
      }
    }
    places_.push_back(p);
    cells_.emplace(cell(p), static_cast<uint32_t>(places_.size() - 1));
    return static_cast<uint32_t>(places_.size() - 1);
  }
  const std::vector<Vec3>& all() const { return places_; }

 private:
  static uint64_t cell(Vec3 p) {
    const auto n = [](double v) { return static_cast<uint64_t>(std::floor(v / (4 * touch))); };
    return n(p.x) * 0x9e3779b97f4a7c15ull ^ n(p.y) * 0xbf58476d1ce4e5b9ull ^
           n(p.z) * 0x94d049bb133111ebull;
  }
  std::vector<Vec3> places_;
  std::unordered_map<uint64_t, uint32_t> cells_;
};

double coordinate(Vec3 p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// Places sorted along each axis, to find those on an edge.
struct Sorted {
  const std::vector<Vec3>& places;
  std::array<std::vector<uint32_t>, 3> by;

  explicit Sorted(const std::vector<Vec3>& all) : places(all) {
    for (int axis = 0; axis < 3; ++axis) {
      for (uint32_t i = 0; i < all.size(); ++i) by[axis].push_back(i);
      std::ranges::sort(by[axis], {}, [&](uint32_t i) { return coordinate(all[i], axis); });
    }
  }

  /// Places on the edge from a to b with their share of the way, both ends among them.
  std::vector<std::pair<double, uint32_t>> along(uint32_t a, uint32_t b) const {
    const Vec3 from = places[a], way = places[b] - from;
    int axis = 0;
    for (const int other : {1, 2}) {
      if (std::abs(coordinate(way, other)) < std::abs(coordinate(way, axis))) axis = other;
    }
    const double low = std::min(coordinate(from, axis), coordinate(places[b], axis)) - 2 * touch;
    const double high = std::max(coordinate(from, axis), coordinate(places[b], axis)) + 2 * touch;
    const auto key = [&](uint32_t i) { return coordinate(places[i], axis); };
    std::vector<std::pair<double, uint32_t>> on{{0, a}, {1, b}};
    for (auto it = std::ranges::lower_bound(by[axis], low, {}, key);
         it != by[axis].end() && key(*it) <= high; ++it) {
      if (*it == a || *it == b) continue;
      const double share = dot(places[*it] - from, way) / dot(way, way);
      if (share <= 0 || share >= 1) continue;
      if (length(from + way * share - places[*it]) <= 2 * touch) on.emplace_back(share, *it);
    }
    std::sort(on.begin(), on.end());
    return on;
  }
};

}  // namespace

double open_length(const Surface& surface, const std::function<bool(Vec3)>& ground) {
  Places places;
  std::vector<std::pair<uint32_t, uint32_t>> edges;
  for (std::size_t polygon = 0; polygon < surface.polygons(); ++polygon) {
    const auto loop = surface.loop(polygon);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const uint32_t a = places.number(loop[i]), b = places.number(loop[(i + 1) % loop.size()]);
      if (a != b) edges.emplace_back(a, b);
    }
  }
  const Sorted sorted(places.all());
  std::map<std::pair<uint32_t, uint32_t>, int> balance;
  for (const auto& [a, b] : edges) {
    const auto on = sorted.along(a, b);
    for (std::size_t i = 0; i + 1 < on.size(); ++i) {
      const uint32_t from = on[i].second, to = on[i + 1].second;
      balance[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  double open = 0;
  for (const auto& [edge, count] : balance) {
    const Vec3 a = places.all()[edge.first], b = places.all()[edge.second];
    if (count == 0 || (ground(a) && ground(b))) continue;
    open += std::abs(count) * length(b - a);
  }
  return open;
}

double volume_above(const Surface& surface, double ground) {
  if (surface.points.empty()) return 0;
  const Vec3 origin{surface.points[0].x, ground, surface.points[0].z};
  double sum = 0;
  for (std::size_t polygon = 0; polygon < surface.polygons(); ++polygon) {
    const auto loop = surface.loop(polygon);
    sum += dot(loop[0] - origin, newell(loop)) / 6;
  }
  return sum;
}

}  // namespace mansard::test
