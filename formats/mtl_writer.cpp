#include "formats/mtl_writer.hpp"

#include "formats/copied_pictures.hpp"
#include "formats/numbers.hpp"
#include "formats/obj_names.hpp"
#include "formats/output_file.hpp"

namespace mansard {
namespace {

void put_line(OutputFile& out, std::string_view key, std::initializer_list<double> values) {
  out.put(key);
  for (double value : values) {
    char* to = out.room(number_length + 1);
    *to++ = ' ';
    out.advance(put_number(to, value));
  }
  out.put("\n");
}

}  // namespace

std::size_t write_mtl(const std::string& path, std::span<const Look> looks) {
  CopiedPictures pictures(path);
  OutputFile out(path);
  for (const Look& look : looks) {
    out.put("newmtl ");
    out.put(safe_name(look.name));
    out.put("\n");
    put_line(out, "Kd", {look.color.x, look.color.y, look.color.z});
    put_line(out, "d", {look.opacity});
    if (look.texture.empty()) continue;
    out.put("map_Kd ");
    out.put(pictures.name_of(look.texture));
    out.put("\n");
  }
  out.commit();
  return out.bytes();
}

}  // namespace mansard
