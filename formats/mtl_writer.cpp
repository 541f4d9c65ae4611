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

void put_picture(OutputFile& out, std::string_view key, CopiedPictures& pictures,
                 const std::string& path) {
  if (path.empty()) return;
  out.put(key);
  out.put(" ");
  out.put(pictures.name_of(path));
  out.put("\n");
}

/// As physically based renderers read it (Pr, Pm, norm: the extension of Exocortex) and, for the
/// others, as the highlight of Phong that Blender makes of the same roughness. Nothing for a matt
/// surface, which is what is read when nothing is said.
void put_finish(OutputFile& out, const Look& look, CopiedPictures& pictures) {
  const Finish& finish = look.finish;
  if (finish.roughness < 1 || finish.metallic > 0) {
    const double smooth = 1 - finish.roughness, stone = 0.04, metal = finish.metallic;
    put_line(out, "Ks",
             {stone + (look.color.x - stone) * metal, stone + (look.color.y - stone) * metal,
              stone + (look.color.z - stone) * metal});
    put_line(out, "Ns", {1000 * smooth * smooth});
  }
  if (finish == Finish{}) return;
  put_line(out, "Pr", {finish.roughness});
  put_line(out, "Pm", {finish.metallic});
  put_picture(out, "map_Pr", pictures, finish.roughness_map);
  put_picture(out, "map_Pm", pictures, finish.metallic_map);
  if (finish.normal_map.empty()) return;
  char relief[number_length + 16] = "map_Bump -bm ";
  *put_number(relief + 13, finish.relief) = '\0';
  put_picture(out, relief, pictures, finish.normal_map);
  put_picture(out, "norm", pictures, finish.normal_map);
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
    put_picture(out, look.stains ? "map_d" : "map_Kd", pictures, look.texture);
    put_finish(out, look, pictures);
  }
  out.commit();
  return out.bytes();
}

}  // namespace mansard
