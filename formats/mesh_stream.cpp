#include "formats/mesh_stream.hpp"

#include <algorithm>

#include "formats/bytes.hpp"

namespace mansard {
namespace {

constexpr char is_mesh = 'm', is_problem = 'p';

bool is_sound(const Mesh& mesh) {
  const bool corners = std::ranges::all_of(
      mesh.corners, [&](uint32_t corner) { return corner < mesh.points.size(); });
  const bool faces = std::ranges::all_of(mesh.faces, [&](const Mesh::Face& face) {
    return face.begin + 3 <= face.end && face.end <= mesh.corners.size();
  });
  return corners && faces && (mesh.uvs.empty() || mesh.uvs.size() == mesh.corners.size());
}

}  // namespace

std::string to_bytes(const Mesh& mesh) {
  std::string bytes(1, is_mesh);
  put_values(bytes, mesh.points);
  put_values(bytes, mesh.corners);
  put_values(bytes, mesh.uvs);
  put_values(bytes, mesh.faces);
  for (const Mesh::Material& material : mesh.materials) {
    put_values(bytes, material.name);
    const double numbers[] = {material.color.x, material.color.y, material.color.z,
                              material.opacity, material.overlay ? 1.0 : 0.0};
    put_values(bytes, numbers, 5);
    put_values(bytes, material.texture);
    put_values(bytes, material.picture);
  }
  return bytes;
}

std::string to_bytes(std::string_view problem) { return is_problem + std::string(problem); }

std::optional<Mesh> mesh_from_bytes(std::string_view bytes, std::string& problem) {
  if (bytes.starts_with(is_problem)) {
    problem = bytes.substr(1);
    return {};
  }
  if (!bytes.starts_with(is_mesh)) return {};
  Bytes from(bytes.substr(1));
  Mesh mesh;
  mesh.points = from.take<std::vector<Vec3>>();
  mesh.corners = from.take<std::vector<uint32_t>>();
  mesh.uvs = from.take<std::vector<Vec2>>();
  mesh.faces = from.take<std::vector<Mesh::Face>>();
  if (!from.whole() || !is_sound(mesh)) return {};
  while (from.any()) {
    Mesh::Material& material = mesh.materials.emplace_back();
    material.name = from.take<std::string>();
    const auto numbers = from.take<std::vector<double>>();
    material.texture = from.take<std::string>();
    material.picture = from.take<std::string>();
    if (!from.whole() || numbers.size() != 5) return {};
    material.color = {numbers[0], numbers[1], numbers[2]};
    material.opacity = numbers[3];
    material.overlay = numbers[4] != 0;
  }
  return mesh;
}

}  // namespace mansard
