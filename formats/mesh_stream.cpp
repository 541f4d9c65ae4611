#include "formats/mesh_stream.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace mansard {
namespace {

constexpr char is_mesh = 'm', is_problem = 'p';

template <class T>
void put(std::string& to, const T* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  const uint64_t size = count;
  to.append(reinterpret_cast<const char*>(&size), sizeof size);
  to.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

class Bytes {
 public:
  explicit Bytes(std::string_view left) : left_(left) {}
  /// A vector or a string; empty, and whole() no longer holds, where there is too little.
  template <class Values>
  Values take() {
    using T = typename Values::value_type;
    uint64_t count = 0;
    whole_ = whole_ && left_.size() >= sizeof count;
    if (!whole_) return {};
    std::memcpy(&count, left_.data(), sizeof count);
    left_.remove_prefix(sizeof count);
    whole_ = count <= left_.size() / sizeof(T);
    if (!whole_) return {};
    Values values(count, T{});
    if (count > 0) std::memcpy(values.data(), left_.data(), count * sizeof(T));
    left_.remove_prefix(count * sizeof(T));
    return values;
  }
  bool whole() const { return whole_; }
  bool any() const { return !left_.empty(); }

 private:
  std::string_view left_;
  bool whole_ = true;
};

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
  put(bytes, mesh.points.data(), mesh.points.size());
  put(bytes, mesh.corners.data(), mesh.corners.size());
  put(bytes, mesh.uvs.data(), mesh.uvs.size());
  put(bytes, mesh.faces.data(), mesh.faces.size());
  for (const Mesh::Material& material : mesh.materials) {
    put(bytes, material.name.data(), material.name.size());
    const double numbers[] = {material.color.x, material.color.y, material.color.z,
                              material.opacity, material.overlay ? 1.0 : 0.0};
    put(bytes, numbers, 5);
    put(bytes, material.texture.data(), material.texture.size());
    put(bytes, material.picture.data(), material.picture.size());
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
