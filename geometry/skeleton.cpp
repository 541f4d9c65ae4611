// CGAL's straight skeleton (Aichholzer & Aurenhammer 1996; Cacciola's package): the only file that
// sees CGAL's headers for it, since they take long to compile.
#include "geometry/skeleton.hpp"

#include <exception>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/create_straight_skeleton_2.h>

namespace mansard {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Ring = std::vector<Kernel::Point_2>;

// Local coordinates, so that far away polygons get the same skeleton.
Ring ring_of(const Polygon& polygon, std::size_t r) {
  Ring ring;
  for (const Vec2 p : polygon.ring(r)) {
    const Vec2 local = p - polygon.points[0];
    ring.emplace_back(local.x, local.y);
  }
  return ring;
}

// CGAL numbers the vertices of the rings first, in their order; this is checked and not trusted.
template <class Skeleton>
bool numbered_like(const Polygon& polygon, const Skeleton& skeleton) {
  for (auto v = skeleton.vertices_begin(); v != skeleton.vertices_end(); ++v) {
    const auto id = static_cast<std::size_t>(v->id());
    if (v->is_contour() != (id < polygon.points.size())) return false;
    if (!v->is_contour()) continue;
    const Vec2 local = polygon.points[id] - polygon.points[0];
    if (v->point().x() != local.x || v->point().y() != local.y) return false;
  }
  return true;
}

template <class Skeleton>
std::optional<SkeletonMesh> mesh_of(const Polygon& polygon, const Skeleton& skeleton) {
  const std::size_t n = polygon.points.size();
  if (!numbered_like(polygon, skeleton) || skeleton.size_of_faces() != n) return std::nullopt;
  SkeletonMesh mesh;
  mesh.nodes.resize(n);
  for (auto v = skeleton.vertices_begin(); v != skeleton.vertices_end(); ++v) {
    const auto id = static_cast<std::size_t>(v->id());
    if (id >= mesh.nodes.size()) mesh.nodes.resize(id + 1);
    mesh.nodes[id] = {v->point().x() + polygon.points[0].x, v->point().y() + polygon.points[0].y,
                      v->time()};
  }
  std::vector<std::vector<uint32_t>> loops(n);
  for (auto f = skeleton.faces_begin(); f != skeleton.faces_end(); ++f) {
    auto wall = f->halfedge();
    while (wall->is_bisector()) wall = wall->next();
    const auto from = static_cast<std::size_t>(wall->opposite()->vertex()->id());
    if (from >= n) return std::nullopt;
    std::vector<uint32_t>& loop = loops[from];
    loop.push_back(static_cast<uint32_t>(from));
    for (auto h = wall; h->next() != wall; h = h->next()) {
      loop.push_back(static_cast<uint32_t>(h->vertex()->id()));
    }
  }
  for (const std::vector<uint32_t>& loop : loops) {
    mesh.corners.insert(mesh.corners.end(), loop.begin(), loop.end());
    mesh.face_ends.push_back(static_cast<uint32_t>(mesh.corners.size()));
  }
  return mesh;
}

}  // namespace

std::optional<SkeletonMesh> raw_skeleton(const Polygon& polygon) try {
  const Ring outline = ring_of(polygon, 0);
  std::vector<Ring> holes;
  for (std::size_t r = 1; r < polygon.rings(); ++r) holes.push_back(ring_of(polygon, r));
  const auto skeleton = CGAL::create_interior_straight_skeleton_2(
      outline.begin(), outline.end(), holes.begin(), holes.end(), Kernel());
  if (!skeleton) return std::nullopt;
  return mesh_of(polygon, *skeleton);
} catch (const std::exception&) {  // CGAL's assertions, where they are compiled in
  return std::nullopt;
}

}  // namespace mansard
