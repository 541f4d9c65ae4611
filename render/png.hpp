// Reading pictures; writing them is in picture.hpp.
#pragma once

#include <string>

#include "render/picture.hpp"

namespace mansard {

/// PNG, JPEG, BMP and TGA; without colours when the file is missing or broken.
Picture read_picture(const std::string& path);
/// The same of a file's bytes.
Picture decode_picture(const std::string& bytes);

/// The bytes of a PNG file of 1 to 4 channels a pixel, rows from the top; none when there are not
/// as many values as pixels need.
std::string encode_png(int width, int height, int channels, const std::vector<uint8_t>& values);

}  // namespace mansard
