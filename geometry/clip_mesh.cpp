#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/clip.hpp"
#include "geometry/clip_line.hpp"
#include "geometry/clip_outline.hpp"

namespace mansard {
namespace {

/// Points of the cut closer than this, in metres, are one: meshes from files repeat their points.
constexpr double weld_distance = 1e-7;

using DirectedEdge = std::pair<uint32_t, uint32_t>;

class PlaneCutter {
 public:
  PlaneCutter(const Mesh& mesh, Vec3 normal, double offset, double tolerance);
  Mesh closed();
  Mesh open();

 private:
  void cut_face(const Mesh::Face& face);
  void copy_face(const Mesh::Face& face);
  void add_piece(const Mesh::Face& face, std::span<const CutCorner> corners);
  uint32_t kept_point(uint32_t old);
  uint32_t crossing_point(uint32_t a, uint32_t b, double& t);

  void cap();
  std::vector<uint32_t> weld() const;
  std::map<DirectedEdge, uint32_t> open_edges(const std::vector<uint32_t>& welded) const;
  void add_cap(const Polygon& outline, uint32_t material);
  void add_cap_face(std::span<const uint32_t> loop, uint32_t material);
  Vec2 flat(Vec3 p) const { return {dot(p, across_), dot(p, up_)}; }

  const Mesh& mesh_;
  Vec3 normal_, across_, up_;  // across x up = normal
  double tolerance_;
  bool any_kept_ = false, any_cut_ = false;
  std::vector<double> side_;  // of mesh_'s points
  Mesh result_;
  std::vector<bool> on_plane_;  // of result_'s points
  std::vector<uint32_t> kept_;  // new number of each old point
  std::map<DirectedEdge, uint32_t> crossings_;
  std::map<std::pair<double, double>, uint32_t> numbers_;  // of flat points of the cap
};

constexpr uint32_t nothing = 0xffffffff;

PlaneCutter::PlaneCutter(const Mesh& mesh, Vec3 normal, double offset, double tolerance)
    : mesh_(mesh), normal_(normal), tolerance_(tolerance), kept_(mesh.points.size(), nothing) {
  const Vec3 least = std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  across_ = normalized(cross(least, normal));
  up_ = cross(normal, across_);
  for (const Vec3 p : mesh.points) {
    const double side = dot(normal, p) - offset;
    side_.push_back(std::abs(side) <= tolerance ? 0 : side);
    any_kept_ = any_kept_ || side_.back() < 0;
    any_cut_ = any_cut_ || side_.back() > 0;
  }
}

Mesh PlaneCutter::closed() {
  if (!any_cut_) return mesh_;
  Mesh unclosed = open();
  if (!any_kept_) return unclosed;
  result_ = std::move(unclosed);
  cap();
  return std::move(result_);
}

Mesh PlaneCutter::open() {
  if (!any_cut_) return mesh_;
  if (!any_kept_) return {};
  result_.materials = mesh_.materials;
  for (const Mesh::Face& face : mesh_.faces) {
    bool below = false, above = false;
    for (const uint32_t c : mesh_.loop(face)) {
      below = below || side_[c] < 0;
      above = above || side_[c] > 0;
    }
    if (below && above) {
      cut_face(face);
    } else if (below) {
      copy_face(face);
    } else if (!above) {
      // On the plane: the lid of what is kept stays, the floor of what goes away goes with it.
      std::vector<Vec3> loop;
      for (const uint32_t c : mesh_.loop(face)) loop.push_back(mesh_.points[c]);
      if (dot(newell(loop), normal_) > 0) copy_face(face);
    }
  }
  return std::move(result_);
}

void PlaneCutter::copy_face(const Mesh::Face& face) {
  std::vector<uint32_t> loop;
  for (const uint32_t c : mesh_.loop(face)) loop.push_back(kept_point(c));
  if (!mesh_.uvs.empty()) {
    result_.uvs.insert(result_.uvs.end(), mesh_.uvs.begin() + face.begin,
                       mesh_.uvs.begin() + face.end);
  }
  result_.add_face(loop, face.tag, face.material);
}

void PlaneCutter::cut_face(const Mesh::Face& face) {
  const auto corners = mesh_.loop(face);
  std::vector<Vec3> loop;
  std::vector<double> side, along;
  for (const uint32_t c : corners) {
    loop.push_back(mesh_.points[c]);
    side.push_back(side_[c]);
  }
  const Vec3 right = normalized(cross(normal_, newell(loop)));
  for (const Vec3 p : loop) along.push_back(dot(p, right));
  const uint32_t ends[] = {static_cast<uint32_t>(corners.size())};
  const LineCut cut = cut_by_line(side, along, ends, tolerance_);
  uint32_t begin = 0;
  for (const uint32_t end : cut.loop_ends) {
    add_piece(face, {cut.corners.data() + begin, cut.corners.data() + end});
    begin = end;
  }
}

void PlaneCutter::add_piece(const Mesh::Face& face, std::span<const CutCorner> corners) {
  const auto old = mesh_.loop(face);
  const bool has_uvs = !mesh_.uvs.empty();
  std::vector<uint32_t> loop;
  std::vector<Vec2> uvs;
  for (const CutCorner& corner : corners) {
    const uint32_t next = (corner.edge + 1) % old.size();
    double t = 0;
    const uint32_t point = corner.crossing ? crossing_point(old[corner.edge], old[next], t)
                                           : kept_point(old[corner.edge]);
    if (!loop.empty() && loop.back() == point) continue;
    loop.push_back(point);
    if (!has_uvs) continue;
    uvs.push_back(mix(mesh_.uvs[face.begin + corner.edge], mesh_.uvs[face.begin + next], t));
  }
  if (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
  if (has_uvs) uvs.resize(loop.size());
  if (loop.size() < 3) return;
  result_.add_face(loop, face.tag, face.material);
  result_.uvs.insert(result_.uvs.end(), uvs.begin(), uvs.end());
}

uint32_t PlaneCutter::kept_point(uint32_t old) {
  if (kept_[old] == nothing) {
    kept_[old] = static_cast<uint32_t>(result_.points.size());
    result_.points.push_back(mesh_.points[old]);
    on_plane_.push_back(side_[old] == 0);
  }
  return kept_[old];
}

/// `t` is where the edge from a to b crosses, 0..1.
uint32_t PlaneCutter::crossing_point(uint32_t a, uint32_t b, double& t) {
  t = side_[a] / (side_[a] - side_[b]);
  const auto [at, added] = crossings_.try_emplace({std::min(a, b), std::max(a, b)},
                                                  static_cast<uint32_t>(result_.points.size()));
  if (added) {
    const auto [low, high] = at->first;
    const double share = side_[low] / (side_[low] - side_[high]);
    result_.points.push_back(mix(mesh_.points[low], mesh_.points[high], share));
    on_plane_.push_back(true);
  }
  return at->second;
}

/// Chains the edges that lie open on the plane to loops and closes each by a face.
void PlaneCutter::cap() {
  const std::vector<uint32_t> welded = weld();
  // The lid runs against the walls: each open edge a-b is an edge b-a of the lid.
  std::multimap<uint32_t, std::pair<uint32_t, uint32_t>> next;
  for (const auto& [edge, material] : open_edges(welded)) {
    next.insert({edge.second, {edge.first, material}});
  }
  Polygon loops;
  uint32_t material = 0;
  while (!next.empty()) {
    const uint32_t first = next.begin()->first;
    const auto begin = loops.points.size();
    uint32_t at = first;
    do {
      const auto step = next.find(at);
      if (step == next.end()) break;
      const Vec2 p = flat(result_.points[at]);
      numbers_.try_emplace({p.x, p.y}, at);
      loops.add_point(p);
      at = step->second.first;
      material = step->second.second;
      next.erase(step);
    } while (at != first);
    if (at == first) {
      loops.close_ring();
    } else {  // the solid is open here
      loops.points.resize(begin);
      loops.tags.resize(begin);
    }
  }
  for (const Polygon& outline : assemble(loops, tolerance_)) add_cap(outline, material);
}

/// The number of the first point at each place, for points on the plane.
std::vector<uint32_t> PlaneCutter::weld() const {
  std::vector<uint32_t> first(result_.points.size()), order;
  std::iota(first.begin(), first.end(), 0);
  for (const uint32_t i : first) {
    if (on_plane_[i]) order.push_back(i);
  }
  const auto u = [&](uint32_t i) { return dot(result_.points[i], across_); };
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return u(a) < u(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i; j-- > 0 && u(order[i]) - u(order[j]) <= weld_distance;) {
      const Vec3 gap = result_.points[order[i]] - result_.points[order[j]];
      if (dot(gap, gap) <= weld_distance * weld_distance) first[order[i]] = first[order[j]];
    }
  }
  return first;
}

/// Edges on the plane with no neighbour there, with their face's material. Edges that had none
/// before the cut stay open.
std::map<DirectedEdge, uint32_t> PlaneCutter::open_edges(
    const std::vector<uint32_t>& welded) const {
  std::map<DirectedEdge, uint32_t> open;
  const auto add = [&](uint32_t a, uint32_t b, uint32_t material) {
    if (a == b || open.erase({b, a}) > 0) return;
    open[{a, b}] = material;
  };
  for (const Mesh::Face& face : result_.faces) {
    const auto loop = result_.loop(face);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      if (on_plane_[a] && on_plane_[b]) add(welded[a], welded[b], face.material);
    }
  }
  // The faces that went away give their edges too: what is still open then was open all along.
  std::map<DirectedEdge, uint32_t> before;
  for (const Mesh::Face& face : mesh_.faces) {
    const auto loop = mesh_.loop(face);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      if (side_[a] != 0 || side_[b] != 0 || kept_[a] == nothing || kept_[b] == nothing) continue;
      a = welded[kept_[a]];
      b = welded[kept_[b]];
      if (before.erase({b, a}) == 0) before[{a, b}] = 0;
    }
  }
  for (const auto& [edge, unused] : before) open.erase(edge);
  return open;
}

void PlaneCutter::add_cap(const Polygon& outline, uint32_t material) {
  std::vector<uint32_t> loop;
  for (const Vec2 p : outline.points) loop.push_back(numbers_.at({p.x, p.y}));
  if (!outline.has_holes()) {
    add_cap_face(loop, material);
    return;
  }
  const std::vector<uint32_t> triangles = triangulate(outline);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const uint32_t corners[] = {loop[triangles[i]], loop[triangles[i + 1]], loop[triangles[i + 2]]};
    add_cap_face(corners, material);
  }
}

void PlaneCutter::add_cap_face(std::span<const uint32_t> loop, uint32_t material) {
  result_.add_face(loop, {EdgeTag::cut, EdgeTag::no_wall}, material);
  if (!mesh_.uvs.empty()) result_.uvs.resize(result_.corners.size());
}

}  // namespace

Mesh clip(const Mesh& mesh, Vec3 normal, double offset, double tolerance) {
  return PlaneCutter(mesh, normal, offset, tolerance).closed();
}

Mesh clip_open(const Mesh& mesh, Vec3 normal, double offset, double tolerance) {
  return PlaneCutter(mesh, normal, offset, tolerance).open();
}

}  // namespace mansard
