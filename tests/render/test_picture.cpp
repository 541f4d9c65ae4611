#include "render/picture.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>

#include "render/film.hpp"
#include "render/png.hpp"
#include "tests/render/boxes.hpp"

namespace mansard {

namespace fs = std::filesystem;
using namespace test;

TEST_CASE("any number of threads gives the same bytes") {
  Scene scene = box_scene({9, 6, 5});
  scene.paints.push_back({{0.2, 0.3, 0.4}, true, ""});
  Surface panes;
  add_quad(panes, {2, 2, 5}, {4, 2, 5}, {4, 4, 5}, {2, 4, 5}, 1);  // in the plane of the wall
  scene.add(panes);
  for (const Camera::View view : {Camera::View::iso, Camera::View::street}) {
    PictureOptions options = small();
    options.camera.view = view;
    options.threads = 1;
    const Picture one = render(scene, options);
    for (const int threads : {2, 5, 0}) {
      options.threads = threads;
      CHECK(render(scene, options).rgb == one.rgb);
    }
  }
}

TEST_CASE("a picture made in bands has no seams") {
  const PictureOptions options = small();
  const RayScene world(box_scene({9, 6, 5}));
  const Tracer tracer(world);
  const Lens lens = aim(world, tracer, options);
  const Lighting lighting(world, tracer, lens.forward);
  const auto made = [&](int top, int rows) {
    Film film(options, lens, top, rows);
    expose(film, world, tracer, lighting, 2);
    smooth_light(film);
    draw_ink(film, world);
    return film;
  };
  const Film whole = made(0, 128), band = made(60 - film_border, 8 + 2 * film_border);
  for (int row = 60; row < 68; ++row) {
    for (int x = 0; x < whole.width; ++x) {
      const std::size_t i = whole.at(x, row), k = band.at(x, row - band.top);
      CHECK(whole.light[i].sun == band.light[k].sun);
      CHECK(whole.light[i].ambient.x == band.light[k].ambient.x);
      CHECK(whole.ink[i] == band.ink[k]);
    }
  }
}

TEST_CASE("an empty scene is ground and sky") {
  PictureOptions options = small();
  options.camera.view = Camera::View::street;
  const Picture picture = render({}, options);
  REQUIRE(picture.rgb.size() == std::size_t{3} * 96 * 64);
  const Color sky = color_at(picture, 0.5, 0.05), ground = color_at(picture, 0.5, 0.95);
  CHECK(sky[2] > sky[0] + 8);
  CHECK(ground[0] >= ground[2]);
  CHECK(brightness(ground) > 600);
  options.camera.view = Camera::View::iso;
  CHECK(render({}, options).rgb.size() == picture.rgb.size());
}

TEST_CASE("sizes that are no picture give none") {
  for (const auto& [width, height] : {std::pair{0, 10}, {10, 0}, {-5, 5}, {1 << 20, 1 << 20}}) {
    CHECK(render({}, small(width, height)).rgb.empty());
  }
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {7, 1}}) {
    CHECK(render(box_scene({1, 1, 1}), small(width, height)).rgb.size() ==
          static_cast<std::size_t>(3 * width * height));
  }
}

TEST_CASE("a box casts a shadow on the ground") {
  // Seen from the front the sun stands left, so the shadow falls to the right and behind.
  const Picture picture = render(box_scene({6, 8, 6}), from({3, 26, 30}, {3, 0, 0}));
  const Color lit = color_at(picture, 0.12, 0.55), shaded = color_at(picture, 0.70, 0.42);
  CHECK(brightness(lit) > 600);
  CHECK(brightness(shaded) < brightness(lit) - 100);
  CHECK(shaded[2] > shaded[0]);  // and it is bluish
}

TEST_CASE("paint shows its colour, glass the sky") {
  const PictureOptions front = from({3, 3, 30}, {3, 3, 0});
  const Color red =
      color_at(render(box_scene({6, 6, 6}, {{0.5, 0.05, 0.05}, false, ""}), front), 0.5, 0.5);
  CHECK(red[0] > 2 * red[1]);
  CHECK(red[0] > 120);
  const Paint dark{{0.02, 0.02, 0.02}, false, ""}, pane{{0.02, 0.02, 0.02}, true, ""};
  const Color wall = color_at(render(box_scene({6, 6, 6}, dark), front), 0.5, 0.5);
  const Color glass = color_at(render(box_scene({6, 6, 6}, pane), front), 0.5, 0.5);
  CHECK(brightness(glass) > brightness(wall) + 60);
  CHECK(glass[2] > glass[0]);
}

