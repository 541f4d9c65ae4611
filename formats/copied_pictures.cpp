#include "formats/copied_pictures.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "formats/obj_names.hpp"
#include "formats/output_file.hpp"
#include "grammar/diagnostic.hpp"

namespace mansard {

namespace fs = std::filesystem;

namespace {

std::ifstream opened(const fs::path& picture) {
  const auto refuse = [&](const char* why) {
    Diagnostic d;
    d.text = "can not read texture '" + picture.string() + "': " + why;
    throw Failure(std::move(d));
  };
  std::error_code ignored;
  const fs::file_status status = fs::status(picture, ignored);
  if (fs::is_directory(status)) refuse(std::strerror(EISDIR));
  if (fs::exists(status) && !fs::is_regular_file(status)) refuse("it is a device or a pipe");
  std::ifstream in(picture, std::ios::binary);
  if (!in) refuse(std::strerror(errno));
  return in;
}

void copy_picture(const fs::path& from, const fs::path& to) {
  std::ifstream in = opened(from);
  OutputFile out(to.string());
  while (in) {
    char* room = out.room(OutputFile::block);
    in.read(room, OutputFile::block);
    out.advance(room + in.gcount());
  }
  out.commit();
}

}  // namespace

std::string picture_bytes(const std::string& path) {
  std::ifstream in = opened(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

CopiedPictures::CopiedPictures(const std::string& model)
    : folder_(fs::path(model).parent_path()),
      prefix_(safe_name(fs::path(model).stem().string()) + "_") {}

const std::string& CopiedPictures::name_of(const std::string& path) {
  const auto [entry, fresh] = names_.try_emplace(path);
  if (!fresh) return entry->second;
  entry->second = free_name(fs::path(path).filename().string());
  copy_picture(path, folder_ / entry->second);
  return entry->second;
}

std::string CopiedPictures::put(const std::string& file, const std::string& bytes) {
  std::string name = free_name(file);
  OutputFile out((folder_ / name).string());
  out.put(bytes);
  out.commit();
  return name;
}

std::string CopiedPictures::free_name(const std::string& file) {
  const fs::path name = safe_name(file);
  std::string unique = prefix_ + name.string();
  for (int n = 2; !taken_.insert(unique).second; ++n) {
    unique = prefix_ + name.stem().string() + "_" + std::to_string(n) + name.extension().string();
  }
  return unique;
}

}  // namespace mansard
