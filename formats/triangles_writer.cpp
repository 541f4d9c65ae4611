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

/// What all buildings come to.
struct Triangles {
  std::vector<float> positions, normals;
  std::vector<uint32_t> indices;
};

[[noreturn]] void fail(std::string text, std::string help) {
  Diagnostic d;
  d.text = std::move(text);
  d.help = std::move(help);
  throw Failure(std::move(d));
}

class TrianglesWriter final : public SurfaceWriter {
 public:
  TrianglesWriter(const std::string& path, Up up, std::size_t most)
      : path_(path), out_(path), up_(up), most_(most) {}
  std::unique_ptr<SurfacePiece> new_piece() override;
  void append(const GltfPrimitive& building);
  std::size_t finish(std::span<const Look> looks) override;

 private:
  void append(std::vector<float>& to, std::span<const float> vectors) const;

  std::string path_;
  OutputFile out_;
  Up up_;
  std::size_t most_;
  Triangles all_;
};

/// Without stains: these are seen only by how opaque their picture is, and here would be walls.
class TrianglesPiece final : public SurfacePiece {
 public:
  explicit TrianglesPiece(TrianglesWriter& writer) : writer_(writer) {}
  void prepare(const NamedSurface& building) override { surface_ = building.surface; }
  void number(std::span<const std::string_view> symbols, std::span<const Look> looks) override;
  void format() override;
  void append() override { writer_.append(triangles_); }

 private:
  TrianglesWriter& writer_;
  const Surface* surface_ = nullptr;
  std::vector<bool> stained_;  ///< by run
  GltfPrimitive triangles_;
};

void TrianglesPiece::number(std::span<const std::string_view>, std::span<const Look> looks) {
  stained_.clear();
  for (const Surface::Run& run : surface_->runs) stained_.push_back(looks[run.material].stains);
}

void TrianglesPiece::format() {
  triangles_.clear(false);
  std::size_t polygon = 0;
  for (std::size_t i = 0; i < stained_.size(); ++i) {
    for (; polygon < surface_->runs[i].end; ++polygon) {
      if (!stained_[i]) triangles_.add(*surface_, polygon, {});
    }
  }
}

std::unique_ptr<SurfacePiece> TrianglesWriter::new_piece() {
  return std::make_unique<TrianglesPiece>(*this);
}

void TrianglesWriter::append(const GltfPrimitive& building) {
  if ((all_.indices.size() + building.indices().size()) / 3 > most_) {
    const std::string ending = path_.substr(path_.rfind('.'));
    fail("the model has more than " + std::to_string(most_) + " triangles, the most that a " +
             ending + " is written with: '" + path_ + "'",
         "write an .obj or a .glb, which need not fit into memory, or fewer buildings");
  }
  const auto first = static_cast<uint32_t>(all_.positions.size() / 3);
  append(all_.positions, building.positions());
  append(all_.normals, building.normals());
  for (const uint32_t i : building.indices()) all_.indices.push_back(first + i);
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
  if (all_.indices.empty())
    fail("nothing was drawn that '" + path_ + "' could hold", "an .obj or a .glb may be empty");
  std::string problem, bytes;
  const auto write = reinterpret_cast<decltype(&mansard_write_mesh)>(
      module_symbol("mansard_triangles", "mansard_write_mesh", problem));
  const char* const format = path_.ends_with(".ply") ? "plyb" : "stlb";
  if (!write || !write(format, {all_.positions, all_.normals, all_.indices}, bytes, problem))
    fail("can not write '" + path_ + "': " + problem, "");
  out_.put(bytes);
  out_.commit();
  return bytes.size();
}

}  // namespace

std::unique_ptr<SurfaceWriter> write_triangles(const std::string& path, Up up, std::size_t most) {
  return std::make_unique<TrianglesWriter>(path, up, most);
}

}  // namespace mansard
