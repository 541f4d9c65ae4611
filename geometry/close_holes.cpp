#include "geometry/close_holes.hpp"

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace mansard {
namespace {

using DirectedEdge = std::pair<uint32_t, uint32_t>;

/// The number of the first point at each place.
std::vector<uint32_t> weld(std::span<const Vec3> points) {
  const auto cell = [](double v) { return std::llround(v * 1e6); };
  std::map<std::array<long long, 3>, uint32_t> places;
  std::vector<uint32_t> first;
  for (const Vec3 p : points) {
    const auto number = static_cast<uint32_t>(first.size());
    first.push_back(places.try_emplace({cell(p.x), cell(p.y), cell(p.z)}, number).first->second);
  }
  return first;
}

/// Edges of faces without a face that has them in the other direction.
std::multimap<uint32_t, uint32_t> open_edges(const Mesh& mesh) {
  const std::vector<uint32_t> welded = weld(mesh.points);
  std::map<DirectedEdge, int> open;
  for (const Mesh::Face& face : mesh.faces) {
    const auto loop = mesh.loop(face);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const uint32_t a = welded[loop[i]], b = welded[loop[(i + 1) % loop.size()]];
      if (a == b) continue;
      const auto back = open.find({b, a});
      if (back == open.end()) {
        ++open[{a, b}];
      } else if (--back->second == 0) {
        open.erase(back);
      }
    }
  }
  std::multimap<uint32_t, uint32_t> edges;
  for (const auto& [edge, count] : open) edges.insert(edge);
  return edges;
}

}  // namespace

void close_holes(Mesh& mesh) {
  // The new faces run against the edges.
  std::multimap<uint32_t, uint32_t> next;
  for (const auto& [from, to] : open_edges(mesh)) next.insert({to, from});
  while (!next.empty()) {
    std::vector<uint32_t> loop{next.begin()->first};
    for (auto step = next.begin(); step != next.end(); step = next.find(loop.back())) {
      const uint32_t to = step->second;
      next.erase(step);
      if (to == loop.front()) {
        if (loop.size() >= 3) mesh.add_face(loop);
        break;
      }
      loop.push_back(to);
    }
  }
}

}  // namespace mansard
