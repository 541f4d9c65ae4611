// Buildings that are written step by step, many at once.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "formats/obj_reader.hpp"
#include "formats/surface_writer.hpp"
#include "support.hpp"

using namespace mansard;
using mansard::test::content;
using mansard::test::Folder;

namespace {

const std::vector<std::string_view> symbols{"WALL", "WINDOW", "ROOF"};

void add_polygon(Surface& s, std::vector<Vec3> loop, uint32_t symbol, uint32_t look) {
  for (const Vec3& p : loop) {
    s.points.push_back(p);
    s.uvs.push_back({p.x, p.y});
  }
  s.ends.push_back(static_cast<uint32_t>(s.points.size()));
  s.normals.push_back(normalized(newell(loop)));
  s.runs.push_back({symbol, look, static_cast<uint32_t>(s.ends.size())});
}

/// A wall of `floors` with windows, and something solid that stands there twice.
Surface house(double x, int floors, uint32_t look) {
  Surface s;
  for (int i = 0; i < floors; ++i) {
    const double y = 3.0 * i;
    add_polygon(s, {{x, y, 0}, {x + 4, y, 0}, {x + 4, y + 3, 0}, {x, y + 3, 0}}, 0, look);
    add_polygon(s, {{x, y, 1}, {x + 1, y, 1}, {x + 1, y + 2, 1}}, 1, 0);
  }
  for (int i = 0; i < 2; ++i) {
    const double z = 10.0 * i;
    const auto begin = static_cast<uint32_t>(s.polygons());
    for (int side = 0; side < 9; ++side) {
      const double a = 0.7 * side, b = 0.7 * (side + 1);
      add_polygon(
          s,
          {{x, 0, z}, {x + std::cos(a), 1, z + std::sin(a)}, {x + std::cos(b), 1, z + std::sin(b)}},
          2, look);
    }
    s.placed.push_back({nullptr,
                        {x, 0, z},
                        {1, 0, 0},
                        {0, 1, 0},
                        {0, 0, 1},
                        {1, 1, 1},
                        begin,
                        static_cast<uint32_t>(s.polygons())});
  }
  return s;
}

std::vector<Surface> street() {
  std::vector<Surface> houses;
  houses.reserve(12);
  for (int i = 0; i < 12; ++i)
    houses.push_back(i == 5 ? Surface() : house(5.0 * i, 1 + i % 3, i % 4));
  return houses;
}

/// As many looks as buildings up to this one have brought.
std::vector<Look> looks_at(std::size_t building) {
  std::vector<Look> looks;
  for (std::size_t i = 0; i <= std::min<std::size_t>(building, 3); ++i)
    looks.push_back(
        {"a look with a long name, number " + std::to_string(i), {0.1 * double(i), 0, 0}, 1, {}});
  return looks;
}

using Open = std::function<std::unique_ptr<SurfaceWriter>(const std::string& path)>;

std::string one_after_the_other(const std::string& path, const Open& open) {
  const std::vector<Surface> houses = street();
  const auto writer = open(path);
  for (std::size_t i = 0; i < houses.size(); ++i)
    writer->add({"house " + std::to_string(i / 2), &houses[i]}, symbols, looks_at(i));
  writer->finish(looks_at(3));
  return content(path);
}

/// Three at a time, each step from the last one to the first where the order is free; and a piece
/// is numbered before the one two before it is appended. The looks are gone when it is formatted.
std::string step_by_step(const std::string& path, const Open& open) {
  const std::vector<Surface> houses = street();
  const auto writer = open(path);
  std::vector<std::unique_ptr<SurfacePiece>> pieces;
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < houses.size(); ++i) ids.push_back("house " + std::to_string(i / 2));
  pieces.reserve(6);
  for (int i = 0; i < 6; ++i) pieces.push_back(writer->new_piece());
  const auto piece = [&](std::size_t i) -> SurfacePiece& { return *pieces[i % 6]; };
  const auto number = [&](std::size_t i) { piece(i).number(symbols, looks_at(i)); };
  for (std::size_t i = 0; i < 12; i += 3) {
    for (std::size_t k = 3; k-- > 0;) piece(i + k).prepare({ids[i + k], &houses[i + k]});
    for (std::size_t k = 0; k < 3; ++k) {
      if (i > 0 && k > 0) piece(i - 4 + k).append();
      number(i + k);
    }
    if (i > 0) piece(i - 1).append();
    for (std::size_t k = 3; k-- > 0;) piece(i + k).format();
  }
  for (std::size_t i = 9; i < 12; ++i) piece(i).append();
  writer->finish(looks_at(3));
  return content(path);
}

void check_same(const std::string& ending, const Open& open) {
  CAPTURE(ending);
  const Folder one, other;
  const std::string expected = one_after_the_other(one / "m" + ending, open);
  CHECK(expected.size() > 2000);
  CHECK((step_by_step(other / "m" + ending, open) == expected));
}

}  // namespace

TEST_CASE("buildings on their way at once are written as one after the other") {
  check_same(".obj", [](const std::string& path) { return write_obj(path, Up::y, ""); });
  check_same(".ply", [](const std::string& path) { return write_triangles(path, Up::y); });
  for (const bool draco : {false, true}) {
    for (const auto instancing : {Instancing::nodes, Instancing::gpu, Instancing::copies})
      check_same(".glb", [=](const std::string& path) {
        return write_gltf(path, "", {instancing, draco});
      });
  }
}

TEST_CASE("a building too large to keep its text is whole") {
  constexpr std::size_t triangles = 200'000;
  const Folder folder;
  Surface s;
  for (std::size_t i = 0; i < triangles; ++i) {
    const double x = double(i);
    add_polygon(s, {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, x}}, i % 3, 0);
  }
  const auto writer = write_obj(folder / "m.obj", Up::y, "");
  writer->add({"a", &s}, symbols, looks_at(0));
  writer->finish(looks_at(0));
  std::string problem;
  const auto read = read_obj(folder / "m.obj", problem);
  REQUIRE_MESSAGE(read, problem);
  const Mesh& mesh = read->mesh;
  REQUIRE(mesh.points.size() == s.points.size());
  REQUIRE(mesh.faces.size() == triangles);
  std::size_t wrong = 0, face = 0;
  for (uint32_t symbol = 0; symbol < 3; ++symbol) {
    for (std::size_t i = symbol; i < triangles; i += 3, ++face) {
      for (std::size_t k = 0; k < 3; ++k) {
        const uint32_t corner = mesh.faces[face].begin + uint32_t(k);
        if (mesh.points[mesh.corners[corner]] != s.points[3 * i + k]) ++wrong;
        if (mesh.uvs[corner] != s.uvs[3 * i + k]) ++wrong;
      }
    }
  }
  CHECK(wrong == 0);
}
