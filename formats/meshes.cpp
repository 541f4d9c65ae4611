#include "formats/meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <unordered_map>

#include "formats/mesh_process.hpp"
#include "formats/obj_reader.hpp"
#include "geometry/clip.hpp"

namespace mansard {
namespace {

namespace fs = std::filesystem;

/// Points at the same place become one: formats that keep a point's normal and UV with it repeat
/// it for every face, and the solid would fall apart into faces.
void weld(Mesh& mesh) {
  struct Hash {
    std::size_t operator()(const Vec3& p) const {
      const std::hash<double> h;  // of 0 and -0 the same
      return (h(p.x) * 31 + h(p.y)) * 31 + h(p.z);
    }
  };
  std::unordered_map<Vec3, uint32_t, Hash> numbers;
  std::vector<Vec3> points;
  std::vector<uint32_t> renumbered(mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const auto fresh = static_cast<uint32_t>(points.size());
    const auto [at, added] = numbers.try_emplace(mesh.points[i], fresh);
    if (added) points.push_back(mesh.points[i]);
    renumbered[i] = at->second;
  }
  for (uint32_t& corner : mesh.corners) corner = renumbered[corner];
  mesh.points = std::move(points);
}

/// What no mesh of a building has.
std::string fault(const Mesh& mesh) {
  constexpr uint32_t most_corners = 10000;
  for (const Vec3& p : mesh.points) {
    if (!std::isfinite(p.x + p.y + p.z)) return "it has a vertex that is not finite";
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > furthest_point)
      return "it reaches further than a million km";
  }
  const auto many = std::ranges::find_if(
      mesh.faces, [](const Mesh::Face& face) { return face.end - face.begin > most_corners; });
  if (many == mesh.faces.end()) return {};
  return "it has a face of " + std::to_string(many->end - many->begin) + " corners, more than " +
         std::to_string(most_corners);
}

/// Within a millionth of the face's extent.
bool is_planar(std::span<const Vec3> loop, Vec3 normal) {
  const Vec3 n = normalized(normal);
  const double tolerance = 1e-6 * length(bounds(loop).size());
  return std::all_of(loop.begin(), loop.end(),
                     [&](Vec3 p) { return std::abs(dot(n, p - loop[0])) <= tolerance; });
}

/// Every edge has its opposite.
bool is_closed(const Mesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> balance;
  for (const Mesh::Face& face : mesh.faces) {
    const auto loop = mesh.loop(face);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      if (a != b) balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return std::ranges::all_of(balance, [](const auto& edge) { return edge.second == 0; });
}

/// Below 0 where a closed mesh shows its inside.
double volume(const Mesh& mesh) {
  double sum = 0;
  std::vector<Vec3> loop;
  for (const Mesh::Face& face : mesh.faces) {
    loop.clear();
    for (const uint32_t corner : mesh.loop(face))
      loop.push_back(mesh.points[corner] - mesh.points[0]);
    sum += dot(loop[0], newell(loop)) / 6;
  }
  return sum;
}

void turn(Mesh& mesh) {
  for (const Mesh::Face& face : mesh.faces) {
    std::reverse(mesh.corners.begin() + face.begin, mesh.corners.begin() + face.end);
    if (!mesh.uvs.empty()) std::reverse(mesh.uvs.begin() + face.begin, mesh.uvs.begin() + face.end);
  }
}

/// Copies the face if it is planar, else its triangles; nothing of what has no area.
class Tidied {
 public:
  explicit Tidied(const Mesh& from) : from_(from) {
    to.points = from.points;
    to.materials = from.materials;
  }
  void add(const Mesh::Face& face) {
    loop_.clear();
    for (uint32_t corner : from_.loop(face)) loop_.push_back(from_.points[corner]);
    const Vec3 normal = newell(loop_);
    if (length(normal) > 0 && (loop_.size() == 3 || is_planar(loop_, normal))) {
      chosen_.resize(loop_.size());
      for (uint32_t i = 0; i < chosen_.size(); ++i) chosen_[i] = i;
      return add_part(face, chosen_);
    }
    const std::vector<uint32_t> triangles = triangulate(loop_);
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
      const std::array part{triangles[i], triangles[i + 1], triangles[i + 2]};
      const Vec3 a = loop_[part[0]], b = loop_[part[1]], c = loop_[part[2]];
      if (length(cross(b - a, c - a)) > 0) add_part(face, part);
    }
  }
  Mesh to;

 private:
  void add_part(const Mesh::Face& face, std::span<const uint32_t> corners) {
    const auto begin = static_cast<uint32_t>(to.corners.size());
    for (uint32_t corner : corners) {
      to.corners.push_back(from_.corners[face.begin + corner]);
      if (!from_.uvs.empty()) to.uvs.push_back(from_.uvs[face.begin + corner]);
    }
    to.faces.push_back(face);
    to.faces.back().begin = begin;
    to.faces.back().end = static_cast<uint32_t>(to.corners.size());
  }
  const Mesh& from_;
  std::vector<Vec3> loop_;
  std::vector<uint32_t> chosen_;
};

}  // namespace

std::optional<Mesh> read_mesh(const std::string& path, std::string& problem,
                              const MeshLimits& limits) {
  problem = refusal(path, limits);
  if (!problem.empty() && problem != "no such file") problem.insert(0, "it ");
  if (!problem.empty()) return {};
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  std::optional<Mesh> mesh;
  if (ending == ".obj") {
    if (auto file = read_obj(path, problem, limits)) mesh = std::move(file->mesh);
  } else {
    mesh = read_apart(path, limits, problem);
  }
  if (!mesh) return {};
  return tidied(std::move(*mesh), problem);
}

std::optional<Mesh> tidied(Mesh mesh, std::string& problem) {
  problem = fault(mesh);
  if (!problem.empty()) return {};
  weld(mesh);
  Tidied tidied(mesh);
  for (const Mesh::Face& face : mesh.faces) tidied.add(face);
  if (tidied.to.faces.empty()) {
    problem = "it has no faces with an area";
    return {};
  }
  if (is_closed(mesh) && volume(mesh) < 0) turn(tidied.to);
  return std::move(tidied.to);
}

}  // namespace mansard
