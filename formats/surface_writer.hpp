// Finished buildings in, one model file out, building by building.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "geometry/finish.hpp"
#include "geometry/mesh.hpp"
#include "interpreter/footprint.hpp"

namespace mansard {

/// How a surface looks. Colours are sRGB 0..1.
struct Look {
  std::string name;  ///< unique, fit for a material name
  Vec3 color{0.8, 0.8, 0.8};
  double opacity = 1;
  std::string texture;  ///< path of an existing picture that `color` colours, empty for none
  Finish finish = {};
  bool stains = false;  ///< lies before another surface, as opaque as the picture is white

  bool has_pictures() const { return !texture.empty() || finish.has_pictures(); }
};

struct NamedSurface {
  std::string_view id;  ///< of the building
  const Surface* surface = nullptr;
  std::string_view style = {};                ///< for formats that can tell
  std::span<const Property> properties = {};  ///< of the footprint, likewise
};

enum class Up : uint8_t { y, z };

/// How glTF writes what stands in many places: as nodes that share a mesh, as instances of
/// EXT_mesh_gpu_instancing, or like everything else.
enum class Instancing : uint8_t { nodes, gpu, copies };

struct GltfOptions {
  Instancing instancing = Instancing::nodes;
  bool draco = false;          ///< KHR_draco_mesh_compression, to a tenth of a millimetre
  uint64_t most = 0xffffffff;  ///< bytes that a .glb can say it has; more are a Failure at once
};

/// A building's way into the file, in four steps; reused for the next one, so that its memory is.
/// Many are on their way at once. The building must stay as it is until it is appended.
class SurfacePiece {
 public:
  virtual ~SurfacePiece() = default;
  /// On any thread: what takes nothing but the building.
  virtual void prepare(const NamedSurface& building) = 0;
  /// In the order of the file, one building at a time: the names and numbers that follow from what
  /// came before. Symbols and looks are numbered as in Surface::Run. The symbols stay as they are
  /// until all is written; the looks may grow between calls.
  virtual void number(std::span<const std::string_view> symbols, std::span<const Look> looks) = 0;
  /// On any thread: the bytes.
  virtual void format() = 0;
  /// In the order of the file, one building at a time, while others are numbered.
  virtual void append() = 0;
};

/// Writes beside `path` and renames at finish(); a writer that is destroyed before leaves nothing
/// behind and what was there intact. Throws Failure for a full disk or a folder that is not there.
class SurfaceWriter {
 public:
  virtual ~SurfaceWriter() = default;
  /// On any thread. The writer must outlive it.
  virtual std::unique_ptr<SurfacePiece> new_piece() = 0;
  /// All four steps, for who has one building after the other.
  void add(const NamedSurface& building, std::span<const std::string_view> symbols,
           std::span<const Look> looks) {
    if (!piece_) piece_ = new_piece();
    piece_->prepare(building);
    piece_->number(symbols, looks);
    piece_->format();
    piece_->append();
  }
  /// When all are appended. Returns the number of bytes written.
  virtual std::size_t finish(std::span<const Look> looks) = 0;

 private:
  std::unique_ptr<SurfacePiece> piece_;  ///< of add()
};

/// OBJ with MTL and textures beside it: an object a building, a group a symbol, polygons kept; the
/// look of stains only where something is stained.
/// `comment` stands in the head of the file (origin, seed, style).
std::unique_ptr<SurfaceWriter> write_obj(const std::string& path, Up up,
                                         const std::string& comment);

/// glTF 2.0: .glb in one file with its textures, .gltf with a .bin and textures beside it. A node a
/// building, with its id, style and properties as extras; below it a node a symbol, whose mesh has
/// a primitive a look. Metres, y up; looks that are not used are left out.
std::unique_ptr<SurfaceWriter> write_gltf(const std::string& path, const std::string& comment,
                                          const GltfOptions& options = {});

/// Binary PLY or STL by the path's ending: nothing but triangles, with normals; no names, looks or
/// textures, and no stains, which are seen only with theirs. The whole model is in memory until
/// finish(); more than `most` triangles, or none at all, are a Failure.
std::unique_ptr<SurfaceWriter> write_triangles(const std::string& path, Up up,
                                               std::size_t most = 10'000'000);

}  // namespace mansard
