// Stains: the flow keeps what it carries, the atlas is the same everywhere, and pictures show it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "render/picture.hpp"
#include "render/png.hpp"
#include "render/stain.hpp"
#include "render/stain_picture.hpp"

using namespace mansard;

namespace {

#if defined(__SANITIZE_ADDRESS__) || !defined(NDEBUG)
constexpr int slower = 20;
#else
constexpr int slower = 1;
#endif

/// The start of the thesis's text, as repaired.
StainFlow usual_flow() {
  StainFlow flow;
  flow.sources = {{64, 40, 0.7}, {30, 3, 0.3}};
  return flow;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

TEST_CASE("water and stain are conserved") {
  std::size_t left_something = 0;
  for (uint64_t seed = 0; seed < 12; ++seed) {
    CAPTURE(seed);
    StainFlow flow = usual_flow();
    flow.width = 40 + 10 * static_cast<int>(seed);
    flow.height = 60;
    flow.sources[0].at = 20;
    flow.adhesion = 0.02 * static_cast<double>(1 + seed);
    flow.solubility = 0.03 * static_cast<double>(seed);
    flow.absorption = 0.1 + 0.1 * static_cast<double>(seed % 4);
    flow.roughness = 0.2 * static_cast<double>(seed);
    flow.steps = 600 / slower;
    const StainField field = run_down(flow, seed);
    const double stain = sum(field.stain) + field.stain_running + field.stain_left;
    const double water = sum(field.water) + field.water_running + field.water_left;
    CHECK(field.stain_brought == flow.steps * flow.drops * flow.concentration);
    CHECK(std::abs(stain / field.stain_brought - 1) < 1e-9);
    CHECK(std::abs(water / field.water_brought - 1) < 1e-9);
    CHECK(std::ranges::min(field.stain) >= 0);
    CHECK(std::ranges::min(field.water) >= 0);
    CHECK(sum(field.stain) > 0.01 * field.stain_brought);
    left_something += field.water_left > 0;
  }
  CHECK((left_something > 3 || slower > 1));
}

TEST_CASE("particles skip no row of texels") {
  StainFlow flow = usual_flow();
  flow.sources = {{64, 1, 1}};
  flow.gravity = 1000;  // as fast as they may
  flow.absorption = 0.05;
  flow.roughness = 0;
  flow.drops = 1;
  flow.steps = 2000 / slower;
  const StainField field = run_down(flow, 3);
  int reached = 0;
  for (int y = 0; y < flow.height; ++y) {
    const auto row = field.stain.begin() + std::ptrdiff_t{y} * flow.width;
    if (*std::max_element(row, row + flow.width) > 0) ++reached;
    if (reached <= y) break;
  }
  CHECK(reached > 100 / slower);
  int rows = 0;  // that hold anything: as many as were reached without a gap
  for (int y = 0; y < flow.height; ++y) {
    const auto row = field.stain.begin() + std::ptrdiff_t{y} * flow.width;
    rows += *std::max_element(row, row + flow.width) > 0;
  }
  CHECK(rows == reached);
  flow.steps = 60;
  const StainField early = run_down(flow, 3);
  const auto below = early.stain.begin() + std::ptrdiff_t{60} * flow.width;
  CHECK(*std::max_element(below, early.stain.end()) == 0);  // a row a step at most
}

TEST_CASE("a flow without sources leaves the wall clean") {
  const StainField field = run_down({}, 1);
  CHECK(sum(field.stain) == 0);
  CHECK(field.moves == 0);
}

TEST_CASE("two million steps of particles take no time to speak of") {
  StainFlow flow = usual_flow();
  flow.steps = 980 / slower;  // of 4 particles more each: 1.9 million
  const std::clock_t start = std::clock();
  const StainField field = run_down(flow, 7);
  const double seconds = seconds_since(start);
  CHECK(field.moves > 1'900'000 / slower / slower);
  CHECK(seconds < 0.4);  // 0.03 s on an idle machine
}

TEST_CASE("the atlas is the same for any number of threads and holds sixteen stains") {
  const std::clock_t start = std::clock();
  const std::vector<uint8_t> atlas = make_stain_atlas(5, 1);
  CHECK(seconds_since(start) < 4 * slower);  // 0.8 s on an idle machine
  REQUIRE(atlas.size() == std::size_t{StainAtlas::width} * StainAtlas::height);
#if !defined(__SANITIZE_ADDRESS__) && defined(NDEBUG)
  CHECK(make_stain_atlas(5, 3) == atlas);
  CHECK(make_stain_atlas(6, 0) != atlas);
#endif
  double before = 0;
  for (int strength = 0; strength < StainAtlas::strengths; ++strength) {
    double row_sum = 0;
    for (int column = 0; column < StainAtlas::columns; ++column) {
      CAPTURE(strength);
      CAPTURE(column);
      const auto at = [&](int x, int y) {
        return atlas[(std::size_t(strength) * StainAtlas::cell_height + std::size_t(y)) *
                         StainAtlas::width +
                     std::size_t(column) * StainAtlas::cell_width + std::size_t(x)];
      };
      int dark = 0;
      for (int y = 0; y < StainAtlas::cell_height; ++y) {
        CHECK(at(0, y) == 0);
        CHECK(at(StainAtlas::cell_width - 1, y) == 0);
        for (int x = 0; x < StainAtlas::cell_width; ++x) {
          row_sum += at(x, y);
          dark += at(x, y) > 10;
        }
      }
      for (int x = 0; x < StainAtlas::cell_width; ++x)
        CHECK(at(x, StainAtlas::cell_height - 1) == 0);
      CHECK(dark > 1000);
      CHECK(dark < StainAtlas::cell_width * StainAtlas::cell_height * 3 / 4);
    }
    CHECK(row_sum > 1.2 * before);  // each row is stronger than the one above
    before = row_sum;
  }
}

TEST_CASE("the shipped stains are those that the program makes") {
  const std::filesystem::path path =
      std::filesystem::path(MANSARD_ROOT) / "styles/library/stains.png";
  const Picture shipped = read_picture(path.string());
  REQUIRE(shipped.width == StainAtlas::width);
  REQUIRE(shipped.height == StainAtlas::height);
#if !defined(__SANITIZE_ADDRESS__) && defined(NDEBUG)
  const std::vector<uint8_t> atlas = make_stain_atlas(0, 0);
  std::size_t different = 0;
  for (std::size_t i = 0; i < atlas.size(); ++i) different += shipped.rgb[3 * i] != atlas[i];
  CHECK(different == 0);
#endif
}

TEST_CASE("a stain darkens the wall behind it and nothing else") {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / "mansard_test_stains.png";
  std::vector<uint8_t> grey_alpha;  // left half clean, right half dark
  for (int i = 0; i < 16 * 16; ++i) {
    const uint8_t dark = i % 16 < 8 ? 0 : 200;
    grey_alpha.insert(grey_alpha.end(), {dark, dark});
  }
  {
    std::ofstream out(file, std::ios::binary);
    out << encode_png(16, 16, 2, grey_alpha);
  }
  const auto add_wall = [](Surface& s, double z, uint32_t material) {
    s.points.insert(s.points.end(), {{0, 0, z}, {8, 0, z}, {8, 6, z}, {0, 6, z}});
    s.uvs.insert(s.uvs.end(), {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    s.ends.push_back(static_cast<uint32_t>(s.points.size()));
    s.normals.push_back({0, 0, 1});
    s.runs.push_back({0, material, static_cast<uint32_t>(s.ends.size())});
  };
  Scene clean, stained;
  Surface wall, layer;
  add_wall(wall, 0, 0);
  add_wall(layer, 0.005, 1);
  for (Scene* const scene : {&clean, &stained}) {
    scene->paints = {{{0.6, 0.6, 0.6}, false, {}},
                     {{0, 0, 0}, false, file.string(), {}, {0, 0, 0}, true}};
    scene->add(wall);
  }
  stained.add(layer);
  PictureOptions options{96, 64, {Camera::View::free, {4, 3, 12}, {4, 3, 0}}, 4, 1};
  const Picture before = render(clean, options), after = render(stained, options);
  const auto at = [](const Picture& p, double x, double y) {
    return int{
        p.rgb[3 * (std::size_t(y * p.height) * std::size_t(p.width) + std::size_t(x * p.width))]};
  };
  CHECK(at(after, 0.4, 0.5) == at(before, 0.4, 0.5));       // clean half
  CHECK(at(after, 0.6, 0.5) < 0.7 * at(before, 0.6, 0.5));  // dark half
  CHECK(at(after, 0.5, 0.05) == at(before, 0.5, 0.05));     // beside the wall
  options.camera.eye = {4, 3, -12};
  CHECK(render(stained, options).rgb == render(clean, options).rgb);  // from behind
  std::filesystem::remove(file);
}
