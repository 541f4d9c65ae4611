// What the commands that draw share: camera, size, and where the picture goes.
#pragma once

#include <string>

#include "cli/arguments.hpp"
#include "render/picture.hpp"

namespace mansard {

struct PictureSize {
  int width, height;  ///< pixels
};

/// --camera, --size and --threads; throws UsageError.
PictureOptions picture_options(const Arguments& arguments, PictureSize otherwise);

/// -o; throws UsageError unless it is there and ends in .png.
std::string picture_output(const Arguments& arguments);

/// Whole or not at all; throws Failure with the system's words.
void write_picture(const Picture& picture, const std::string& path);

}  // namespace mansard
