#include "render/sheet.hpp"

#include <cmath>
#include <limits>

#include "render/film.hpp"
#include "render/text.hpp"

namespace mansard {
namespace {

constexpr Rgb paper{250, 249, 246}, blank{238, 236, 231};
constexpr Rgb title_ink{34, 34, 38}, caption_ink{64, 64, 70}, message_ink{160, 44, 30};

/// Where things are, in pixels. Every margin and every gap between columns is `margin`.
struct Layout {
  int margin, caption_em, title_em;
  int caption_line, title_line;  ///< heights
  int width, height, cell_height;

  Layout(std::size_t count, const SheetOptions& options) {
    const int cell_width = options.cell.width;
    caption_em = std::clamp(static_cast<int>(std::lround(cell_width * 0.036)), 11, 60);
    title_em = caption_em * 3 / 2;
    margin = std::max(10, cell_width * 6 / 100);
    caption_line = caption_em * 3 / 2;
    title_line = title_em * 3 / 2;
    cell_height = options.cell.height + caption_line + margin * 3 / 4;
    const int columns = options.columns;
    const int rows = (static_cast<int>(count) + columns - 1) / columns;
    width = margin + columns * (cell_width + margin);
    height = top() + rows * cell_height + margin / 4;
  }
  int top() const { return margin / 2 + title_line + margin / 2; }
  int left(std::size_t cell, const SheetOptions& options) const {
    return margin + static_cast<int>(cell) % options.columns * (options.cell.width + margin);
  }
  int upper(std::size_t cell, const SheetOptions& options) const {
    return top() + static_cast<int>(cell) / options.columns * cell_height;
  }
};

void fill(Picture& sheet, int left, int top, int width, int height, Rgb ink) {
  for (int y = top; y < top + height; ++y) {
    uint8_t* out = sheet.rgb.data() + std::size_t{3} * (static_cast<std::size_t>(y) *
                                                            static_cast<std::size_t>(sheet.width) +
                                                        static_cast<std::size_t>(left));
    for (int x = 0; x < width; ++x) {
      *out++ = ink.red;
      *out++ = ink.green;
      *out++ = ink.blue;
    }
  }
}

void paste(Picture& sheet, const Picture& picture, int left, int top) {
  const auto row = std::size_t{3} * static_cast<std::size_t>(picture.width);
  for (int y = 0; y < picture.height; ++y) {
    const auto to = std::size_t{3} *
                    (static_cast<std::size_t>(top + y) * static_cast<std::size_t>(sheet.width) +
                     static_cast<std::size_t>(left));
    std::copy_n(picture.rgb.data() + row * static_cast<std::size_t>(y), row, sheet.rgb.data() + to);
  }
}

/// All there is to see in any cell; only where it is matters.
Scene together(std::span<const SheetCell> cells) {
  Scene all;
  for (const SheetCell& cell : cells) {
    if (!cell.scene) continue;
    all.points.insert(all.points.end(), cell.scene->points.begin(), cell.scene->points.end());
  }
  return all;
}

/// The camera, ground and light that all cells share.
class Studio {
 public:
  Studio(std::span<const SheetCell> cells, const PictureOptions& options)
      : frame_(together(cells)), lens_(aim(frame_, Tracer(frame_), options)), options_(options) {
    if (options.camera.view == Camera::View::free) return;
    constexpr float air = 1.08F;  // small pictures need more of it
    lens_.right = lens_.right * air;
    lens_.up = lens_.up * air;
  }

  Picture picture_of(const Scene& scene) const {
    const RayScene world(scene, frame_);
    const Tracer tracer(world);
    return paint(world, tracer, lens_, options_);
  }

 private:
  RayScene frame_;
  Lens lens_;
  PictureOptions options_;
};

void put_message(Picture& sheet, const Font& font, const std::u32string& message, int left, int top,
                 const PictureOptions& cell) {
  fill(sheet, left, top, cell.width, cell.height, blank);
  const int indent = cell.width / 16;
  const int room = (cell.height - 2 * indent) / font.line();
  const auto lines =
      wrapped(font, message, cell.width - 2 * indent, static_cast<std::size_t>(std::max(1, room)));
  const int block = static_cast<int>(lines.size()) * font.line();
  int baseline = top + (cell.height - block) / 2 + font.ascent();
  for (const std::u32string& line : lines) {
    font.draw(sheet, left + indent, baseline, line, message_ink);
    baseline += font.line();
  }
}

}  // namespace

int sheet_columns(std::size_t count, int cell_width, int cell_height) {
  const int all = static_cast<int>(count);
  if (all <= 3) return std::max(1, all);
  int best = 1;
  double least = std::numeric_limits<double>::infinity();
  for (int columns = 1; columns <= all; ++columns) {
    const int rows = (all + columns - 1) / columns;
    const double aspect = columns * cell_width / (rows * cell_height * 1.12);
    const double empty = static_cast<double>(columns * rows - all) / all;
    const double cost = std::abs(std::log(aspect / 1.5)) + empty;
    if (cost >= least) continue;
    least = cost;
    best = columns;
  }
  return best;
}

SheetSize sheet_size(std::size_t count, const SheetOptions& options) {
  const Layout layout(count, options);
  return {layout.width, layout.height};
}

std::optional<Picture> draw_sheet(std::span<const SheetCell> cells, const SheetOptions& options,
                                  const std::function<void()>& drawn) {
  const Layout layout(cells.size(), options);
  const auto title = Font::open(options.font, layout.title_em);
  const auto caption = Font::open(options.font, layout.caption_em);
  if (!title || !caption) return {};
  Picture sheet{layout.width, layout.height, {}};
  sheet.rgb.resize(std::size_t{3} * static_cast<std::size_t>(layout.width) *
                   static_cast<std::size_t>(layout.height));
  fill(sheet, 0, 0, layout.width, layout.height, paper);
  title->draw(sheet, layout.margin, layout.margin / 2 + title->ascent(),
              fitted(*title, options.title, layout.width - 2 * layout.margin), title_ink);

  const Studio studio(cells, options.cell);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int left = layout.left(i, options), top = layout.upper(i, options);
    if (cells[i].scene) {
      paste(sheet, studio.picture_of(*cells[i].scene), left, top);
    } else {
      put_message(sheet, *caption, cells[i].message, left, top, options.cell);
    }
    caption->draw(sheet, left,
                  top + options.cell.height + layout.caption_em / 4 + caption->ascent(),
                  fitted(*caption, cells[i].caption, options.cell.width), caption_ink);
    drawn();
  }
  return sheet;
}

}  // namespace mansard