TEST_CASE("edges are inked, and less so far away") {
  const RayScene world(box_scene({5, 6, 5}));
  const Tracer tracer(world);
  const auto strongest = [&](double distance) {
    const PictureOptions options = from({5 + distance, 3, 5 + distance}, {2, 3, 2});
    Film film(options, aim(world, tracer, options), 0, 128);
    expose(film, world, tracer, Lighting(world, tracer, film.lens.forward), 1);
    draw_ink(film, world);
    return *std::max_element(film.ink.begin(), film.ink.end());
  };
  CHECK(strongest(6) > 0.6);
  CHECK(strongest(100) < 0.3);
}

TEST_CASE("of surfaces in one plane always the same is seen") {
  Scene scene = box_scene({6, 6, 6});
  scene.paints = {{{0.6, 0.1, 0.1}, false, ""}, {{0.1, 0.6, 0.1}, false, ""}, {}};
  Surface other;  // the back of a wall in the front's plane, then a front in it
  add_quad(other, {6, 0, 6}, {0, 0, 6}, {0, 6, 6}, {6, 6, 6}, 2);
  add_quad(other, {-1, -1, 6}, {8, -1, 6}, {8, 7, 6}, {-1, 7, 6}, 1);
  scene.add(other);
  const Picture picture = render(scene, from({3, 3, 30}, {3, 3, 6}));
  for (int y = 16; y < 48; ++y) {
    for (int x = 32; x < 64; ++x) {
      const std::size_t i = static_cast<std::size_t>(3 * (y * 96 + x));
      CHECK(picture.rgb[i + 1] > picture.rgb[i] + 40);
    }
  }
}

TEST_CASE("triangles that are none are left out") {
  const Scene clean = box_scene({6, 6, 6});
  Scene dirty = clean;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  for (const std::array<float, 9>& t : {std::array<float, 9>{nan, 0, 0, 1, 0, 0, 0, 1, 0},
                                        {0, 0, 0, infinite, 0, 0, 0, 1, 0},
                                        {0, 0, 0, 1e30F, 0, 0, 0, 1e30F, 0},
                                        {3, 3, 3, 3, 3, 3, 3, 3, 3},
                                        {0, 9, 0, 1, 9, 0, 2, 9, 0}}) {
    dirty.points.insert(dirty.points.end(), t.begin(), t.end());
    dirty.uvs.insert(dirty.uvs.end(), 6, nan);
    dirty.paint.push_back(0);
    dirty.face.push_back(0);
  }
  CHECK(render(dirty, small()).rgb == render(clean, small()).rgb);
}

TEST_CASE("a scene with missing parts does not crash") {
  Scene scene = box_scene({6, 6, 6}, {{0.5, 0.5, 0.5}, false, "no such picture.png"});
  scene.paint.assign(scene.paint.size(), 77);
  CHECK_FALSE(render(scene, small()).rgb.empty());
  scene.paint.clear();
  scene.face.clear();
  scene.uvs.clear();
  scene.paints.clear();
  scene.points.pop_back();
  CHECK_FALSE(render(scene, small()).rgb.empty());
  scene.paints = {{{std::numeric_limits<double>::quiet_NaN(), -3, 1e9}, false, ""}};
  CHECK_FALSE(render(scene, small()).rgb.empty());
  Surface odd = box({2, 2, 2});
  odd.uvs.clear();
  odd.runs.back().end = 1000;
  scene.add(odd);
  CHECK_FALSE(render(scene, small()).rgb.empty());
}

