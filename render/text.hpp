// Lines of text on pictures.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/picture.hpp"

namespace mansard {

struct Rgb {
  uint8_t red = 0, green = 0, blue = 0;
};

/// One font in one size (FreeType). Text is Unicode; what the font lacks shows as its empty box.
class Font {
 public:
  /// `pixels` is the height of the em. Null when the file can not be read as a font.
  static std::unique_ptr<Font> open(const std::string& path, int pixels);
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  int line() const;    ///< pixels from one baseline to the next
  int ascent() const;  ///< from the top of a line to its baseline
  int width(std::u32string_view text) const;
  /// What falls outside the picture is not drawn.
  void draw(Picture& picture, int x, int baseline, std::u32string_view text, Rgb ink) const;

 private:
  struct Face;
  explicit Font(std::unique_ptr<Face> face);
  std::unique_ptr<Face> face_;
};

/// The text, or as much of its beginning as is at most `pixels` wide with the ellipsis that then
/// ends it.
std::u32string fitted(const Font& font, std::u32string_view text, int pixels);

/// Lines of at most `pixels`, broken at spaces where there are any; an ellipsis ends the last one
/// when `most` lines do not hold the text.
std::vector<std::u32string> wrapped(const Font& font, std::u32string_view text, int pixels,
                                    std::size_t most);

}  // namespace mansard
