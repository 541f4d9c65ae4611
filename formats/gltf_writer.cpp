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
#include <utility>
#include <vector>

#include "formats/gltf_buffers.hpp"
#include "formats/gltf_looks.hpp"
#include "formats/gltf_placed.hpp"
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

constexpr uint32_t none = 0xffffffff;

/// As text for the document; bytes that are no UTF-8 are replaced.
std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// To the numbers of a list.
void append(std::string& numbers, uint64_t number) {
  if (!numbers.empty()) numbers += ',';
  numbers += std::to_string(number);
}

/// Where a shared mesh stands.
struct Places {
  uint64_t mesh = 0;
  std::vector<GltfPlace> all;
};

class GltfWriter final : public SurfaceWriter {
 public:
  GltfWriter(const std::string& path, const std::string& comment, const GltfOptions& options);
  std::unique_ptr<SurfacePiece> new_piece() override;
  void write(const NamedSurface& building, std::span<const std::string_view> symbols,
             std::span<const Look> looks);
  std::size_t finish(std::span<const Look> looks) override;

 private:
  void find_symbols();
  void add_polygons(uint32_t begin, uint32_t end);
  std::string placed_nodes();
  std::string placed_node(std::span<const GltfPlace> places, uint64_t mesh);
  uint64_t shared_mesh(std::size_t number);
  void begin_primitive(uint32_t look, bool uvs);
  void end_symbol();
  uint64_t add_mesh(const std::string& primitives);
  void end_primitive();
  void write_document(const std::string& head, GltfList& views, uint64_t bytes);
  void write_header(uint64_t document, uint64_t bytes);

  std::string path_, comment_;
  GltfOptions options_;
  bool binary_;             ///< .glb
  bool instanced_ = false;  ///< something was
  OutputFile out_;
  GltfBuffers buffers_;
  GltfList nodes_, meshes_, roots_;
  GltfLooks looks_;
  ObjGroups groups_;
  GltfShared shared_;
  GltfPrimitive primitive_;
  // ---- of the building that is being written
  const Surface* surface_ = nullptr;
  std::span<const Look> all_looks_;
  Vec3 origin_;
  std::vector<uint32_t> placed_symbols_;  ///< of each placed mesh; none: it is not shared
  std::vector<Places> places_;            ///< of a symbol
  uint32_t symbol_ = none, look_ = 0;
  std::string symbol_name_, primitives_, children_;
};

/// Written in order, as a whole.
class GltfPiece final : public SurfacePiece {
 public:
  explicit GltfPiece(GltfWriter& writer) : writer_(writer) {}
  void prepare(const NamedSurface& building) override { building_ = building; }
  void number(std::span<const std::string_view> symbols, std::span<const Look> looks) override {
    writer_.write(building_, symbols, looks);
  }
  void format() override {}
  void append() override {}

 private:
  GltfWriter& writer_;
  NamedSurface building_;
};

std::unique_ptr<SurfacePiece> GltfWriter::new_piece() { return std::make_unique<GltfPiece>(*this); }

GltfWriter::GltfWriter(const std::string& path, const std::string& comment,
                       const GltfOptions& options)
    : path_(path),
      comment_(comment),
      options_(options),
      binary_(path.ends_with(".glb")),
      out_(path),
      buffers_(path, options.draco),
      nodes_(path),
      meshes_(path),
      roots_(path),
      shared_(options.instancing) {}

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

