// PLY and STL by Assimp, which takes a model as a whole: all of it is in memory until the end.
#include <vector>

#include "formats/assimp_export.hpp"
#include "formats/gltf_primitive.hpp"
#include "formats/module.hpp"
#include "formats/output_file.hpp"
#include "formats/surface_writer.hpp"
#include "grammar/diagnostic.hpp"

namespace mansard {
namespace {

class TrianglesWriter final : public SurfaceWriter {
 public:
  TrianglesWriter(const std::string& path, Up up, std::size_t most)
      : path_(path), out_(path), up_(up), most_(most) {}
  void add(const NamedSurface& building, std::span<const std::string_view> symbols,
           std::span<const Look> looks) override;
  std::size_t finish(std::span<const Look> looks) override;

 private:
  void append(std::vector<float>& to, std::span<const float> vectors) const;
  [[noreturn]] void fail(std::string text, std::string help) const;

  std::string path_;
  OutputFile out_;
  Up up_;
  std::size_t most_;
  GltfPrimitive building_;
  std::vector<float> positions_, normals_;
  std::vector<uint32_t> indices_;
};

/// Without stains: these are seen only by how opaque their picture is, and here would be walls.
void TrianglesWriter::add(const NamedSurface& building, std::span<const std::string_view>,
                          std::span<const Look> looks) {
  const Surface& surface = *building.surface;
  building_.clear(false);
  std::size_t polygon = 0;
  for (const Surface::Run& run : surface.runs) {
    for (; polygon < run.end; ++polygon) {
      if (!looks[run.material].stains) building_.add(surface, polygon, {});
    }
  }
  if ((indices_.size() + building_.indices().size()) / 3 > most_) {
    const std::string ending = path_.substr(path_.rfind('.'));
    fail("the model has more than " + std::to_string(most_) + " triangles, the most that a " +
             ending + " is written with: '" + path_ + "'",
         "write an .obj or a .glb, which need not fit into memory, or fewer buildings");
  }
  const auto first = static_cast<uint32_t>(positions_.size() / 3);
  append(positions_, building_.positions());
  append(normals_, building_.normals());
  for (const uint32_t i : building_.indices()) indices_.push_back(first + i);
}

void TrianglesWriter::append(std::vector<float>& to, std::span<const float> vectors) const {
  for (std::size_t i = 0; i < vectors.size(); i += 3) {
    const float x = vectors[i], y = vectors[i + 1], z = vectors[i + 2];
    if (up_ == Up::y) {
      to.insert(to.end(), {x, y, z});
    } else {
      to.insert(to.end(), {x, -z, y});
    }
  }
}

std::size_t TrianglesWriter::finish(std::span<const Look>) {
  if (indices_.empty())
    fail("nothing was drawn that '" + path_ + "' could hold", "an .obj or a .glb may be empty");
  std::string problem, bytes;
  const auto write = reinterpret_cast<decltype(&mansard_write_mesh)>(
      module_symbol("mansard_triangles", "mansard_write_mesh", problem));
  const char* const format = path_.ends_with(".ply") ? "plyb" : "stlb";
  if (!write || !write(format, {positions_, normals_, indices_}, bytes, problem))
    fail("can not write '" + path_ + "': " + problem, "");
  out_.put(bytes);
  out_.commit();
  return bytes.size();
}

void TrianglesWriter::fail(std::string text, std::string help) const {
  Diagnostic d;
  d.text = std::move(text);
  d.help = std::move(help);
  throw Failure(std::move(d));
}

}  // namespace

std::unique_ptr<SurfaceWriter> write_triangles(const std::string& path, Up up, std::size_t most) {
  return std::make_unique<TrianglesWriter>(path, up, most);
}

}  // namespace mansard
