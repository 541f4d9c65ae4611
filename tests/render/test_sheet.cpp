// Captions and contact sheets.
#include "render/sheet.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "render/text.hpp"

namespace mansard {
namespace {

constexpr Rgb black{0, 0, 0};

Picture white(int width, int height) {
  return {width, height, std::vector<uint8_t>(static_cast<std::size_t>(3 * width * height), 255)};
}

std::size_t dark(const Picture& picture) {
  return static_cast<std::size_t>(
      std::ranges::count_if(picture.rgb, [](uint8_t c) { return c < 128; }));
}

/// A box on the ground, its middle at x.
Scene box_at(float x, float height) {
  Surface surface;
  const auto add = [&](std::initializer_list<Vec3> corners) {
    surface.points.insert(surface.points.end(), corners);
    surface.ends.push_back(static_cast<uint32_t>(surface.points.size()));
    surface.normals.push_back({0, 1, 0});
  };
  const double l = x - 3, r = x + 3, h = height;
  add({{l, 0, 3}, {r, 0, 3}, {r, h, 3}, {l, h, 3}});
  add({{r, 0, 3}, {r, 0, -3}, {r, h, -3}, {r, h, 3}});
  add({{l, h, 3}, {r, h, 3}, {r, h, -3}, {l, h, -3}});
  surface.runs.push_back({0, 0, 3});
  Scene scene;
  scene.paints.push_back({{0.5, 0.1, 0.1}, false, {}});
  scene.add(surface);
  return scene;
}

SheetOptions options(int columns) {
  SheetOptions o;
  o.title = U"Title";
  o.font = MANSARD_FONT;
  o.columns = columns;
  o.cell.width = 96;
  o.cell.height = 64;
  o.cell.threads = 2;
  return o;
}

Picture part(const Picture& sheet, int left, int top, int width, int height) {
  Picture cut{width, height, {}};
  for (int y = top; y < top + height; ++y) {
    const auto* row = sheet.rgb.data() + 3 * (y * sheet.width + left);
    cut.rgb.insert(cut.rgb.end(), row, row + 3 * width);
  }
  return cut;
}

bool same(const Picture& a, const Picture& b) { return a.rgb == b.rgb; }

}  // namespace

TEST_CASE("text is as wide as it says, and falls off no picture") {
  const auto font = Font::open(MANSARD_FONT, 20);
  REQUIRE(font);
  const int width = font->width(U"Façade Ж");
  CHECK(width > 60);
  Picture picture = white(width + 4, font->line() + 4);
  font->draw(picture, 2, 2 + font->ascent(), U"Façade Ж", black);
  CHECK(dark(picture) > 100);
  for (int y = 0; y < picture.height; ++y) {
    CHECK(picture.rgb[static_cast<std::size_t>(3 * y * picture.width)] == 255);
  }
  for (const int x : {-30, picture.width - 5}) font->draw(picture, x, 5, U"outside", black);
  CHECK(Font::open(std::string(MANSARD_FONT) + "x", 20) == nullptr);
}

TEST_CASE("what is too long ends in an ellipsis") {
  const auto font = Font::open(MANSARD_FONT, 14);
  REQUIRE(font);
  const std::u32string text = U"Tile.WindowWidth = 0.8, Roof.Kind = gable";
  CHECK(fitted(*font, text, 1000) == text);
  const std::u32string cut = fitted(*font, text, 120);
  CHECK(cut.back() == U'…');
  CHECK(cut.size() > 8);
  CHECK(font->width(cut) <= 120);
  CHECK(font->width(text.substr(0, cut.size() + 1)) > 120 - font->width(U"…"));
  CHECK(fitted(*font, text, 0) == U"…");

  const auto lines = wrapped(*font, text, 150, 10);
  CHECK(lines.size() > 2);
  std::u32string all;
  for (const auto& line : lines) {
    CHECK(font->width(line) <= 150);
    all += (all.empty() ? U"" : U" ") + line;
  }
  CHECK(all == text);
  CHECK(wrapped(*font, text, 150, 2).size() == 2);
  CHECK(wrapped(*font, text, 150, 2)[1].back() == U'…');
  CHECK(wrapped(*font, U"", 120, 2).empty());
}

TEST_CASE("all cells are seen by one camera") {
  const Scene low = box_at(0, 3), high = box_at(0, 12), aside = box_at(30, 3);
  const auto alone = [&](const Scene& scene) {
    const std::vector<SheetCell> cells{{&scene, U"a", U""}, {&low, U"a", U""}};
    return *draw_sheet(cells, options(2), [] {});
  };
  const Picture sheet = alone(low);
  const SheetSize size = sheet_size(2, options(2));
  CHECK(sheet.width == size.width);
  CHECK(sheet.height == size.height);
  // Equal scenes give equal pictures, whatever stands beside them; a higher neighbour makes them
  // smaller, because the camera must hold both.
  const int left = 10, step = 96 + 10;
  const int top = sheet.height - 10 / 4 - (64 + 11 * 3 / 2 + 10 * 3 / 4);
  CHECK(same(part(sheet, left, top, 96, 64), part(sheet, left + step, top, 96, 64)));
  const Picture with_high = alone(high), with_aside = alone(aside);
  CHECK_FALSE(
      same(part(sheet, left + step, top, 96, 64), part(with_high, left + step, top, 96, 64)));
  CHECK_FALSE(
      same(part(with_aside, left, top, 96, 64), part(with_aside, left + step, top, 96, 64)));
}

TEST_CASE("margins are paper, failed cells say why, a missing font gives nothing") {
  const Scene box = box_at(0, 3);
  const std::vector<SheetCell> cells{
      {&box, U"seed 1", U""}, {nullptr, U"seed 2", U"a height must be positive"}, {&box, U"", U""}};
  int drawn = 0;
  const auto sheet = draw_sheet(cells, options(2), [&] { ++drawn; });
  REQUIRE(sheet);
  CHECK(drawn == 3);
  const auto paper = [&](int x, int y) {
    return sheet->rgb[static_cast<std::size_t>(3 * (y * sheet->width + x))] == 250;
  };
  for (int y = 0; y < sheet->height; ++y) {
    for (const int x : {0, 8, 10 + 96, 10 + 96 + 8, sheet->width - 1}) CHECK(paper(x, y));
  }
  SheetOptions without = options(2);
  without.font = "no such font";
  CHECK_FALSE(draw_sheet(cells, without, [] {}));
}

TEST_CASE("columns make a sheet that is wider than high") {
  CHECK(sheet_columns(1, 400, 300) == 1);
  CHECK(sheet_columns(3, 400, 300) == 3);
  CHECK(sheet_columns(12, 400, 300) == 4);
  CHECK(sheet_columns(12, 300, 600) == 6);
}

}  // namespace mansard
