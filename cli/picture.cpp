#include "cli/picture.hpp"

#include <cstdio>

#include "cli/session.hpp"
#include "formats/output_file.hpp"

namespace mansard {
namespace {

Camera camera_of(const std::string& text) {
  const auto camera = parse_camera(text);
  if (!camera) throw UsageError("--camera takes iso, street or x,y,z,tx,ty,tz, not '" + text + "'");
  return *camera;
}

PictureSize size_of(const std::string& text) {
  PictureSize size{0, 0};
  int end = 0;
  const bool read = std::sscanf(text.c_str(), "%5dx%5d%n", &size.width, &size.height, &end) == 2;
  if (!read || static_cast<std::size_t>(end) != text.size() || size.width < 16 ||
      size.height < 16 || size.width > 16000 || size.height > 16000) {
    throw UsageError("--size takes WIDTHxHEIGHT in pixels from 16x16 to 16000x16000, not '" + text +
                     "'");
  }
  return size;
}

}  // namespace

PictureOptions picture_options(const Arguments& arguments, PictureSize otherwise) {
  PictureOptions options;
  if (const auto text = arguments.value("--camera")) options.camera = camera_of(*text);
  const auto text = arguments.value("--size");
  const PictureSize size = text ? size_of(*text) : otherwise;
  options.width = size.width;
  options.height = size.height;
  options.threads = thread_option(arguments);
  return options;
}

std::string picture_output(const Arguments& arguments) {
  const auto out = arguments.value("--output");
  if (!out) throw UsageError("say where the picture goes: -o PICTURE.png");
  if (!out->ends_with(".png"))
    throw UsageError("'" + *out + "' has no ending that this version draws: it draws .png");
  return *out;
}

void write_picture(const Picture& picture, const std::string& path) {
  OutputFile file(path);
  file.put(encode_png(picture));
  file.commit();
}

}  // namespace mansard
