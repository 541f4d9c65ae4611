#include "formats/mtl_writer.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "formats/numbers.hpp"
#include "formats/obj_names.hpp"
#include "formats/output_file.hpp"
#include "grammar/diagnostic.hpp"

namespace mansard {
namespace {

namespace fs = std::filesystem;

void copy_picture(const fs::path& from, const fs::path& to) {
  const auto refuse = [&](const char* why) {
    Diagnostic d;
    d.text = "can not read texture '" + from.string() + "': " + why;
    throw Failure(std::move(d));
  };
  std::error_code ignored;
  const fs::file_status status = fs::status(from, ignored);
  if (fs::is_directory(status)) refuse(std::strerror(EISDIR));
  if (fs::exists(status) && !fs::is_regular_file(status)) refuse("it is a device or a pipe");
  std::ifstream in(from, std::ios::binary);
  if (!in) refuse(std::strerror(errno));
  OutputFile out(to.string());
  while (in) {
    char* room = out.room(OutputFile::block);
    in.read(room, OutputFile::block);
    out.advance(room + in.gcount());
  }
  out.commit();
}

/// Copies each picture once, under a name that no other has.
class Textures {
 public:
  explicit Textures(const fs::path& mtl)
      : folder_(mtl.parent_path()), prefix_(safe_name(mtl.stem().string()) + "_") {}

  const std::string& copied_name(const std::string& path) {
    const auto [entry, fresh] = names_.try_emplace(path);
    if (!fresh) return entry->second;
    const fs::path name = safe_name(fs::path(path).filename().string());
    std::string unique = prefix_ + name.string();
    for (int n = 2; !taken_.insert(unique).second; ++n) {
      unique = prefix_ + name.stem().string() + "_" + std::to_string(n) + name.extension().string();
    }
    copy_picture(path, folder_ / unique);
    return entry->second = unique;
  }

 private:
  fs::path folder_;
  std::string prefix_;
  std::map<std::string, std::string> names_;
  std::set<std::string> taken_;
};

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
  Textures textures(path);
  OutputFile out(path);
  for (const Look& look : looks) {
    out.put("newmtl ");
    out.put(safe_name(look.name));
    out.put("\n");
    put_line(out, "Kd", {look.color.x, look.color.y, look.color.z});
    put_line(out, "d", {look.opacity});
    if (look.texture.empty()) continue;
    out.put("map_Kd ");
    out.put(textures.copied_name(look.texture));
    out.put("\n");
  }
  out.commit();
  return out.bytes();
}

}  // namespace mansard
