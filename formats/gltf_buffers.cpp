#include "formats/gltf_buffers.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include "formats/numbers.hpp"

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

std::string bounds_of(const GltfPart& part) {
  return ",\"min\":" + list_of(part.low) + ",\"max\":" + list_of(part.high);
}

int index_type(const GltfPart& part) {
  return part.short_indices() ? unsigned_short : unsigned_int;
}

}  // namespace

GltfBuffers::GltfBuffers(const std::string& model, bool draco)
    : draco_(draco),
      kinds_{Spool(model), Spool(model), Spool(model), Spool(model), Spool(model), Spool(model)},
      compressed_(model),
      pictures_(model),
      views_(model),
      accessors_(model) {}

std::string GltfBuffers::add(const GltfPart& part, std::string_view bytes) {
  if (draco_) return add_draco(part, bytes);
  const auto vectors = [&](Kind kind, uint32_t width) {
    const std::string_view all = bytes.substr(0, part.vertices * width * sizeof(float));
    bytes.remove_prefix(all.size());
    return std::to_string(add_vectors(kind, all, width, part));
  };
  const std::string normal = vectors(normals, 3), position = vectors(points, 3);
  std::string text = "\"attributes\":{\"POSITION\":" + position + ",\"NORMAL\":" + normal;
  if (part.uvs) text += ",\"TEXCOORD_0\":" + vectors(uvs, 2);
  if (part.tangents) text += ",\"TANGENT\":" + vectors(tangents, 4);
  return text + "},\"indices\":" + std::to_string(add_indices(part, bytes));
}

std::size_t GltfBuffers::view_of(Kind kind) {
  const auto at = std::ranges::find(order_, kind);
  const auto number = static_cast<std::size_t>(at - order_.begin());
  if (at == order_.end()) order_.push_back(kind);
  return number;
}

uint64_t GltfBuffers::add_vectors(Kind kind, std::string_view bytes, uint32_t width,
                                  const GltfPart& part) {
  Spool& spool = kinds_[kind];
  std::string text = accessor(Place{view_of(kind), spool.bytes()}, float_number, part.vertices,
                              "VEC" + std::to_string(width));
  if (kind == points) text += bounds_of(part);
  spool.put(bytes);
  return accessors_.add(text + "}");
}

uint64_t GltfBuffers::add_indices(const GltfPart& part, std::string_view bytes) {
  Spool& spool = kinds_[indices];
  const std::string text =
      accessor(Place{view_of(indices), spool.bytes()}, index_type(part), part.corners, "SCALAR");
  spool.put(bytes);
  return accessors_.add(text + "}");
}

/// The accessors say what the decoder will give and have no view.
std::string GltfBuffers::add_draco(const GltfPart& part, std::string_view bytes) {
  constexpr std::array<std::string_view, 4> names{"POSITION", "NORMAL", "TEXCOORD_0", "TANGENT"};
  constexpr std::array<std::string_view, 4> shapes{"VEC3", "VEC3", "VEC2", "VEC4"};
  const std::size_t given = !part.uvs ? 2 : !part.tangents ? 3 : 4;
  std::string accessor_numbers, draco_numbers;
  for (std::size_t i = 0; i < given; ++i) {
    std::string text = accessor({}, float_number, part.vertices, shapes[i]);
    if (i == 0) text += bounds_of(part);
    const std::string key = (i == 0 ? "\"" : ",\"") + std::string(names[i]) + "\":";
    accessor_numbers += key + std::to_string(accessors_.add(text + "}"));
    draco_numbers += key + std::to_string(i);
  }
  const uint64_t index_accessor =
      accessors_.add(accessor({}, index_type(part), part.corners, "SCALAR") + "}");
  add_view(compressed_.bytes(), bytes.size(), "");
  compressed_.put(bytes);
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
