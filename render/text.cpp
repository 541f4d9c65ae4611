#include "render/text.hpp"

#include <freetype/freetype.h>

#include <algorithm>

namespace mansard {

struct Font::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  Face() = default;
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
  ~Face() {
    FT_Done_Face(face);
    FT_Done_FreeType(library);
  }
};

namespace {

constexpr char32_t ellipsis = U'…';

int whole(FT_Pos in_64ths) { return static_cast<int>((in_64ths + 32) >> 6); }

/// Calls f(pen, code point) for every glyph, the pen in pixels from the start of the text; returns
/// where it ends.
template <class F>
int for_each_glyph(FT_Face face, std::u32string_view text, F f) {
  int pen = 0;
  FT_UInt before = 0;
  for (const char32_t c : text) {
    const FT_UInt glyph = FT_Get_Char_Index(face, c);
    FT_Vector kern{0, 0};
    if (before != 0 && glyph != 0) FT_Get_Kerning(face, before, glyph, FT_KERNING_DEFAULT, &kern);
    pen += whole(kern.x);
    if (FT_Load_Glyph(face, glyph, FT_LOAD_TARGET_LIGHT) != 0) continue;
    f(pen);
    pen += whole(face->glyph->advance.x);
    before = glyph;
  }
  return pen;
}

void blend(uint8_t& under, uint8_t ink, int cover) {
  under = static_cast<uint8_t>((under * (255 - cover) + ink * cover + 127) / 255);
}

void put_bitmap(Picture& picture, const FT_Bitmap& bitmap, int left, int top, Rgb ink) {
  for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
    const int y = top + row;
    if (y < 0 || y >= picture.height) continue;
    for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
      const int x = left + column;
      if (x < 0 || x >= picture.width) continue;
      uint8_t* const pixel =
          picture.rgb.data() +
          std::size_t{3} * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                            static_cast<std::size_t>(x));
      const int cover = bitmap.buffer[row * bitmap.pitch + column];
      blend(pixel[0], ink.red, cover);
      blend(pixel[1], ink.green, cover);
      blend(pixel[2], ink.blue, cover);
    }
  }
}

}  // namespace

std::unique_ptr<Font> Font::open(const std::string& path, int pixels) {
  auto made = std::make_unique<Face>();
  if (FT_Init_FreeType(&made->library) != 0) return nullptr;
  if (FT_New_Face(made->library, path.c_str(), 0, &made->face) != 0) return nullptr;
  if (FT_Set_Pixel_Sizes(made->face, 0, static_cast<FT_UInt>(std::clamp(pixels, 4, 400))) != 0)
    return nullptr;
  return std::unique_ptr<Font>(new Font(std::move(made)));
}

Font::Font(std::unique_ptr<Face> face) : face_(std::move(face)) {}
Font::~Font() = default;

int Font::line() const { return whole(face_->face->size->metrics.height); }
int Font::ascent() const { return whole(face_->face->size->metrics.ascender); }

int Font::width(std::u32string_view text) const {
  return for_each_glyph(face_->face, text, [](int) {});
}

void Font::draw(Picture& picture, int x, int baseline, std::u32string_view text, Rgb ink) const {
  const FT_Face face = face_->face;
  for_each_glyph(face, text, [&](int pen) {
    const FT_GlyphSlot glyph = face->glyph;
    if (FT_Render_Glyph(glyph, FT_RENDER_MODE_LIGHT) != 0) return;
    put_bitmap(picture, glyph->bitmap, x + pen + glyph->bitmap_left, baseline - glyph->bitmap_top,
               ink);
  });
}

std::u32string fitted(const Font& font, std::u32string_view text, int pixels) {
  if (font.width(text) <= pixels) return std::u32string(text);
  // Widths grow with length, but for kerning: the longest beginning is found by halving.
  std::size_t least = 0, most = text.size();
  const auto cut = [&](std::size_t length) {
    while (length > 0 && text[length - 1] == U' ') --length;
    return std::u32string(text.substr(0, length)) + ellipsis;
  };
  while (least + 1 < most) {
    const std::size_t middle = (least + most) / 2;
    (font.width(cut(middle)) <= pixels ? least : most) = middle;
  }
  return cut(least);
}

std::vector<std::u32string> wrapped(const Font& font, std::u32string_view text, int pixels,
                                    std::size_t most) {
  std::vector<std::u32string> lines;
  while (!text.empty() && lines.size() < most) {
    if (lines.size() + 1 == most || font.width(text) <= pixels) {
      lines.push_back(fitted(font, text, pixels));
      break;
    }
    std::size_t length = 1;
    while (length < text.size() && font.width(text.substr(0, length + 1)) <= pixels) ++length;
    const std::size_t space = text.substr(0, length + 1).rfind(U' ');
    if (space != std::u32string_view::npos && space > 0) length = space;
    lines.emplace_back(text.substr(0, length));
    text.remove_prefix(length);
    while (!text.empty() && text.front() == U' ') text.remove_prefix(1);
  }
  return lines;
}

}  // namespace mansard
