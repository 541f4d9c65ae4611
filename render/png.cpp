#include "render/png.hpp"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

namespace mansard {
namespace {

void append(void* bytes, void* data, int size) {
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(data),
                                           static_cast<std::size_t>(size));
}

}  // namespace

std::string encode_png(const Picture& picture) {
  const bool is_complete = picture.width > 0 && picture.height > 0 &&
                           picture.rgb.size() == std::size_t{3} *
                                                     static_cast<std::size_t>(picture.width) *
                                                     static_cast<std::size_t>(picture.height);
  std::string bytes;
  if (!is_complete) return bytes;
  const bool done = stbi_write_png_to_func(append, &bytes, picture.width, picture.height, 3,
                                           picture.rgb.data(), 3 * picture.width) != 0;
  return done ? bytes : std::string();
}

Picture read_picture(const std::string& path) {
  Picture picture;
  int channels = 0;
  unsigned char* pixels = stbi_load(path.c_str(), &picture.width, &picture.height, &channels, 3);
  if (pixels == nullptr) return {};
  picture.rgb.assign(pixels, pixels + std::size_t{3} * static_cast<std::size_t>(picture.width) *
                                          static_cast<std::size_t>(picture.height));
  stbi_image_free(pixels);
  return picture;
}

}  // namespace mansard
