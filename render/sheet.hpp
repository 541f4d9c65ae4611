// Contact sheets: pictures of variants of one thing, side by side.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/picture.hpp"

namespace mansard {

struct SheetCell {
  const Scene* scene = nullptr;  ///< null: there is none, and `message` says why
  std::u32string caption, message;
};

struct SheetOptions {
  std::u32string title;
  std::string font;     ///< path of the font file
  int columns = 1;      ///< at least 1
  PictureOptions cell;  ///< of each picture
};

/// The number of columns that makes a sheet of `count` pictures of this size look well.
int sheet_columns(std::size_t count, int cell_width, int cell_height);

struct SheetSize {
  int width = 0, height = 0;  ///< pixels
};
SheetSize sheet_size(std::size_t count, const SheetOptions& options);

/// All pictures are taken by one camera that holds every scene, on one ground and in one light, so
/// that they compare. `drawn` is called after each. Text that is too long ends in an ellipsis.
/// Nothing when the font can not be read.
std::optional<Picture> draw_sheet(std::span<const SheetCell> cells, const SheetOptions& options,
                                  const std::function<void()>& drawn);

}  // namespace mansard
