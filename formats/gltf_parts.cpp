#include "formats/gltf_parts.hpp"

#include <span>
#include <string>

#include "formats/draco_module.hpp"
#include "formats/module.hpp"
#include "grammar/diagnostic.hpp"

namespace mansard {

void GltfParts::add(const GltfPrimitive& primitive, uint32_t look) {
  GltfPart& part = parts_.emplace_back();
  part.look = look;
  part.vertices = primitive.vertices();
  part.corners = primitive.indices().size();
  part.uvs = primitive.has_uvs();
  part.tangents = !primitive.tangents().empty();
  part.low = primitive.low();
  part.high = primitive.high();
  part.begin = bytes_.size();
  draco_ ? add_draco(primitive, part) : add_plain(primitive);
}

void GltfParts::put(const void* bytes, std::size_t count) {
  const char* const from = static_cast<const char*>(bytes);
  bytes_.insert(bytes_.end(), from, from + count);
}

void GltfParts::add_plain(const GltfPrimitive& primitive) {
  for (const std::span<const float> values :
       {primitive.normals(), primitive.positions(), primitive.uvs(), primitive.tangents()})
    put(values.data(), values.size_bytes());
  const std::span<const uint32_t> indices = primitive.indices();
  if (!parts_.back().short_indices()) return put(indices.data(), indices.size_bytes());
  const std::size_t begin = bytes_.size();
  bytes_.resize(begin + (2 * indices.size() + 3) / 4 * 4);
  char* to = bytes_.data() + begin;
  for (const uint32_t i : indices) {  // little-endian
    *to++ = static_cast<char>(i);
    *to++ = static_cast<char>(i >> 8);
  }
}

namespace {

void encode(DracoTriangles& triangles) {
  std::string problem;
  const auto encoder = reinterpret_cast<decltype(&mansard_encode_draco)>(
      module_symbol("mansard_draco", "mansard_encode_draco", problem));
  if (encoder && encoder(triangles, problem)) return;
  Diagnostic d;
  d.text = "Draco can not compress the model: " + problem;
  d.help = "write it without --compress";
  throw Failure(std::move(d));
}

}  // namespace

void GltfParts::add_draco(const GltfPrimitive& primitive, GltfPart& part) {
  using What = DracoTriangles::Kind;
  const std::array<DracoTriangles::Attribute, 4> attributes{
      {{What::position, primitive.positions()},
       {What::normal, primitive.normals()},
       {What::uv, primitive.uvs()},
       {What::tangent, primitive.tangents()}}};
  DracoTriangles triangles;
  triangles.attributes = std::span(attributes).first(!part.uvs ? 2 : !part.tangents ? 3 : 4);
  triangles.indices = primitive.indices();
  encode(triangles);
  part.vertices = triangles.vertices;
  part.corners = 3 * uint64_t(triangles.triangles);
  put(triangles.bytes.data(), triangles.bytes.size());
}

}  // namespace mansard
