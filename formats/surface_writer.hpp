// Finished buildings in, one model file out, building by building.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "geometry/mesh.hpp"

namespace mansard {

/// How a surface looks. Colours are sRGB 0..1.
struct Look {
  std::string name;  ///< unique, fit for a material name
  Vec3 color{0.8, 0.8, 0.8};
  double opacity = 1;
  std::string texture;  ///< path of an existing picture, empty for none
};

struct NamedSurface {
  std::string_view id;  ///< of the building
  const Surface* surface = nullptr;
};

enum class Up : uint8_t { y, z };

/// Writes beside `path` and renames at finish(); a writer that is destroyed before leaves nothing
/// behind and what was there intact. Throws Failure for a full disk or a folder that is not there.
class SurfaceWriter {
 public:
  virtual ~SurfaceWriter() = default;
  /// Symbols and looks are numbered as in Surface::Run; both lists may grow between calls.
  virtual void add(const NamedSurface& building, std::span<const std::string_view> symbols,
                   std::span<const Look> looks) = 0;
  /// Returns the number of bytes written.
  virtual std::size_t finish(std::span<const Look> looks) = 0;
};

/// OBJ with MTL and textures beside it: an object a building, a group a symbol, polygons kept.
/// `comment` stands in the head of the file (origin, seed, style).
std::unique_ptr<SurfaceWriter> write_obj(const std::string& path, Up up,
                                         const std::string& comment);

}  // namespace mansard
