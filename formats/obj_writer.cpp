// Wavefront OBJ: each building's arrays once through a large buffer, no streams, and, once the
// tables have grown, no call to the heap but for the building's name.
#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

#include "formats/mtl_writer.hpp"
#include "formats/numbers.hpp"
#include "formats/obj_groups.hpp"
#include "formats/obj_names.hpp"
#include "formats/output_file.hpp"
#include "formats/surface_writer.hpp"

namespace mansard {
namespace {

namespace fs = std::filesystem;

/// Numbers the normals of one building, equal ones once. A small table without chains: a normal
/// that was pushed out is written again, which costs bytes only.
class Normals {
 public:
  void clear() { ++age_; }

  /// The number given to `n` before; otherwise `fresh`, which is remembered.
  uint64_t find_or_add(const Vec3& n, uint64_t fresh) {
    Slot& slot = slots_[hash(n) % slots_.size()];
    if (slot.age != age_ || slot.normal != n) slot = {n, fresh, age_};
    return slot.number;
  }

 private:
  struct Slot {
    Vec3 normal;
    uint64_t number = 0, age = 0;
  };
  static uint64_t hash(const Vec3& n) {
    // + 0.0 makes -0 the same as 0.
    const uint64_t h = std::bit_cast<uint64_t>(n.x + 0.0) * 0x9e3779b97f4a7c15 +
                       std::bit_cast<uint64_t>(n.y + 0.0) * 0xc2b2ae3d27d4eb4f +
                       std::bit_cast<uint64_t>(n.z + 0.0) * 0x165667b19e3779f9;
    return h >> 48;
  }
  std::array<Slot, 512> slots_;
  uint64_t age_ = 1;
};

class ObjWriter final : public SurfaceWriter {
 public:
  ObjWriter(const std::string& path, Up up, const std::string& comment);
  void add(const NamedSurface& building, std::span<const std::string_view> symbols,
           std::span<const Look> looks) override;
  std::size_t finish(std::span<const Look> looks) override;

 private:
  std::string free_name(std::string_view id);
  void put_comment(std::string_view comment);
  void put_name(std::string_view key, std::string_view name);
  void put_points(std::span<const Vec3> points);
  void put_uvs(std::span<const Vec2> uvs);
  void put_normals(std::span<const Vec3> normals);
  void put_vector(char* to, Vec3 v);
  void put_polygon(const Surface& surface, uint32_t polygon, bool with_uvs);

