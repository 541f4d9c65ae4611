#include "formats/pictures.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>

#include "grammar/diagnostic.hpp"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

namespace mansard {
namespace {

namespace fs = std::filesystem;

/// A PNG ends with its chunk IEND, a JPEG with the marker EOI, maybe with something behind.
bool is_cut_off(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  char head[4] = {};
  in.read(head, sizeof head);
  const std::string_view begins(head, sizeof head);
  const bool is_png = begins == "\x89PNG", is_jpeg = begins.starts_with("\xff\xd8");
  if (!is_png && !is_jpeg) return false;
  const auto bytes = static_cast<std::streamoff>(fs::file_size(path));
  in.clear();
  in.seekg(std::max<std::streamoff>(0, bytes - 65536));
  const std::string end{std::istreambuf_iterator<char>(in), {}};
  return end.find(is_png ? "IEND" : "\xff\xd9") == std::string::npos;
}

}  // namespace

std::string picture_problem(const std::string& path) {
  std::error_code error;
  const uint64_t bytes = fs::file_size(path, error);
  if (error) return "it can not be read";
  if (bytes > most_picture_bytes)
    return "it has " + std::to_string(bytes >> 20) + " MB, and a picture may have " +
           std::to_string(most_picture_bytes >> 20);
  int width = 0, height = 0, channels = 0;
  if (stbi_info(path.c_str(), &width, &height, &channels) == 0)
    return "it is no PNG, JPEG, BMP or TGA picture";
  if (std::max(width, height) > longest_picture_side) {
    return "it has " + std::to_string(width) + " x " + std::to_string(height) +
           " pixels, and a side may have " + std::to_string(longest_picture_side);
  }
  return is_cut_off(path) ? "it is cut off" : "";
}

namespace {

/// Red, green and blue, rows from the top; repeats like a texture.
struct Pixels {
  int width = 1, height = 1;
  std::vector<uint8_t> rgb{255, 255, 255};

  uint8_t at(int x, int y, int width_of, int height_of, std::size_t channel) const {
    const auto column = static_cast<std::size_t>(int64_t{x} * width / width_of);
    const auto row = static_cast<std::size_t>(int64_t{y} * height / height_of);
    return rgb[3 * (row * static_cast<std::size_t>(width) + column) + channel];
  }
};

Pixels pixels_of(const std::string& path) {
  Pixels pixels;
  if (path.empty()) return pixels;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&std::free)> data(
      stbi_load(path.c_str(), &pixels.width, &pixels.height, &channels, 3), std::free);
  if (!data) {
    Diagnostic d;
    d.text = "can not read texture '" + path + "': it is no picture, or a broken one";
    throw Failure(std::move(d));
  }
  const std::size_t bytes = std::size_t{3} * static_cast<std::size_t>(pixels.width) *
                            static_cast<std::size_t>(pixels.height);
  pixels.rgb.assign(data.get(), data.get() + bytes);
  return pixels;
}

void append(void* bytes, void* data, int size) {
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(data),
                                           static_cast<std::size_t>(size));
}

}  // namespace

std::string packed_metal_rough(const std::string& roughness, const std::string& metallic) {
  const Pixels rough = pixels_of(roughness), metal = pixels_of(metallic);
  const int width = std::max(rough.width, metal.width);
  const int height = std::max(rough.height, metal.height);
  std::vector<uint8_t> packed;
  packed.reserve(std::size_t{3} * static_cast<std::size_t>(width) *
                 static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      packed.push_back(255);
      packed.push_back(rough.at(x, y, width, height, 1));
      packed.push_back(metal.at(x, y, width, height, 2));
    }
  }
  std::string bytes;
  stbi_write_png_to_func(append, &bytes, width, height, 3, packed.data(), 3 * width);
  return bytes;
}

}  // namespace mansard
