// Finishes: metal, roughness, relief, tints and textures.
#include <doctest/doctest.h>

#include <fstream>

#include "render/png.hpp"
#include "tests/render/boxes.hpp"

namespace mansard::test {

namespace fs = std::filesystem;

TEST_CASE("metal mirrors the sky, matt paint does not, and tints colour a texture") {
  const auto front = [](Paint paint) {
    return color_at(render(box_scene({9, 6, 5}, paint), from({4.5, 3, 30}, {4.5, 3, 0})), 0.5, 0.5);
  };
  const Vec3 gray{0.2, 0.2, 0.2};
  Finish polished;
  polished.roughness = 0;
  polished.metallic = 1;
  Finish matt = polished;
  matt.roughness = 1;
  CHECK(front({gray, false, "", matt}) == front({gray, false, ""}));
  CHECK(front({gray, false, "", polished}) != front({gray, false, ""}));
  const std::string picture = std::string(MANSARD_ROOT) + "/tests/golden/check/pictures/gray.png";
  const Color plain = front({{0, 0, 0}, false, picture, {}, {1, 1, 1}});
  const Color red = front({{0, 0, 0}, false, picture, {}, {1, 0, 0}});
  CHECK(plain[1] > red[1] + 40);
  CHECK(red[0] > red[1] + 40);
}

TEST_CASE("metal mirrors in its own colour and has no other; pictures say where") {
  const auto front = [](Vec3 color, double roughness, double metallic, const Finish& maps = {}) {
    Paint paint{color, false, "", maps};
    paint.finish.roughness = roughness;
    paint.finish.metallic = metallic;
    return color_at(render(box_scene({9, 6, 5}, paint), from({4.5, 3, 30}, {4.5, 3, 0})), 0.5, 0.5);
  };
  const Vec3 red{0.6, 0.05, 0.05};
  const Color metal = front(red, 0, 1), stone = front(red, 0, 0);
  CHECK(metal[0] > metal[1] + 60);  // of a grey sky
  CHECK(metal[0] < stone[0] - 30);  // which shines and is red
  const auto grey = [](const std::string& name, uint8_t value) {
    const fs::path path = scratch(name);
    std::ofstream(path, std::ios::binary) << encode_png({1, 1, {value, value, value}});
    return path.string();
  };
  Finish rough, plated;
  rough.roughness_map = grey("black.png", 0);
  plated.metallic_map = rough.roughness_map;
  CHECK(front(red, 1, 1, rough) == metal);
  CHECK(front(red, 0, 1, plated) == stone);
}

TEST_CASE("what leans towards the sun is lighter") {
  const auto front = [](const std::string& normals, double relief) {
    Paint paint{{0.4, 0.4, 0.4}, false, "", {}};
    paint.finish.normal_map = std::string(MANSARD_ROOT) + "/tests/golden/check/pictures/" + normals;
    paint.finish.relief = relief;
    return brightness(
        color_at(render(box_scene({9, 6, 5}, paint), from({4.5, 3, 30}, {4.5, 3, 0})), 0.5, 0.5));
  };
  CHECK(front("upward.png", 1) > front("upward.png", 0) + 10);
  CHECK(front("upward.png", 0) > 0);
}

TEST_CASE("the sun stands left of a front, and what leans left is lighter") {
  const auto front = [](const std::string& name, uint8_t across) {
    const fs::path path = scratch(name);
    std::ofstream(path, std::ios::binary) << encode_png({1, 1, {across, 128, 200}});
    Paint paint{{0.4, 0.4, 0.4}, false, "", {}};
    paint.finish.normal_map = path.string();
    return brightness(
        color_at(render(box_scene({9, 6, 5}, paint), from({4.5, 3, 30}, {4.5, 3, 0})), 0.5, 0.5));
  };
  CHECK(front("left.png", 60) > front("right.png", 196) + 10);
}

TEST_CASE("a texture shows, the right way up; a missing one is the plain colour") {
  // Red above, blue below.
  Picture flag{2, 2, {200, 20, 20, 200, 20, 20, 20, 20, 200, 20, 20, 200}};
  const fs::path path = scratch("flag.png");
  std::ofstream(path, std::ios::binary) << encode_png(flag);
  const PictureOptions front = from({3, 3, 30}, {3, 3, 0});
  const Picture picture = render(box_scene({6, 6, 6}, {{0, 1, 0}, false, path.string()}), front);
  const Color upper = color_at(picture, 0.5, 0.40), lower = color_at(picture, 0.5, 0.62);
  CHECK(upper[0] > upper[2] + 60);
  CHECK(lower[2] > lower[0] + 60);
  const Color plain =
      color_at(render(box_scene({6, 6, 6}, {{0.05, 0.6, 0.05}, false, path.string() + "x"}), front),
               0.5, 0.5);
  CHECK(plain[1] > plain[0] + 60);
}

}  // namespace mansard::test