  OutputFile out_;
  std::string mtl_;
  Up up_;
  std::unordered_map<std::string, uint64_t> object_names_;  ///< and the last number they got
  ObjGroups groups_;
  Normals normals_;
  std::vector<uint64_t> normal_numbers_;  ///< of the building's polygons
  bool stained_ = false;
  uint64_t point_count_ = 0, uv_count_ = 0, normal_count_ = 0;  ///< written before this building
};

std::string mtl_path(const std::string& obj) {
  const fs::path path(obj);
  return (path.parent_path() / (safe_name(path.stem().string()) + ".mtl")).string();
}

ObjWriter::ObjWriter(const std::string& path, Up up, const std::string& comment)
    : out_(path), mtl_(mtl_path(path)), up_(up) {
  put_comment(comment);
  if (out_.is_regular()) put_name("mtllib ", fs::path(mtl_).filename().string());
}

void ObjWriter::add(const NamedSurface& building, std::span<const std::string_view> symbols,
                    std::span<const Look> looks) {
  const Surface& surface = *building.surface;
  if (surface.polygons() == 0) return;
  const bool with_uvs = surface.uvs.size() == surface.points.size();
  put_name("o ", free_name(building.id));
  put_points(surface.points);
  if (with_uvs) put_uvs(surface.uvs);
  put_normals(surface.normals);

  stained_ = stained_ || std::ranges::any_of(surface.runs, [&](const Surface::Run& run) {
               return looks[run.material].stains;
             });
  groups_.sort(surface.runs);
  groups_.for_each([&](uint32_t symbol) { put_name("g ", symbols[symbol]); },
                   [&](uint32_t look) { put_name("usemtl ", looks[look].name); },
                   [&](uint32_t run) {
                     uint32_t polygon = run == 0 ? 0 : surface.runs[run - 1].end;
                     for (; polygon < surface.runs[run].end; ++polygon) {
                       put_polygon(surface, polygon, with_uvs);
                     }
                   });
  point_count_ += surface.points.size();
  if (with_uvs) uv_count_ += surface.uvs.size();
}

std::size_t ObjWriter::finish(std::span<const Look> looks) {
  std::vector<Look> listed(looks.begin(), looks.end());
  if (!stained_) std::erase_if(listed, [](const Look& look) { return look.stains; });
  // The OBJ appears last: whoever sees it finds the rest beside it.
  const std::size_t mtl_bytes = out_.is_regular() ? write_mtl(mtl_, listed) : 0;
  out_.commit();
  return out_.bytes() + mtl_bytes;
}

/// Objects that would bear one name are numbered, so that every building is found again.
std::string ObjWriter::free_name(std::string_view id) {
  const std::string name = safe_name(id);
  std::string free = name;
  uint64_t& last = object_names_[name];  // a reference survives the table's growth
  while (last > 0 && !object_names_.try_emplace(free, 1).second) {
    free = name + "_" + std::to_string(++last);
  }
  last = std::max<uint64_t>(last, 1);
  return free;
}

void ObjWriter::put_comment(std::string_view comment) {
  while (!comment.empty()) {
    const std::size_t end = comment.find('\n');
    out_.put("# ");
    out_.put(comment.substr(0, end));
    out_.put("\n");
    comment.remove_prefix(end == comment.npos ? comment.size() : end + 1);
  }
}

void ObjWriter::put_name(std::string_view key, std::string_view name) {
  if (name.empty()) name = "_";
  out_.put(key);
  while (!name.empty()) {
    const std::string_view part = name.substr(0, OutputFile::block - 1);
    char* to = out_.room(OutputFile::block);
    for (char c : part) *to++ = safe_letter(c);
    out_.advance(to);
    name.remove_prefix(part.size());
  }
  out_.put("\n");
}

void ObjWriter::put_points(std::span<const Vec3> points) {
  for (const Vec3& p : points) {
    char* to = out_.room(4 * number_length);
    *to++ = 'v';
    put_vector(to, p);
  }
}

void ObjWriter::put_uvs(std::span<const Vec2> uvs) {
  for (const Vec2& uv : uvs) {
    char* to = out_.room(4 * number_length);
    *to++ = 'v';
    *to++ = 't';
    *to++ = ' ';
    to = put_number(to, uv.x);
    *to++ = ' ';
    to = put_number(to, uv.y);
    *to++ = '\n';
    out_.advance(to);
  }
}

void ObjWriter::put_normals(std::span<const Vec3> normals) {
  normals_.clear();
  normal_numbers_.clear();
  for (const Vec3& n : normals) {
    const uint64_t number = normals_.find_or_add(n, normal_count_ + 1);
    normal_numbers_.push_back(number);
    if (number <= normal_count_) continue;
    ++normal_count_;
    char* to = out_.room(4 * number_length);
    *to++ = 'v';
    *to++ = 'n';
    put_vector(to, n);
  }
}

void ObjWriter::put_vector(char* to, Vec3 v) {
  if (up_ == Up::z) v = {v.x, -v.z, v.y};
  *to++ = ' ';
  to = put_number(to, v.x);
  *to++ = ' ';
  to = put_number(to, v.y);
  *to++ = ' ';
  to = put_number(to, v.z);
  *to++ = '\n';
  out_.advance(to);
}

void ObjWriter::put_polygon(const Surface& surface, uint32_t polygon, bool with_uvs) {
  out_.put("f");
  for (uint32_t i = surface.begin(polygon); i < surface.ends[polygon]; ++i) {
    char* to = out_.room(4 * number_length);
    *to++ = ' ';
    to = put_integer(to, point_count_ + i + 1);
    *to++ = '/';
    if (with_uvs) to = put_integer(to, uv_count_ + i + 1);
    *to++ = '/';
    to = put_integer(to, normal_numbers_[polygon]);
    out_.advance(to);
  }
  out_.put("\n");
}

}  // namespace

std::unique_ptr<SurfaceWriter> write_obj(const std::string& path, Up up,
                                         const std::string& comment) {
  return std::make_unique<ObjWriter>(path, up, comment);
}

}  // namespace mansard
