// Reading pictures; writing them is in picture.hpp.
#pragma once

#include <string>

#include "render/picture.hpp"

namespace mansard {

/// PNG, JPEG, BMP and TGA; without colours when the file is missing or broken.
Picture read_picture(const std::string& path);

}  // namespace mansard