void GltfWriter::write(const NamedSurface& building, std::span<const std::string_view> symbols,
                       std::span<const Look> looks) {
  surface_ = building.surface;
  all_looks_ = looks;
  if (surface_->polygons() == 0) return;
  origin_ = origin_of(*surface_);
  const bool uvs = surface_->uvs.size() == surface_->points.size();
  children_.clear();
  symbol_ = none;
  shared_.find(*surface_);
  find_symbols();
  groups_.sort(surface_->runs);
  groups_.for_each(
      [&](uint32_t symbol) {
        end_symbol();
        symbol_ = symbol;
        symbol_name_ = text_of(Json(symbols[symbol]));
      },
      [&](uint32_t look) { begin_primitive(look, uvs); },
      [&](uint32_t run) {
        add_polygons(run == 0 ? 0 : surface_->runs[run - 1].end, surface_->runs[run].end);
      });
  end_symbol();
  if (children_.empty()) return;
  Json node{{"name", building.id}};
  if (origin_ != Vec3{}) node["translation"] = {origin_.x, origin_.y, origin_.z};
  node["extras"] = {{"id", building.id}};
  if (!building.style.empty()) node["extras"]["style"] = building.style;
  if (!building.properties.empty())
    node["extras"]["attributes"] = attributes_of(building.properties);
  std::string text = text_of(node);
  text.insert(text.size() - 1, ",\"children\":[" + children_ + "]");
  roots_.add(std::to_string(nodes_.add(text)));
}

void GltfWriter::find_symbols() {
  placed_symbols_.clear();
  auto run = surface_->runs.begin();
  for (const Surface::Placed& placed : surface_->placed) {
    while (run->end <= placed.begin) ++run;
    placed_symbols_.push_back(shared_.is_shared(placed_symbols_.size()) ? run->symbol : none);
  }
}

/// But those of shared meshes.
void GltfWriter::add_polygons(uint32_t begin, uint32_t end) {
  const auto& placed = surface_->placed;
  auto next = std::ranges::upper_bound(placed, begin, {}, &Surface::Placed::end);
  for (uint32_t i = begin; i < end;) {
    while (next != placed.end() &&
           (next->end <= i || placed_symbols_[std::size_t(next - placed.begin())] == none))
      ++next;
    if (next != placed.end() && next->begin <= i) {
      i = next->end;
    } else {
      primitive_.add(*surface_, i++, origin_);
    }
  }
}

void GltfWriter::end_symbol() {
  if (symbol_ == none) return;
  end_primitive();
  const std::string own = std::exchange(primitives_, {});
  const std::string placed = placed_nodes();
  if (own.empty() && placed.empty()) return;
  std::string node = "{\"name\":" + symbol_name_;
  if (!own.empty()) node += ",\"mesh\":" + std::to_string(add_mesh(own));
  if (!placed.empty()) node += ",\"children\":[" + placed + "]";
  append(children_, nodes_.add(node + ",\"extras\":{\"symbol\":" + symbol_name_ + "}}"));
}

uint64_t GltfWriter::add_mesh(const std::string& primitives) {
  return meshes_.add("{\"name\":" + symbol_name_ + ",\"primitives\":[" + primitives + "]}");
}

void append(std::string& text, std::span<const double> values) {
  for (const double value : values) {
    char digits[number_length];
    text.append(digits, put_number(digits, value));
    text += ',';
  }
  text.back() = ']';
}

/// Numbers of the nodes that place the symbol's shared meshes.
std::string GltfWriter::placed_nodes() {
  places_.clear();
  for (std::size_t i = 0; i < placed_symbols_.size(); ++i) {
    if (placed_symbols_[i] != symbol_) continue;
    const uint64_t mesh = shared_mesh(i);
    const GltfPlace place = place_of(surface_->placed[i], origin_);
    const auto known = options_.instancing == Instancing::gpu
                           ? std::ranges::find(places_, mesh, &Places::mesh)
                           : places_.end();
    if (known == places_.end()) {
      places_.push_back({mesh, {place}});
    } else {
      known->all.push_back(place);
    }
  }
  std::string numbers;
  for (const auto& [mesh, places] : places_) append(numbers, nodes_.add(placed_node(places, mesh)));
  return numbers;
}

