#include "geometry/triangulate_delaunay.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <exception>
#include <map>
#include <utility>

namespace mansard {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<uint32_t, Kernel>;
/// A face knows how many edges lie between it and the outside, -1 when that is not known yet.
using Face =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;
/// How often each edge was asked for; one that two rings share separates nothing.
using EdgeCounts = std::map<std::pair<uint32_t, uint32_t>, int>;

EdgeCounts insert_edges(const Polygon& polygon, Triangulation& triangulation) {
  std::vector<Triangulation::Vertex_handle> vertices;
  for (uint32_t i = 0; i < polygon.points.size(); ++i) {
    const auto near = i == 0 ? nullptr : vertices.back()->face();
    const auto before = triangulation.number_of_vertices();
    vertices.push_back(triangulation.insert({polygon.points[i].x, polygon.points[i].y}, near));
    if (triangulation.number_of_vertices() > before) vertices.back()->info() = i;
  }
  EdgeCounts counts;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) {
      const auto from = vertices[i], to = vertices[i + 1 == end ? begin : i + 1];
      if (from == to) continue;
      triangulation.insert_constraint(from, to);
      ++counts[std::minmax(from->info(), to->info())];
    }
  }
  return counts;
}

/// Floods from the outside, one step deeper behind every edge.
void count_depths(Triangulation& triangulation, const EdgeCounts& counts) {
  for (const auto face : triangulation.all_face_handles()) face->info() = -1;
  std::vector<Triangulation::Face_handle> reached{triangulation.infinite_face()};
  reached.front()->info() = 0;
  while (!reached.empty()) {
    const auto face = reached.back();
    reached.pop_back();
    for (int i = 0; i < 3; ++i) {
      const auto neighbour = face->neighbor(i);
      if (neighbour->info() >= 0) continue;
      int crossed = 0;
      if (face->is_constrained(i)) {
        const auto a = face->vertex(Triangulation::cw(i)), b = face->vertex(Triangulation::ccw(i));
        const auto count = counts.find(std::minmax(a->info(), b->info()));
        crossed = count == counts.end() ? 1 : count->second;
      }
      neighbour->info() = (face->info() + crossed) % 2;
      reached.push_back(neighbour);
    }
  }
}

}  // namespace

std::optional<std::vector<uint32_t>> triangulate_delaunay(const Polygon& polygon) {
  try {
    Triangulation triangulation;
    const EdgeCounts counts = insert_edges(polygon, triangulation);
    std::vector<uint32_t> triangles;
    if (triangulation.dimension() < 2) return triangles;
    count_depths(triangulation, counts);
    for (const auto face : triangulation.finite_face_handles()) {
      if (face->info() != 1) continue;
      for (int i = 0; i < 3; ++i) triangles.push_back(face->vertex(i)->info());
    }
    return triangles;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace mansard
