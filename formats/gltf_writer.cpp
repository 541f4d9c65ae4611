// glTF 2.0 (Khronos, ISO/IEC 12113:2022), building by building: vertices, indices and the growing
// lists of the document go to nameless files and are put together at the end, so that memory is the
// same for any number of buildings.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "formats/gltf_looks.hpp"
#include "formats/gltf_primitive.hpp"
#include "formats/numbers.hpp"
#include "formats/obj_groups.hpp"
#include "formats/obj_names.hpp"
#include "formats/spool.hpp"
#include "formats/surface_writer.hpp"
#include "grammar/diagnostic.hpp"

namespace mansard {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// As text for the document; bytes that are no UTF-8 are replaced.
std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The items of one of the document's lists.
class List {
 public:
  explicit List(const std::string& model) : spool_(model) {}
  /// Returns the item's number.
  uint64_t add(std::string_view item) {
    if (count_ > 0) spool_.put(",");
    spool_.put(item);
    return count_++;
  }
  bool empty() const { return count_ == 0; }
  uint64_t bytes() const { return spool_.bytes(); }
  void copy_to(OutputFile& out) { spool_.copy_to(out); }

 private:
  Spool spool_;
  uint64_t count_ = 0;
};

/// That of texture coordinates comes last: a model without textures has none.
enum : int { points_view, normals_view, indices_view, uvs_view };
enum : int { unsigned_short = 5123, unsigned_int = 5125, float_number = 5126 };

class GltfWriter final : public SurfaceWriter {
 public:
  GltfWriter(const std::string& path, const std::string& comment);
  void add(const NamedSurface& building, std::span<const std::string_view> symbols,
           std::span<const Look> looks) override;
  std::size_t finish(std::span<const Look> looks) override;

 private:
  void begin_symbol(std::string_view symbol);
  void end_symbol();
  void end_primitive();
  uint64_t add_vectors(int view, std::span<const float> values, int width, bool with_bounds);
  uint64_t add_indices();
  uint64_t place_vertices(Json& views);
  void write_document(const std::string& head, uint64_t bytes);
  void write_header(uint64_t document, uint64_t bytes);
  void write_binary(OutputFile& out);

