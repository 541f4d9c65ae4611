// glTF 2.0 (Khronos, ISO/IEC 12113:2022), building by building: vertices, indices and the growing
// lists of the document go to nameless files and are put together at the end, so that memory is the
// same for any number of buildings.
#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <utility>

#include "formats/gltf_json.hpp"
#include "formats/gltf_piece.hpp"
#include "formats/obj_names.hpp"
#include "formats/output_file.hpp"
#include "formats/surface_writer.hpp"

namespace mansard {
namespace {

namespace fs = std::filesystem;

class GltfWriter final : public SurfaceWriter {
 public:
  GltfWriter(const std::string& path, const std::string& comment, const GltfOptions& options)
      : comment_(comment), out_(path), file_(path, options) {}
  std::unique_ptr<SurfacePiece> new_piece() override { return std::make_unique<GltfPiece>(file_); }
  std::size_t finish(std::span<const Look> looks) override;

 private:
  void write_document(const std::string& head, GltfList& views, uint64_t bytes);
  void write_header(uint64_t document, uint64_t bytes);

  std::string comment_;
  OutputFile out_;
  GltfFile file_;
};

std::size_t GltfWriter::finish(std::span<const Look> looks) {
  const std::string materials = file_.looks.members(
      looks, file_.path, file_.is_binary() ? &file_.buffers.pictures() : nullptr,
      file_.buffers.view_count());
  GltfList& views = file_.buffers.finish_views(file_.looks.views());
  const std::string bin = safe_name(fs::path(file_.path).stem().string()) + ".bin";
  GltfHead head{comment_, {}, file_.buffers.bytes(), file_.is_binary() ? "" : as_uri(bin)};
  if (file_.instanced) head.extensions.emplace_back("EXT_mesh_gpu_instancing");
  if (file_.options.draco && !file_.meshes.empty())
    head.extensions.emplace_back("KHR_draco_mesh_compression");
  std::size_t beside = 0;
  if (!file_.is_binary() && head.bytes > 0) {  // what appears last finds the rest beside it
    OutputFile out((fs::path(file_.path).parent_path() / bin).string());
    file_.buffers.copy_to(out);
    out.commit();
    beside = out.bytes();
  }
  write_document(json_text(head) + materials, views, head.bytes);
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
  const std::string scene = file_.roots.empty() ? ",\"scene\":0,\"scenes\":[{}]"
                                                : ",\"scene\":0,\"scenes\":[{\"nodes\":[";
  const std::array<std::pair<std::string_view, GltfList*>, 4> lists{
      {{"]}],\"nodes\":[", &file_.nodes},
       {"],\"meshes\":[", &file_.meshes},
       {"],\"accessors\":[", &file_.buffers.accessors()},
       {"],\"bufferViews\":[", &views}}};
  uint64_t length = head.size() + scene.size() + 1;
  if (!file_.roots.empty()) {
    length += file_.roots.bytes() + 1;
    for (const auto& [key, list] : lists) length += key.size() + list->bytes();
  }
  const uint64_t padding = file_.is_binary() ? (4 - length % 4) % 4 : 0;
  if (file_.is_binary()) write_header(length + padding, bytes);
  out_.put(head);
  out_.put(scene);
  if (!file_.roots.empty()) {
    file_.roots.copy_to(out_);
    for (const auto& [key, list] : lists) {
      out_.put(key);
      list->copy_to(out_);
    }
    out_.put("]");
  }
  out_.put("}");
  out_.put(std::string_view("   ").substr(0, padding));
  if (!file_.is_binary() || bytes == 0) return;
  put_integer(out_, static_cast<uint32_t>(bytes));
  put_integer(out_, 0x004e4942);  // BIN
  file_.buffers.copy_to(out_);
}

void GltfWriter::write_header(uint64_t document, uint64_t bytes) {
  const uint64_t whole = 12 + 8 + document + (bytes > 0 ? 8 + bytes : 0);
  file_.check_size(whole);
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
