#include "interpreter/streets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/distance.hpp"

namespace mansard {
namespace {

Box3 box_of(Vec2 a, Vec2 b, double around = 0) {
  return grown(
      {{std::min(a.x, b.x), 0, std::min(a.y, b.y)}, {std::max(a.x, b.x), 0, std::max(a.y, b.y)}},
      around);
}

/// So that the order of the lines does not matter.
bool is_before(double distance, Vec2 p, double other, Vec2 q) {
  return distance != other ? distance < other : std::pair(p.x, p.y) < std::pair(q.x, q.y);
}

}  // namespace

Streets::Streets(const std::vector<StreetLine>& lines) {
  std::map<std::pair<long long, long long>, uint32_t> known;
  const auto number_of = [&](Vec2 p) {
    const std::pair key{std::llround(p.x * 1e3), std::llround(p.y * 1e3)};
    const auto [at, fresh] = known.try_emplace(key, static_cast<uint32_t>(points_.size()));
    if (fresh) {
      points_.push_back(p);
      beside_.emplace_back();
    }
    return at->second;
  };
  std::vector<Box3> boxes;
  for (const StreetLine& line : lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const uint32_t a = number_of(line[i]), b = number_of(line[i + 1]);
      if (a == b) continue;
      beside_[a].push_back(b);
      beside_[b].push_back(a);
      segments_.push_back({a, b});
      boxes.push_back(box_of(points_[a], points_[b]));
    }
  }
  index_.build(boxes);
}

bool Streets::is_nearest(uint32_t point, Vec2 place) const {
  const Vec2 p = points_[point];
  return std::ranges::all_of(
      beside_[point], [&](uint32_t other) { return dot(place - p, points_[other] - p) <= 1e-9; });
}

void Streets::nearest_points(Vec2 place, double reach, std::vector<Vec2>& found) const {
  std::vector<uint32_t> near;
  index_.near(box_of(place, place, reach), near);
  found.clear();
  for (const uint32_t s : near) {
    const Vec2 a = points_[segments_[s].from], b = points_[segments_[s].to];
    const double at = dot(place - a, b - a) / dot(b - a, b - a);
    if (at > 0 && at < 1) {
      found.push_back(mix(a, b, at));
    } else if (const uint32_t end = at <= 0 ? segments_[s].from : segments_[s].to;
               is_nearest(end, place)) {
      found.push_back(points_[end]);
    }
  }
  std::erase_if(found, [&](Vec2 p) { return length(p - place) > reach; });
  std::ranges::sort(
      found, [&](Vec2 p, Vec2 q) { return is_before(length(p - place), p, length(q - place), q); });
}

std::optional<Streets::Near> Streets::nearest(Vec2 from, Vec2 to, double within) const {
  std::optional<Near> best;
  index_.nearest(box_of(from, to), within, [&](uint32_t s) {
    const Nearest2 pair =
        nearest_pair(points_[segments_[s].from], points_[segments_[s].to], from, to);
    if (!best || is_before(pair.distance, pair.first, best->distance, best->point))
      best = {pair.first, pair.distance};
    return pair.distance;
  });
  if (best && best->distance >= within) return std::nullopt;
  return best;
}

}  // namespace mansard
