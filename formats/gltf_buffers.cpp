#include "formats/gltf_buffers.hpp"

#include <charconv>
#include <limits>
#include <utility>

#include "formats/numbers.hpp"

namespace mansard {

namespace {

/// That of texture coordinates comes last: a model without textures has none.
enum : std::size_t { points_view, normals_view, indices_view, uvs_view };
enum : int { unsigned_short = 5123, unsigned_int = 5125, float_number = 5126 };

std::string list_of(const std::array<float, 3>& values) {
  std::string text = "[";
  for (const float v : values) {
    char digits[number_length];
    text.append(digits, std::to_chars(digits, digits + number_length, v).ptr);
    text += ',';
  }
  text.back() = ']';
  return text;
}

std::string accessor(std::size_t view, uint64_t offset, int type, uint64_t count,
                     std::string_view shape) {
  return "{\"bufferView\":" + std::to_string(view) + ",\"byteOffset\":" + std::to_string(offset) +
         ",\"componentType\":" + std::to_string(type) + ",\"count\":" + std::to_string(count) +
         ",\"type\":\"" + std::string(shape) + "\"";
}

}  // namespace

GltfBuffers::GltfBuffers(const std::string& model)
    : vertices_{Spool(model), Spool(model), Spool(model), Spool(model)},
      pictures_(model),
      accessors_(model) {}

std::string GltfBuffers::add(const GltfPrimitive& primitive) {
  const uint64_t points = add_vectors(points_view, primitive.positions(), 3, &primitive);
  const uint64_t normals = add_vectors(normals_view, primitive.normals(), 3, nullptr);
  std::string text = "\"attributes\":{\"POSITION\":" + std::to_string(points) +
                     ",\"NORMAL\":" + std::to_string(normals);
  if (primitive.has_uvs()) {
    const uint64_t uvs = add_vectors(uvs_view, primitive.uvs(), 2, nullptr);
    text += ",\"TEXCOORD_0\":" + std::to_string(uvs);
  }
  return text + "},\"indices\":" + std::to_string(add_indices(primitive));
}

uint64_t GltfBuffers::add_vectors(std::size_t view, std::span<const float> values, uint32_t width,
                                  const GltfPrimitive* bounded) {
  Spool& spool = vertices_[view];
  std::string text = accessor(view, spool.bytes(), float_number, values.size() / width,
                              width == 3 ? "VEC3" : "VEC2");
  if (bounded)
    text += ",\"min\":" + list_of(bounded->low()) + ",\"max\":" + list_of(bounded->high());
  spool.put_all(values);
  return accessors_.add(text + "}");
}

/// As short as the vertices allow; 65535 is no index.
uint64_t GltfBuffers::add_indices(const GltfPrimitive& primitive) {
  Spool& spool = vertices_[indices_view];
  const std::span<const uint32_t> indices = primitive.indices();
  const bool is_short = primitive.vertices() <= std::numeric_limits<uint16_t>::max();
  const std::string text =
      accessor(indices_view, spool.bytes(), is_short ? unsigned_short : unsigned_int,
               indices.size(), "SCALAR");
  if (is_short) {
    for (const uint32_t i : indices) {
      const auto index = static_cast<uint16_t>(i);
      spool.put(&index, sizeof index);
    }
  } else {
    spool.put_all(indices);
  }
  spool.align();
  return accessors_.add(text + "}");
}

std::size_t GltfBuffers::vertex_views() const {
  std::size_t count = 0;
  while (count < vertices_.size() && vertices_[count].bytes() > 0) ++count;
  return count;
}

std::string GltfBuffers::views(std::span<const std::pair<uint64_t, uint64_t>> pictures) const {
  std::string text;
  const auto add = [&](uint64_t offset, uint64_t bytes, std::string_view rest) {
    text += text.empty() ? "" : ",";
    text += "{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) +
            ",\"byteLength\":" + std::to_string(bytes) + std::string(rest) + "}";
  };
  constexpr std::string_view vectors = ",\"byteStride\":12,\"target\":34962";  // ARRAY_BUFFER
  constexpr std::array<std::string_view, 4> kinds{vectors, vectors, ",\"target\":34963",
                                                  ",\"byteStride\":8,\"target\":34962"};
  uint64_t at = 0;
  for (std::size_t i = 0; i < vertex_views(); ++i) {
    add(at, vertices_[i].bytes(), kinds[i]);
    at += vertices_[i].bytes();
  }
  for (const auto& [offset, bytes] : pictures) add(at + offset, bytes, "");
  return text;
}

uint64_t GltfBuffers::bytes() const {
  uint64_t sum = pictures_.bytes();
  for (const Spool& spool : vertices_) sum += spool.bytes();
  return sum;
}

void GltfBuffers::copy_to(OutputFile& out) {
  for (Spool& spool : vertices_) spool.copy_to(out);
  pictures_.copy_to(out);
}

}  // namespace mansard
