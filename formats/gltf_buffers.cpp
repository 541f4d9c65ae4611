#include "formats/gltf_buffers.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "formats/draco_module.hpp"
#include "formats/module.hpp"
#include "formats/numbers.hpp"
#include "grammar/diagnostic.hpp"

namespace mansard {

namespace {

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

/// Where an accessor finds its items; nowhere for what Draco has.
struct Place {
  std::size_t view;
  uint64_t offset;
};

/// Without its closing brace.
std::string accessor(std::optional<Place> place, int type, uint64_t count, std::string_view shape) {
  std::string text = "{";
  if (place)
    text += "\"bufferView\":" + std::to_string(place->view) +
            ",\"byteOffset\":" + std::to_string(place->offset) + ",";
  return text + "\"componentType\":" + std::to_string(type) +
         ",\"count\":" + std::to_string(count) + ",\"type\":\"" + std::string(shape) + "\"";
}

std::string bounds_of(const GltfPrimitive& primitive) {
  return ",\"min\":" + list_of(primitive.low()) + ",\"max\":" + list_of(primitive.high());
}

/// As short as the vertices allow; 65535 is no index.
int index_type(uint64_t vertices) {
  return vertices <= std::numeric_limits<uint16_t>::max() ? unsigned_short : unsigned_int;
}

}  // namespace

GltfBuffers::GltfBuffers(const std::string& model, bool draco)
    : draco_(draco),
      kinds_{Spool(model), Spool(model), Spool(model), Spool(model), Spool(model), Spool(model)},
      compressed_(model),
      pictures_(model),
      views_(model),
      accessors_(model) {}

std::string GltfBuffers::add(const GltfPrimitive& primitive) {
  if (draco_) return add_draco(primitive);
  std::string text =
      "\"attributes\":{\"POSITION\":" +
      std::to_string(add_vectors(points, primitive.positions(), 3, &primitive)) +
      ",\"NORMAL\":" + std::to_string(add_vectors(normals, primitive.normals(), 3, nullptr));
  if (primitive.has_uvs())
    text += ",\"TEXCOORD_0\":" + std::to_string(add_vectors(uvs, primitive.uvs(), 2, nullptr));
  if (!primitive.tangents().empty()) {
    const uint64_t number = add_vectors(tangents, primitive.tangents(), 4, nullptr);
    text += ",\"TANGENT\":" + std::to_string(number);
  }
  return text + "},\"indices\":" + std::to_string(add_indices(primitive));
}

std::size_t GltfBuffers::view_of(Kind kind) {
  const auto at = std::ranges::find(order_, kind);
  const auto number = static_cast<std::size_t>(at - order_.begin());
  if (at == order_.end()) order_.push_back(kind);
  return number;
}

uint64_t GltfBuffers::add_vectors(Kind kind, std::span<const float> values, uint32_t width,
                                  const GltfPrimitive* bounded) {
  Spool& spool = kinds_[kind];
  std::string text = accessor(Place{view_of(kind), spool.bytes()}, float_number,
                              values.size() / width, "VEC" + std::to_string(width));
  if (bounded) text += bounds_of(*bounded);
  spool.put_all(values);
  return accessors_.add(text + "}");
}

uint64_t GltfBuffers::add_indices(const GltfPrimitive& primitive) {
  Spool& spool = kinds_[indices];
  const std::span<const uint32_t> all = primitive.indices();
  const int type = index_type(primitive.vertices());
  const std::string text =
      accessor(Place{view_of(indices), spool.bytes()}, type, all.size(), "SCALAR");
  if (type == unsigned_short) {
    for (const uint32_t i : all) {
      const auto index = static_cast<uint16_t>(i);
      spool.put(&index, sizeof index);
    }
  } else {
    spool.put_all(all);
  }
  spool.align();
  return accessors_.add(text + "}");
}

// ---- Draco

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

/// The accessors say what the decoder will give and have no view.
std::string GltfBuffers::add_draco(const GltfPrimitive& primitive) {
  using What = DracoTriangles::Kind;
  const std::array<DracoTriangles::Attribute, 4> attributes{
      {{What::position, primitive.positions()},
       {What::normal, primitive.normals()},
       {What::uv, primitive.uvs()},
       {What::tangent, primitive.tangents()}}};
  const std::size_t given = !primitive.has_uvs() ? 2 : primitive.tangents().empty() ? 3 : 4;
  DracoTriangles triangles;
  triangles.attributes = std::span(attributes).first(given);
  triangles.indices = primitive.indices();
  encode(triangles);
  std::string accessor_numbers, draco_numbers;
  for (std::size_t i = 0; i < triangles.attributes.size(); ++i) {
    constexpr std::array<std::string_view, 4> names{"POSITION", "NORMAL", "TEXCOORD_0", "TANGENT"};
    constexpr std::array<std::string_view, 4> shapes{"VEC3", "VEC3", "VEC2", "VEC4"};
    std::string text = accessor({}, float_number, triangles.vertices, shapes[i]);
    if (i == 0) text += bounds_of(primitive);
    const std::string key = (i == 0 ? "\"" : ",\"") + std::string(names[i]) + "\":";
    accessor_numbers += key + std::to_string(accessors_.add(text + "}"));
    draco_numbers += key + std::to_string(i);
  }
  const uint64_t index_accessor = accessors_.add(
      accessor({}, index_type(triangles.vertices), 3 * uint64_t(triangles.triangles), "SCALAR") +
      "}");
  add_view(compressed_.bytes(), triangles.bytes.size(), "");
  compressed_.put(triangles.bytes);
  compressed_.align();
  return "\"attributes\":{" + accessor_numbers + "},\"indices\":" + std::to_string(index_accessor) +
         ",\"extensions\":{\"KHR_draco_mesh_compression\":{\"bufferView\":" +
         std::to_string(views_.size() - 1) + ",\"attributes\":{" + draco_numbers + "}}}";
}

// ---- instances

std::string GltfBuffers::add(std::span<const GltfPlace> all) {
  Spool& spool = draco_ ? compressed_ : kinds_[instances];
  const uint64_t begin = spool.bytes();
  const std::size_t view = draco_ ? views_.size() : view_of(instances);
  std::string text;
  const auto put = [&](std::string_view name, std::string_view shape, auto values_of) {
    const Place place{view, spool.bytes() - (draco_ ? begin : 0)};
    for (const GltfPlace& one : all) {
      for (const double value : values_of(one)) {
        const auto number = static_cast<float>(value);
        spool.put(&number, sizeof number);
      }
    }
    text += (text.empty() ? "\"" : ",\"") + std::string(name) + "\":" +
            std::to_string(accessors_.add(accessor(place, float_number, all.size(), shape) + "}"));
  };
  const auto list = [](Vec3 v) { return std::array{v.x, v.y, v.z}; };
  put("TRANSLATION", "VEC3", [&](const GltfPlace& p) { return list(p.translation); });
  put("ROTATION", "VEC4", [&](const GltfPlace& p) { return p.rotation; });
  put("SCALE", "VEC3", [&](const GltfPlace& p) { return list(p.scale); });
  if (draco_) add_view(begin, spool.bytes() - begin, "");
  return "\"attributes\":{" + text + "}";
}

// ---- the end

void GltfBuffers::add_view(uint64_t offset, uint64_t bytes, std::string_view rest) {
  views_.add("{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) +
             ",\"byteLength\":" + std::to_string(bytes) + std::string(rest) + "}");
}

GltfList& GltfBuffers::finish_views(std::span<const std::pair<uint64_t, uint64_t>> pictures) {
  constexpr std::string_view vectors = ",\"byteStride\":12,\"target\":34962";  // ARRAY_BUFFER
  constexpr std::array<std::string_view, 6> rests{vectors,
                                                  vectors,
                                                  ",\"target\":34963",
                                                  ",\"byteStride\":8,\"target\":34962",
                                                  ",\"byteStride\":16,\"target\":34962",
                                                  ""};
  uint64_t at = compressed_.bytes();
  for (const Kind kind : order_) {
    add_view(at, kinds_[kind].bytes(), rests[kind]);
    at += kinds_[kind].bytes();
  }
  for (const auto& [offset, bytes] : pictures) add_view(at + offset, bytes, "");
  return views_;
}

uint64_t GltfBuffers::bytes() const {
  uint64_t sum = compressed_.bytes() + pictures_.bytes();
  for (const Spool& spool : kinds_) sum += spool.bytes();
  return sum;
}

void GltfBuffers::copy_to(OutputFile& out) {
  compressed_.copy_to(out);
  for (const Kind kind : order_) kinds_[kind].copy_to(out);
  pictures_.copy_to(out);
}

}  // namespace mansard
