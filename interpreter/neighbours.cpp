#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "interpreter/edge_grid.hpp"
#include "interpreter/footprint.hpp"
#include "interpreter/street_edges.hpp"
#include "interpreter/surroundings.hpp"

namespace mansard {
namespace {

constexpr double shortest_piece = 0.5;  // metres
constexpr uint16_t neighbour_flags =
    EdgeTag::party | EdgeTag::court | EdgeTag::street | EdgeTag::main | EdgeTag::corner;

using Span = std::pair<double, double>;  // metres along an edge

std::vector<GridEdge> edges_of(std::span<const Footprint> footprints) {
  std::vector<GridEdge> edges;
  for (uint32_t i = 0; i < footprints.size(); ++i) {
    for_each_edge(footprints[i].polygon, [&](uint32_t, Vec2 a, Vec2 b) {
      if (std::isfinite(a.x + a.y + b.x + b.y)) edges.push_back({a, b, i});
    });
  }
  return edges;
}

// The part of the edge a-b along which `other` runs in the opposite direction within the tolerance;
// empty (second <= first) when there is none.
Span covered_by(Vec2 a, Vec2 b, const GridEdge& other, double tolerance) {
  const Span none{0, 0};
  const Vec2 along = normalized(b - a);
  double s1 = dot(other.to - a, along), s2 = dot(other.from - a, along);
  if (s2 <= s1) return none;  // the same direction: it overlaps or is the same building
  // Distance from the edge's line, linear from s1 to s2.
  const double d1 = cross(along, other.to - a), d2 = cross(along, other.from - a);
  if (std::abs(d2 - d1) > 0.2 * (s2 - s1)) return none;  // 11 degrees
  const double slope = (d2 - d1) / (s2 - s1);
  double low = std::max(0.0, s1), high = std::min(length(b - a), s2);
  if (std::abs(slope) < 1e-12) return std::abs(d1) <= tolerance ? Span{low, high} : none;
  const double at1 = s1 + (-tolerance - d1) / slope, at2 = s1 + (tolerance - d1) / slope;
  low = std::max(low, std::min(at1, at2));
  high = std::min(high, std::max(at1, at2));
  return high > low ? Span{low, high} : none;
}

// Party spans of at least the shortest piece, with free gaps of at least that between them. An edge
// too short to divide is party as a whole where more than half of it is covered.
std::vector<Span> worth_dividing(std::vector<Span> spans, double edge) {
  std::sort(spans.begin(), spans.end());
  double covered = 0, reached = 0;
  for (const Span& s : spans) {
    covered += std::max(0.0, s.second - std::max(reached, s.first));
    reached = std::max(reached, s.second);
  }
  if (edge < 2 * shortest_piece) {
    return covered > edge / 2 ? std::vector<Span>{{0, edge}} : std::vector<Span>{};
  }
  if (covered < shortest_piece) return {};
  std::vector<Span> joined;
  for (const Span& s : spans) {
    if (joined.empty() && s.first < shortest_piece) {
      joined.emplace_back(0, s.second);
    } else if (!joined.empty() && s.first < joined.back().second + shortest_piece) {
      joined.back().second = std::max(joined.back().second, s.second);
    } else {
      joined.push_back(s);
    }
  }
  if (edge - joined.back().second < shortest_piece) joined.back().second = edge;
  std::erase_if(joined, [](const Span& s) { return s.second - s.first < shortest_piece; });
  return joined;
}

// Adds the edge a-b, divided where party spans begin and end.
void add_divided(Polygon& polygon, Vec2 a, Vec2 b, EdgeTag tag, const std::vector<Span>& party) {
  const double whole = length(b - a);
  const auto add = [&](double from, bool is_party) {
    EdgeTag piece = tag;
    if (is_party) piece.flags |= EdgeTag::party;
    polygon.add_point(from > 0 ? mix(a, b, from / whole) : a, piece);
  };
  double at = 0;
  for (const Span& span : party) {
    if (span.first > at) add(at, false);
    add(span.first, true);
    at = span.second;
  }
  if (at < whole || party.empty()) add(at, false);
}

Polygon divided(const Polygon& polygon, uint32_t footprint, const EdgeGrid& grid,
                double tolerance) {
  Polygon result;
  std::vector<uint32_t> near;
  std::vector<Span> spans;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) {
      const Vec2 a = polygon.points[i], b = polygon.points[i + 1 == end ? begin : i + 1];
      EdgeTag tag = polygon.tags[i];
      tag.flags = static_cast<uint16_t>(tag.flags & ~neighbour_flags);
      if (r > 0) tag.flags |= EdgeTag::court;
      spans.clear();
      if (std::isfinite(a.x + a.y + b.x + b.y) && !(a == b)) {
        grid.near(a, b, near);
        for (const uint32_t n : near) {
          if (grid.edge(n).footprint == footprint) continue;
          const Span span = covered_by(a, b, grid.edge(n), tolerance);
          if (span.second > span.first) spans.push_back(span);
        }
      }
      add_divided(result, a, b, tag, worth_dividing(spans, length(b - a)));
    }
    result.close_ring();
  }
  for (std::size_t i = 0; i < result.tags.size(); ++i) {
    result.tags[i].wall = static_cast<uint16_t>(std::min<std::size_t>(i, EdgeTag::no_wall));
  }
  return result;
}

}  // namespace

double neighbour_reach(const Streets& streets, double tolerance) {
  return tolerance + 1 + (streets.empty() ? street_clearance : street_reach);
}

void mark_walls(std::span<Footprint> footprints, const std::vector<bool>& wanted,
                const Streets& streets, double tolerance) {
  const EdgeGrid grid(edges_of(footprints), tolerance);
  const StreetEdges street_edges(grid, streets, tolerance);
  for (uint32_t i = 0; i < footprints.size(); ++i) {
    if (!wanted.empty() && !wanted[i]) continue;
    Polygon& polygon = footprints[i].polygon;
    polygon = divided(polygon, i, grid, tolerance);
    street_edges.mark(polygon, i);
  }
}

void mark_neighbours(std::vector<Footprint>& footprints, const std::vector<StreetLine>& streets,
                     double tolerance) {
  Streets lines(streets);
  mark_walls(footprints, {}, lines, tolerance);
  const auto around = std::make_shared<const Surroundings>(
      std::move(lines), [all = footprints](const Surroundings::Take& take) {
        for (const Footprint& footprint : all) take(footprint);
      });
  for (uint32_t i = 0; i < footprints.size(); ++i) {
    footprints[i].around = around;
    footprints[i].place = i;
  }
}

}  // namespace mansard