TEST_CASE("a concave polygon is covered exactly") {
  Surface surface;
  surface.points = {{0, 0, 0}, {6, 0, 0}, {6, 2, 0}, {2, 2, 0}, {2, 6, 0}, {0, 6, 0}};
  surface.uvs.assign(6, {});
  surface.ends = {6};
  surface.normals = {{0, 0, 1}};
  surface.runs = {{0, 3, 1}};
  Scene scene;
  scene.add(surface, 10);
  double area = 0;
  for (std::size_t i = 0; i + 9 <= scene.points.size(); i += 9) {
    const float* p = &scene.points[i];
    area += 0.5 * ((p[3] - p[0]) * (p[7] - p[1]) - (p[4] - p[1]) * (p[6] - p[0]));
  }
  CHECK(area == doctest::Approx(20));
  CHECK(scene.paint == std::vector<uint32_t>(4, 13));
  CHECK(scene.face == std::vector<uint32_t>(4, 0));
  scene.add(surface, 10);
  CHECK(scene.face.back() == 1);
}

TEST_CASE("far from zero a building looks as near it") {
  Scene near = box_scene({6, 6, 6}), far = near;
  for (std::size_t i = 0; i < far.points.size(); i += 3) {
    far.points[i] += 500000;
    far.points[i + 2] -= 700000;
  }
  CHECK(render(far, small()).rgb == render(near, small()).rgb);
}

TEST_CASE("a wall that ends at a roof does not show through it") {
  Surface roof, house;
  for (Surface* s : {&roof, &house}) {
    add_quad(*s, {-4, 2, 3.3}, {4, 2, 3.3}, {4, 5.9, -3.3}, {-4, 5.9, -3.3}, 0);
  }
  // Its upper edge lies in the slope, but for what single precision may add.
  const double low = 2 + 3.9 * 0.3 / 6.6 + 5e-5, high = low + 3.9 * 6 / 6.6;
  add_quad(house, {3.6, 0, 3}, {3.6, 0, -3}, {3.6, high, -3}, {3.6, low, 3}, 0);
  const auto seen = [](const Surface& surface) {
    Scene scene;
    scene.paints.push_back({{0.6, 0.3, 0.2}, false, {}});
    scene.add(surface);
    PictureOptions options = from({9, 16, 12}, {3.6, 3.95, 0});
    options.camera.field_of_view = 1;  // only the slope is seen
    return render(scene, options);
  };
  const Picture without = seen(roof), with = seen(house);
  int specks = 0;
  for (std::size_t i = 0; i < with.rgb.size(); ++i)
    specks += std::abs(without.rgb[i] - with.rgb[i]) > 12;
  CHECK(specks == 0);
}

TEST_CASE("a hole that only one ray finds is closed") {
  Surface whole, pierced;
  constexpr double size = 0.12;  // of a hole; rays meet the wall 0.15 m apart
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const double l = i, b = j, r = i + 1, t = j + 1, x = i + 0.4, y = j + 0.4;
      const auto add = [](Surface& to, double x0, double y0, double x1, double y1) {
        add_quad(to, {x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}, 0);
      };
      add(whole, l, b, r, t);
      add(pierced, l, b, r, y);
      add(pierced, l, y + size, r, t);
      add(pierced, l, y, x, y + size);
      add(pierced, x + size, y, r, y + size);
    }
  }
  const auto seen = [](const Surface& surface) {
    Scene scene;
    scene.paints.push_back({{0.1, 0.05, 0.05}, false, {}});
    scene.add(surface);
    return render(scene, from({3, 3, 30}, {3, 3, 0}));
  };
  const Picture wall = seen(whole), closed = seen(pierced);
  int specks = 0;
  for (std::size_t i = 0; i < wall.rgb.size(); ++i)
    specks += std::abs(wall.rgb[i] - closed.rgb[i]) > 10;
  CHECK(specks == 0);
}

TEST_CASE("a PNG holds its picture; without pixels there is none") {
  const Picture picture{3, 2, {0, 1, 2, 3, 4, 5, 6, 7, 8, 255, 254, 253, 100, 0, 9, 1, 1, 1}};
  const fs::path path = scratch("whole.png");
  std::ofstream(path, std::ios::binary) << encode_png(picture);
  const Picture back = read_picture(path.string());
  CHECK(back.width == 3);
  CHECK(back.height == 2);
  CHECK(back.rgb == picture.rgb);
  CHECK(encode_png({}).empty());
  CHECK(encode_png({3, 2, {1, 2, 3}}).empty());
  std::ofstream(scratch("broken.png")) << "this is no picture";
  CHECK(read_picture(scratch("broken.png").string()).rgb.empty());
}

}  // namespace mansard
