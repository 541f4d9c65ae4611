#include "render/png.hpp"

#include <zlib.h>

#include <cstdlib>
#include <limits>

namespace {

/// A quarter smaller than what stb makes by itself. Freed by stb; null for want of memory.
unsigned char* compress_with_zlib(unsigned char* data, int size, int* packed_size,
                                  int /*quality*/) {
  uLongf room = compressBound(static_cast<uLong>(size));
  auto* const packed = static_cast<unsigned char*>(std::malloc(room));
  if (packed == nullptr ||
      compress2(packed, &room, data, static_cast<uLong>(size), Z_BEST_COMPRESSION) != Z_OK) {
    std::free(packed);
    return nullptr;
  }
  *packed_size = static_cast<int>(room);
  return packed;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress_with_zlib
#define STBI_MAX_DIMENSIONS 8192  // the longest side of textures
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

std::string encode_png(int width, int height, int channels, const std::vector<uint8_t>& values) {
  const bool is_complete = width > 0 && height > 0 &&
                           values.size() == static_cast<std::size_t>(channels) *
                                                static_cast<std::size_t>(width) *
                                                static_cast<std::size_t>(height);
  std::string bytes;
  if (!is_complete) return bytes;
  const bool done = stbi_write_png_to_func(append, &bytes, width, height, channels, values.data(),
                                           channels * width) != 0;
  return done ? bytes : std::string();
}

std::string encode_png(const Picture& picture) {
  return encode_png(picture.width, picture.height, 3, picture.rgb);
}

namespace {

/// Takes the pixels, red, green and blue, that stb made; null for none.
Picture taken(unsigned char* pixels, int width, int height) {
  if (pixels == nullptr) return {};
  const std::size_t bytes =
      std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Picture picture{width, height, {pixels, pixels + bytes}};
  stbi_image_free(pixels);
  return picture;
}

}  // namespace

Picture read_picture(const std::string& path) {
  int width = 0, height = 0, channels = 0;
  unsigned char* const pixels = stbi_load(path.c_str(), &width, &height, &channels, 3);
  return taken(pixels, width, height);
}

Picture decode_picture(const std::string& bytes) {
  if (bytes.size() > std::numeric_limits<int>::max()) return {};
  int width = 0, height = 0, channels = 0;
  unsigned char* const pixels =
      stbi_load_from_memory(reinterpret_cast<const unsigned char*>(bytes.data()),
                            static_cast<int>(bytes.size()), &width, &height, &channels, 3);
  return taken(pixels, width, height);
}

}  // namespace mansard
