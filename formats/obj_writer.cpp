// Wavefront OBJ: each building's text in memory, one after the other into the file, no streams.
#include <filesystem>
#include <string>
#include <vector>

#include "formats/mtl_writer.hpp"
#include "formats/obj_names.hpp"
#include "formats/obj_piece.hpp"
#include "formats/surface_writer.hpp"

namespace mansard {
namespace {

namespace fs = std::filesystem;

class ObjWriter final : public SurfaceWriter {
 public:
  ObjWriter(const std::string& path, Up up, const std::string& comment);
  std::unique_ptr<SurfacePiece> new_piece() override {
    return std::make_unique<ObjPiece>(shared_, up_);
  }
  std::size_t finish(std::span<const Look> looks) override;

 private:
  ObjShared shared_;
  std::string mtl_;
  Up up_;
};

std::string mtl_path(const std::string& obj) {
  const fs::path path(obj);
  return (path.parent_path() / (safe_name(path.stem().string()) + ".mtl")).string();
}

ObjWriter::ObjWriter(const std::string& path, Up up, const std::string& comment)
    : shared_{.out = OutputFile(path)}, mtl_(mtl_path(path)), up_(up) {
  ObjText head(up);
  head.comment(comment);
  if (shared_.out.is_regular()) head.name("mtllib ", fs::path(mtl_).filename().string());
  shared_.out.put(head.text());
}

std::size_t ObjWriter::finish(std::span<const Look> looks) {
  std::vector<Look> listed(looks.begin(), looks.end());
  if (!shared_.stained) std::erase_if(listed, [](const Look& look) { return look.stains; });
  // The OBJ appears last: whoever sees it finds the rest beside it.
  const std::size_t mtl_bytes = shared_.out.is_regular() ? write_mtl(mtl_, listed) : 0;
  shared_.out.commit();
  return shared_.out.bytes() + mtl_bytes;
}

}  // namespace

std::unique_ptr<SurfaceWriter> write_obj(const std::string& path, Up up,
                                         const std::string& comment) {
  return std::make_unique<ObjWriter>(path, up, comment);
}

}  // namespace mansard