std::string GltfWriter::placed_node(std::span<const GltfPlace> places, uint64_t mesh) {
  std::string node = "{\"name\":" + symbol_name_ + ",\"mesh\":" + std::to_string(mesh);
  if (places.size() > 1) {
    instanced_ = true;
    node += ",\"extensions\":{\"EXT_mesh_gpu_instancing\":{" + buffers_.add(places) + "}}";
  } else {
    const auto& [t, rotation, s] = places.front();
    node += ",\"translation\":[";
    append(node, std::array{t.x, t.y, t.z});
    node += ",\"rotation\":[";
    append(node, rotation);
    node += ",\"scale\":[";
    append(node, std::array{s.x, s.y, s.z});
  }
  return node + ",\"extras\":{\"symbol\":" + symbol_name_ + "}}";
}

/// Written when it first comes.
uint64_t GltfWriter::shared_mesh(std::size_t number) {
  if (const auto known = shared_.mesh(number)) return *known;
  const Surface own = own_frame(*surface_, surface_->placed[number]);
  uint32_t polygon = 0;
  for (const Surface::Run& run : own.runs) {
    begin_primitive(run.material, true);
    for (; polygon < run.end; ++polygon) primitive_.add(own, polygon, {});
  }
  end_primitive();
  const uint64_t mesh = add_mesh(std::exchange(primitives_, {}));
  shared_.set_mesh(number, mesh);
  return mesh;
}

void GltfWriter::begin_primitive(uint32_t look, bool uvs) {
  end_primitive();
  look_ = look;
  const Look& seen = all_looks_[look];
  primitive_.clear(uvs && seen.has_pictures(), !seen.finish.normal_map.empty());
}

void GltfWriter::end_primitive() {
  if (primitive_.empty()) return;
  const std::string members = buffers_.add(primitive_);
  if (!primitives_.empty()) primitives_ += ",";
  primitives_ += "{" + members + ",\"material\":" + std::to_string(looks_.material_of(look_)) + "}";
  primitive_.clear(false);
}

// ---- the end

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
  for (const auto& [used, name] :
       {std::pair{instanced_, "EXT_mesh_gpu_instancing"},
        {options_.draco && !meshes_.empty(), "KHR_draco_mesh_compression"}}) {
    if (!used) continue;  // without them nothing is where it belongs
    document["extensionsUsed"].push_back(name);
    document["extensionsRequired"].push_back(name);
  }
  const std::string materials =
      looks_.members(looks, path_, binary_ ? &buffers_.pictures() : nullptr, buffers_.view_count());
  GltfList& views = buffers_.finish_views(looks_.views());
  const uint64_t bytes = buffers_.bytes();
  const std::string bin = safe_name(fs::path(path_).stem().string()) + ".bin";
  if (bytes > 0) {
    document["buffers"] = {{{"byteLength", bytes}}};
    if (!binary_) document["buffers"][0]["uri"] = as_uri(bin);
  }
  std::size_t beside = 0;
  if (!binary_ && bytes > 0) {  // what appears last finds the rest beside it
    OutputFile out((fs::path(path_).parent_path() / bin).string());
    buffers_.copy_to(out);
    out.commit();
    beside = out.bytes();
  }
  const std::string head = text_of(document);
  write_document(head.substr(0, head.size() - 1) + materials, views, bytes);
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
void GltfWriter::write_document(const std::string& head, GltfList& views, uint64_t bytes) {
  const std::string scene =
      roots_.empty() ? ",\"scene\":0,\"scenes\":[{}]" : ",\"scene\":0,\"scenes\":[{\"nodes\":[";
  const std::array<std::pair<std::string_view, GltfList*>, 4> lists{
      {{"]}],\"nodes\":[", &nodes_},
       {"],\"meshes\":[", &meshes_},
       {"],\"accessors\":[", &buffers_.accessors()},
       {"],\"bufferViews\":[", &views}}};
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
  buffers_.copy_to(out_);
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

}  // namespace

std::unique_ptr<SurfaceWriter> write_gltf(const std::string& path, const std::string& comment,
                                          const GltfOptions& options) {
  return std::make_unique<GltfWriter>(path, comment, options);
}

}  // namespace mansard
