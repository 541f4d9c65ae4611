// PLY and STL read back by Assimp; the size of an STL says how many triangles it has.
#include <array>
#include <cstring>
#include <filesystem>

#include "glb.hpp"
#include "grammar/diagnostic.hpp"
#include "support.hpp"

using namespace mansard;
using namespace mansard::test;

namespace {

std::size_t triangles_of(const Surface& s) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < s.polygons(); ++i) count += s.loop(i).size() - 2;
  return count;
}

Diagnostic failure_of(auto action) {
  try {
    action();
  } catch (const Failure& f) {
    return f.diagnostic;
  }
  return {};
}

}  // namespace

TEST_CASE("PLY and STL have every triangle, where it stood") {
  const Folder folder;
  std::mt19937 random(7);
  std::vector<Surface> houses;
  for (int i = 0; i < 2; ++i) houses.push_back(random_surface(random, 60));
  const std::size_t triangles = triangles_of(houses[0]) + triangles_of(houses[1]);
  Box3 drawn = bounds(houses[0].points);
  for (const Vec3 p : houses[1].points) {
    drawn.low = {std::min(drawn.low.x, p.x), std::min(drawn.low.y, p.y),
                 std::min(drawn.low.z, p.z)};
    drawn.high = {std::max(drawn.high.x, p.x), std::max(drawn.high.y, p.y),
                  std::max(drawn.high.z, p.z)};
  }
  for (const std::string name : {"a.ply", "a.stl"}) {
    for (const Up up : {Up::y, Up::z}) {
      CAPTURE(name);
      const auto writer = write_triangles(folder / name, up);
      for (const Surface& s : houses) writer->add({"a", &s}, symbols, looks);
      const std::size_t bytes = writer->finish(looks);
      CHECK(bytes == std::filesystem::file_size(folder / name));
      CHECK(folder.files() == (name == "a.ply" ? 1 : 2));
      const Moments read = moments_of(folder / name);
      CHECK(read.triangles == triangles);
      CHECK(read.area == doctest::Approx(area_of(houses[0]) + area_of(houses[1])).epsilon(1e-5));
      const Box3 box = bounds(points_of(folder / name));
      const Vec3 low = up == Up::y ? drawn.low : Vec3{drawn.low.x, -drawn.high.z, drawn.low.y};
      const Vec3 high = up == Up::y ? drawn.high : Vec3{drawn.high.x, -drawn.low.z, drawn.high.y};
      CHECK(length(box.low - low) < 1e-3);
      CHECK(length(box.high - high) < 1e-3);
    }
  }
  CHECK(std::filesystem::file_size(folder / "a.stl") == 84 + 50 * triangles);
}

/// The least of the cosines between a triangle's normal as an STL says it and as its corners do.
double worst_normal(const std::string& stl) {
  double worst = 1;
  for (std::size_t at = 84; at + 50 <= stl.size(); at += 50) {
    std::array<std::array<float, 3>, 4> numbers;
    std::memcpy(&numbers, stl.data() + at, sizeof numbers);
    const auto vector = [&](std::size_t i) {
      return Vec3{numbers[i][0], numbers[i][1], numbers[i][2]};
    };
    const Vec3 across = cross(vector(2) - vector(1), vector(3) - vector(1));
    if (length(across) > 1e-3)  // else single precision says little
      worst = std::min(worst, dot(normalized(vector(0)), normalized(across)));
  }
  return worst;
}

TEST_CASE("normals of an STL are its triangles'") {
  const Folder folder;
  std::mt19937 random(8);
  const Surface s = random_surface(random, 60);
  for (const Up up : {Up::y, Up::z}) {
    const auto writer = write_triangles(folder / "a.stl", up);
    writer->add({"a", &s}, symbols, looks);
    writer->finish(looks);
    CHECK(worst_normal(content(folder / "a.stl")) > 0.99);
  }
}

TEST_CASE("what does not fit into a PLY is said, and nothing is left") {
  const Folder folder;
  std::mt19937 random(7);
  const Surface s = random_surface(random, 60);
  const Diagnostic many = failure_of([&] {
    const auto writer = write_triangles(folder / "a.ply", Up::y, triangles_of(s) - 1);
    writer->add({"a", &s}, symbols, looks);
  });
  CHECK(many.text == "the model has more than " + std::to_string(triangles_of(s) - 1) +
                         " triangles, the most that a .ply is written with: '" +
                         (folder / "a.ply") + "'");
  CHECK(many.help.starts_with("write an .obj or a .glb"));
  write_triangles(folder / "a.ply", Up::y, triangles_of(s))->add({"a", &s}, symbols, looks);
  const Diagnostic nothing =
      failure_of([&] { write_triangles(folder / "a.stl", Up::y)->finish(looks); });
  CHECK(nothing.text == "nothing was drawn that '" + (folder / "a.stl") + "' could hold");
  CHECK(failure_of([&] {
          write_triangles(folder / "none/a.stl", Up::y);
        }).text.starts_with("can not write"));
  CHECK(folder.files() == 0);
}
