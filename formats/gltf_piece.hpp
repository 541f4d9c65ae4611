// One building on its way into a glTF file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/gltf_buffers.hpp"
#include "formats/gltf_looks.hpp"
#include "formats/gltf_parts.hpp"
#include "formats/gltf_placed.hpp"
#include "formats/gltf_primitive.hpp"
#include "formats/obj_groups.hpp"
#include "formats/stock.hpp"
#include "formats/surface_writer.hpp"

namespace mansard {

/// What all pieces of a file share.
struct GltfFile {
  GltfFile(const std::string& model, const GltfOptions& given)
      : path(model),
        options(given),
        shared(given.instancing),
        buffers(model, given.draco),
        nodes(model),
        meshes(model),
        roots(model) {}

  bool is_binary() const { return path.ends_with(".glb"); }
  uint64_t bytes() const {
    return buffers.bytes() + buffers.accessors().bytes() + nodes.bytes() + meshes.bytes();
  }
  /// Throws Failure where a .glb could not hold so many bytes.
  void check_size(uint64_t bytes) const;

  const std::string path;
  const GltfOptions options;
  GltfShared shared;                ///< of number()
  Stock<GltfPrimitive> primitives;  ///< of format()
  // ---- of append()
  GltfBuffers buffers;
  GltfList nodes, meshes, roots;
  GltfLooks looks;
  bool instanced = false;  ///< something was
};

class GltfPiece final : public SurfacePiece {
 public:
  explicit GltfPiece(GltfFile& file) : file_(file), parts_(file.options.draco) {}
  void prepare(const NamedSurface& building) override;
  void number(std::span<const std::string_view> symbols, std::span<const Look> looks) override;
  void format() override;
  void append() override;

 private:
  static constexpr uint32_t none = 0xffffffff;
  struct SeenLook {
    uint32_t look = 0;
    bool pictures = false, normal_map = false;
  };
  /// A shared mesh that this building brings.
  struct Brought {
    GltfMesh* mesh = nullptr;
    std::size_t parts_end = 0;
  };
  /// Where a shared mesh stands.
  struct Places {
    GltfMesh* mesh = nullptr;
    std::vector<GltfPlace> all;
  };
  /// A symbol's node: first the parts of its own mesh, then those of the meshes that it brings.
  struct Node {
    std::string name;  ///< in quotes
    std::size_t parts_begin = 0, parts_end = 0;
    std::vector<Brought> brought;
    std::vector<Places> places;
  };

  // ---- number()
  void find_placed_symbols();
  void claim_meshes(uint32_t symbol);
  // ---- format()
  void begin_primitive(uint32_t look, bool uvs);
  void end_primitive();
  void add_polygons(uint32_t begin, uint32_t end);
  void end_own_mesh();
  void add_placed(uint32_t symbol);
  void bring_mesh(std::size_t placed);
  void add_place(std::size_t placed);
  // ---- append()
  std::string append_node(const Node& node);
  std::string append_parts(std::size_t begin, std::size_t end);
  uint64_t append_mesh(const Node& node, const std::string& primitives);
  std::string append_places(const Node& node);
  std::string placed_node(const Node& node, const Places& places);

  GltfFile& file_;
  NamedSurface building_;
  Vec3 origin_;
  std::vector<GltfSharable> sharable_;
  ObjGroups groups_;
  std::span<const std::string_view> symbols_;
  std::vector<SeenLook> looks_;
  std::vector<GltfMesh*> meshes_;         ///< by placed number; null: it is not shared
  std::vector<uint32_t> placed_symbols_;  ///< likewise, or none
  std::vector<bool> brings_;              ///< likewise: the building brings the mesh
  GltfPrimitive* primitive_ = nullptr;    ///< while it is formatted
  uint32_t look_ = 0;                     ///< of it
  GltfParts parts_;
  std::vector<Node> nodes_;
  std::string root_;
};

}  // namespace mansard
