// One building on its way into an OBJ.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/free_names.hpp"
#include "formats/obj_groups.hpp"
#include "formats/obj_normals.hpp"
#include "formats/obj_text.hpp"
#include "formats/output_file.hpp"
#include "formats/surface_writer.hpp"

namespace mansard {

/// What all pieces of a file share.
struct ObjShared {
  OutputFile out;        ///< of append()
  FreeNames names{'_'};  ///< of number(): of objects, so that every building is found again
  ObjCounts counts{};    ///< likewise: of the buildings that have their numbers
  bool stained = false;  ///< likewise
};

/// No call to the heap once the memory has grown, but for the building's name.
class ObjPiece final : public SurfacePiece {
 public:
  ObjPiece(ObjShared& shared, Up up) : shared_(shared), look_names_(up), text_(up) {}
  void prepare(const NamedSurface& building) override;
  void number(std::span<const std::string_view> symbols, std::span<const Look> looks) override;
  void format() override;
  void append() override;

 private:
  bool is_large() const;
  void write();
  void write_normals();
  void write_faces(std::size_t begin, std::size_t end);
  void spill();

  ObjShared& shared_;
  NamedSurface building_;
  ObjNormals normals_;
  ObjGroups groups_;
  std::string name_;
  std::span<const std::string_view> symbols_;
  ObjText look_names_;                  ///< a line each group
  std::vector<std::size_t> look_ends_;  ///< of these lines
  ObjCounts before_;
  ObjText text_;
};

}  // namespace mansard