  std::string path_, comment_;
  bool binary_;  ///< .glb
  OutputFile out_;
  std::array<Spool, 4> vertices_;  ///< by view
  Spool pictures_;
  List nodes_, meshes_, accessors_, roots_;
  GltfLooks looks_;
  ObjGroups groups_;
  GltfPrimitive primitive_;
  uint32_t look_ = 0;
  std::string symbol_, primitives_, children_;  ///< of what is being written
};

GltfWriter::GltfWriter(const std::string& path, const std::string& comment)
    : path_(path),
      comment_(comment),
      binary_(path.ends_with(".glb")),
      out_(path),
      vertices_{Spool(path), Spool(path), Spool(path), Spool(path)},
      pictures_(path),
      nodes_(path),
      meshes_(path),
      accessors_(path),
      roots_(path) {}

/// The middle of its base, to the millimetre: vertices are floats, which are precise near 0.
Vec3 origin_of(const Surface& surface) {
  const Box3 box = bounds(surface.points);
  const auto rounded = [](double v) { return std::round(v * 1000) / 1000; };
  return {rounded((box.low.x + box.high.x) / 2), rounded(box.low.y),
          rounded((box.low.z + box.high.z) / 2)};
}

Json attributes_of(std::span<const Property> properties) {
  Json attributes = Json::object();
  for (const Property& p : properties)
    std::visit([&](const auto& value) { attributes[p.name] = value; }, p.value);
  return attributes;
}

void GltfWriter::add(const NamedSurface& building, std::span<const std::string_view> symbols,
                     std::span<const Look> looks) {
  const Surface& surface = *building.surface;
  if (surface.polygons() == 0) return;
  const Vec3 origin = origin_of(surface);
  const bool uvs = surface.uvs.size() == surface.points.size();
  children_.clear();
  groups_.sort(surface.runs);
  groups_.for_each(
      [&](uint32_t symbol) {
        end_symbol();
        begin_symbol(symbols[symbol]);
      },
      [&](uint32_t look) {
        end_primitive();
        look_ = look;
        primitive_.clear(uvs && !looks[look].texture.empty());
      },
      [&](uint32_t run) {
        uint32_t polygon = run == 0 ? 0 : surface.runs[run - 1].end;
        for (; polygon < surface.runs[run].end; ++polygon) primitive_.add(surface, polygon, origin);
      });
  end_symbol();
  if (children_.empty()) return;
  Json node{{"name", building.id}};
  if (origin != Vec3{}) node["translation"] = {origin.x, origin.y, origin.z};
  node["extras"] = {{"id", building.id}};
  if (!building.style.empty()) node["extras"]["style"] = building.style;
  if (!building.properties.empty())
    node["extras"]["attributes"] = attributes_of(building.properties);
  std::string text = text_of(node);
  text.insert(text.size() - 1, ",\"children\":[" + children_ + "]");
  roots_.add(std::to_string(nodes_.add(text)));
}

void GltfWriter::begin_symbol(std::string_view symbol) {
  symbol_ = text_of(Json(symbol));
  primitives_.clear();
}

void GltfWriter::end_symbol() {
  end_primitive();
  if (primitives_.empty()) return;
  const uint64_t mesh =
      meshes_.add("{\"name\":" + symbol_ + ",\"primitives\":[" + primitives_ + "]}");
  const uint64_t node = nodes_.add("{\"name\":" + symbol_ + ",\"mesh\":" + std::to_string(mesh) +
                                   ",\"extras\":{\"symbol\":" + symbol_ + "}}");
  children_ += (children_.empty() ? "" : ",") + std::to_string(node);
  primitives_.clear();
}

void GltfWriter::end_primitive() {
  if (primitive_.empty()) return;
  const std::string points =
      std::to_string(add_vectors(points_view, primitive_.positions(), 3, true));
  const std::string normals =
      std::to_string(add_vectors(normals_view, primitive_.normals(), 3, false));
  std::string attributes = "\"POSITION\":" + points + ",\"NORMAL\":" + normals;
  if (primitive_.has_uvs()) {
    const uint64_t uvs = add_vectors(uvs_view, primitive_.uvs(), 2, false);
    attributes += ",\"TEXCOORD_0\":" + std::to_string(uvs);
  }
  const std::string indices = std::to_string(add_indices());
  const std::string material = std::to_string(looks_.material_of(look_));
  if (!primitives_.empty()) primitives_ += ",";
  primitives_ += "{\"attributes\":{" + attributes + "},\"indices\":" + indices +
                 ",\"material\":" + material + "}";
  primitive_.clear(false);
}

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

std::string accessor(int view, uint64_t offset, int type, uint64_t count, std::string_view shape) {
  return "{\"bufferView\":" + std::to_string(view) + ",\"byteOffset\":" + std::to_string(offset) +
         ",\"componentType\":" + std::to_string(type) + ",\"count\":" + std::to_string(count) +
         ",\"type\":\"" + std::string(shape) + "\"";
}

uint64_t GltfWriter::add_vectors(int view, std::span<const float> values, int width,
                                 bool with_bounds) {
  Spool& spool = vertices_[static_cast<std::size_t>(view)];
  std::string text = accessor(view, spool.bytes(), float_number, values.size() / width,
                              width == 3 ? "VEC3" : "VEC2");
  if (with_bounds)
    text += ",\"min\":" + list_of(primitive_.low()) + ",\"max\":" + list_of(primitive_.high());
  spool.put_all(values);
  return accessors_.add(text + "}");
}

/// As short as the vertices allow; 65535 is no index.
uint64_t GltfWriter::add_indices() {
  Spool& spool = vertices_[indices_view];
  const std::span<const uint32_t> indices = primitive_.indices();
  const bool is_short = primitive_.vertices() <= std::numeric_limits<uint16_t>::max();
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

// ---- the end

/// The views of vertices one after the other. Returns where the pictures begin.
uint64_t GltfWriter::place_vertices(Json& views) {
  uint64_t at = 0;
  for (std::size_t i = 0; i < vertices_.size() && vertices_[i].bytes() > 0; ++i) {
    Json view{{"buffer", 0}, {"byteOffset", at}, {"byteLength", vertices_[i].bytes()}};
    constexpr std::array<int, 4> strides{12, 12, 0, 8};
    if (strides[i] > 0) view["byteStride"] = strides[i];
    view["target"] = strides[i] > 0 ? 34962 : 34963;  // ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER
    views.push_back(std::move(view));
    at += vertices_[i].bytes();
  }
  return at;
}

/// A line of the head's comment each: style, seed, origin.
Json asset(const std::string& comment) {
  Json asset{{"version", "2.0"}, {"generator", "Mansard"}};
  Json lines = Json::array();
  for (std::size_t at = 0; at < comment.size();) {
    const std::size_t end = std::min(comment.find('\n', at), comment.size());
    lines.push_back(comment.substr(at, end - at));
    at = end + 1;
  }
  if (!lines.empty()) asset["extras"]["comment"] = lines;
  return asset;
}

std::size_t GltfWriter::finish(std::span<const Look> looks) {
  Json document{{"asset", asset(comment_)}};
  Json views = Json::array();
  const uint64_t vertex_bytes = place_vertices(views);
  const std::string materials =
      looks_.members(looks, path_, binary_ ? &pictures_ : nullptr, views.size());
  for (const GltfLooks::View& view : looks_.views()) {
    views.push_back(
        {{"buffer", 0}, {"byteOffset", vertex_bytes + view.offset}, {"byteLength", view.bytes}});
  }
  if (!views.empty()) document["bufferViews"] = views;
  const uint64_t bytes = vertex_bytes + pictures_.bytes();
  const std::string bin = safe_name(fs::path(path_).stem().string()) + ".bin";
  if (bytes > 0) {
    document["buffers"] = {{{"byteLength", bytes}}};
    if (!binary_) document["buffers"][0]["uri"] = as_uri(bin);
  }
  std::size_t beside = 0;
  if (!binary_ && bytes > 0) {  // what appears last finds the rest beside it
    OutputFile out((fs::path(path_).parent_path() / bin).string());
    write_binary(out);
    out.commit();
    beside = out.bytes();
  }
  const std::string head = text_of(document);
  write_document(head.substr(0, head.size() - 1) + materials, bytes);
  out_.commit();
  return out_.bytes() + beside;
}

void put_integer(OutputFile& out, uint32_t value) {
  static_assert(std::endian::native == std::endian::little);
  char* const room = out.room(sizeof value);
  std::memcpy(room, &value, sizeof value);
  out.advance(room + sizeof value);
}

/// The document, from its open head on, with the lists in it; in a .glb between its header and the
/// binary chunk.
void GltfWriter::write_document(const std::string& head, uint64_t bytes) {
  const std::string scene =
      roots_.empty() ? ",\"scene\":0,\"scenes\":[{}]" : ",\"scene\":0,\"scenes\":[{\"nodes\":[";
  const std::array<std::pair<std::string_view, List*>, 3> lists{
      {{"]}],\"nodes\":[", &nodes_},
       {"],\"meshes\":[", &meshes_},
       {"],\"accessors\":[", &accessors_}}};
  uint64_t length = head.size() + scene.size() + 1;
  if (!roots_.empty()) {
    length += roots_.bytes() + 1;
    for (const auto& [key, list] : lists) length += key.size() + list->bytes();
  }
  const uint64_t padding = binary_ ? (4 - length % 4) % 4 : 0;
  if (binary_) write_header(length + padding, bytes);
  out_.put(head);
  out_.put(scene);
  if (!roots_.empty()) {
    roots_.copy_to(out_);
    for (const auto& [key, list] : lists) {
      out_.put(key);
      list->copy_to(out_);
    }
    out_.put("]");
  }
  out_.put("}");
  out_.put(std::string_view("   ").substr(0, padding));
  if (!binary_ || bytes == 0) return;
  put_integer(out_, static_cast<uint32_t>(bytes));
  put_integer(out_, 0x004e4942);  // BIN
  write_binary(out_);
}

void GltfWriter::write_header(uint64_t document, uint64_t bytes) {
  const uint64_t whole = 12 + 8 + document + (bytes > 0 ? 8 + bytes : 0);
  if (whole > std::numeric_limits<uint32_t>::max()) {
    Diagnostic d;
    d.text = "the model has " + std::to_string(whole / 1'000'000'000) +
             " GB, and a .glb holds at most 4: '" + path_ + "'";
    d.help = "write a .gltf, or fewer buildings into one file";
    throw Failure(std::move(d));
  }
  put_integer(out_, 0x46546c67);  // glTF
  put_integer(out_, 2);
  put_integer(out_, static_cast<uint32_t>(whole));
  put_integer(out_, static_cast<uint32_t>(document));
  put_integer(out_, 0x4e4f534a);  // JSON
}

void GltfWriter::write_binary(OutputFile& out) {
  for (Spool& spool : vertices_) spool.copy_to(out);
  pictures_.copy_to(out);
}

}  // namespace

std::unique_ptr<SurfaceWriter> write_gltf(const std::string& path, const std::string& comment) {
  return std::make_unique<GltfWriter>(path, comment);
}

}  // namespace mansard
