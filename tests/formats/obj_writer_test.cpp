#include <doctest/doctest.h>
#include <sys/stat.h>

#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <sstream>

#include "formats/numbers.hpp"
#include "formats/obj_reader.hpp"
#include "formats/surface_writer.hpp"
#include "grammar/diagnostic.hpp"
#include "support.hpp"

using namespace mansard;
using mansard::test::content;
using mansard::test::Folder;

namespace {

const std::vector<std::string_view> symbols{"WALL", "WINDOW", "my roof#1"};
const std::vector<Look> looks{{"brick", {0.5, 0.25, 0.1}, 1, ""},
                              {"glass", {0.1, 0.2, 0.3}, 0.5, ""}};

void add_polygon(Surface& s, std::vector<Vec3> loop, uint32_t symbol, uint32_t look) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    s.points.push_back(loop[i]);
    s.uvs.push_back({loop[i].x, loop[i].y});
  }
  s.ends.push_back(static_cast<uint32_t>(s.points.size()));
  s.normals.push_back(normalized(newell(loop)));
  s.runs.push_back({symbol, look, static_cast<uint32_t>(s.ends.size())});
}

/// Polygons of 3 to 6 corners on random planes.
Surface random_surface(std::mt19937& random, int polygons) {
  std::uniform_real_distribution<double> at(-500, 500), angle(0, 6.28), radius(0.1, 20);
  Surface s;
  for (int i = 0; i < polygons; ++i) {
    const Vec3 center{at(random), at(random), at(random)};
    const Vec3 u = normalized(Vec3{at(random), at(random), at(random)});
    const Vec3 v = normalized(cross(u, Vec3{at(random), at(random), at(random)}));
    const int corners = 3 + int(random() % 4);
    const double r = radius(random);
    std::vector<Vec3> loop;
    for (int c = 0; c < corners; ++c) {
      const double a = 6.283185307179586 * c / corners;
      loop.push_back(center + u * (r * std::cos(a)) + v * (r * std::sin(a)));
    }
    add_polygon(s, loop, random() % 3, random() % 2);
  }
  return s;
}

std::string text_of(double value) {
  std::array<char, 64> text;
  return std::string(text.data(), put_number(text.data(), value));
}

std::string failure_of(auto action) {
  try {
    action();
  } catch (const Failure& f) {
    return f.diagnostic.text;
  }
  return "no failure";
}

/// Loops of points in a canonical order: what a file holds, however it is arranged.
using Loops = std::vector<std::vector<Vec3>>;

void check_same(Loops a, Loops b) {
  REQUIRE(a.size() == b.size());
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    REQUIRE(a[i].size() == b[i].size());
    for (std::size_t k = 0; k < a[i].size(); ++k) {
      worst = std::max(worst, length(a[i][k] - b[i][k]));
    }
  }
  CHECK(worst < 1e-6);
}

/// By symbol and look in order of first appearance, as the writer must arrange them.
Loops grouped(const Surface& s) {
  std::vector<uint32_t> symbol_order;
  std::vector<std::pair<uint32_t, uint32_t>> order;
  for (const Surface::Run& run : s.runs) {
    if (std::find(symbol_order.begin(), symbol_order.end(), run.symbol) == symbol_order.end()) {
      symbol_order.push_back(run.symbol);
    }
    const std::pair key{run.symbol, run.material};
    if (std::find(order.begin(), order.end(), key) == order.end()) order.push_back(key);
  }
  Loops loops;
  for (uint32_t symbol : symbol_order) {
    for (const auto& key : order) {
      if (key.first != symbol) continue;
      uint32_t polygon = 0;
      for (const Surface::Run& run : s.runs) {
        for (; polygon < run.end; ++polygon) {
          if (run.symbol != key.first || run.material != key.second) continue;
          const auto loop = s.loop(polygon);
          loops.emplace_back(loop.begin(), loop.end());
        }
      }
    }
  }
  return loops;
}

}  // namespace

TEST_CASE("numbers are short and exact to a tenth of a micrometre") {
  CHECK(text_of(0) == "0");
  CHECK(text_of(-0.0) == "0");
  CHECK(text_of(-1e-9) == "0");
  CHECK(text_of(12.5) == "12.5");
  CHECK(text_of(-7) == "-7");
  CHECK(text_of(1.0 / 3) == "0.3333333");
  CHECK(text_of(-0.0000001) == "-0.0000001");
  CHECK(text_of(0.99999999) == "1");
  CHECK(text_of(100) == "100");
  CHECK(text_of(6671000.1234567) == "6671000.1234567");
  CHECK(std::stod(text_of(1e20)) == 1e20);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1e5, 1e5);
  for (int i = 0; i < 10000; ++i) {
    const double value = any(random);
    const std::string text = text_of(value);
    REQUIRE(std::abs(std::stod(text) - value) <= 5.1e-8);
    REQUIRE(!(text.find('.') != text.npos && text.back() == '0'));
  }
}

namespace {

/// Digit by digit.
std::string slow_text_of(double value) {
  const long long n = std::llround(value * 1e7);
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%s%lld.%07lld", n < 0 ? "-" : "",
                std::abs(n) / 10'000'000, std::abs(n) % 10'000'000);
  std::string trimmed = text.data();
  trimmed.erase(trimmed.find_last_not_of('0') + 1);
  if (trimmed.back() == '.') trimmed.pop_back();
  return trimmed;
}

}  // namespace

TEST_CASE("numbers of all lengths have the digits that they should") {
  std::mt19937_64 random(11);
  for (int i = 0; i < 200'000; ++i) {
    const uint64_t whole = random() >> (random() % 64);
    std::array<char, number_length> text;
    REQUIRE(std::string(text.data(), put_integer(text.data(), whole)) == std::to_string(whole));
    const double unit =
        std::pow(10, double(random() % 8));  // few digits behind the point, and many
    const double value = double(int64_t(random() % 20'000'000'000) - 10'000'000'000) / 10 / unit;
    REQUIRE(text_of(value) == slow_text_of(value));
  }
}

TEST_CASE("counting gives the numbers one after the other") {
  CountedText count;
  for (const uint64_t first : {0ul, 1ul, 9'990ul, 99'999'900ul, 99'999'999ul, 9'999'999'990ul,
                               123'456'999'999'100ul, 18'446'744'073'709'550'000ul}) {
    count.set(first);
    for (uint64_t i = first; i < first + 1200; ++i, count.next()) {
      std::array<char, number_length> text;
      REQUIRE(std::string(text.data(), count.put(text.data())) == std::to_string(i));
    }
  }
}

TEST_CASE("an OBJ is objects, groups, materials and polygons") {
  const Folder folder;
  Surface s;
  add_polygon(s, {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}}, 0, 0);
  add_polygon(s, {{1, 1, 0}, {2, 1, 0}, {2, 2, 0}}, 1, 1);
  add_polygon(s, {{4, 0, 0}, {4, 0, -5}, {4, 3, -5}, {4, 3, 0}}, 0, 0);
  const auto writer = write_obj(folder / "house.obj", Up::y, "seed 7\nstyle Terrace");
  writer->add({"way 12\n3", &s}, symbols, looks);
  const std::size_t bytes = writer->finish(looks);
  const std::string obj = content(folder / "house.obj"), mtl = content(folder / "house.mtl");
  CHECK(bytes == obj.size() + mtl.size());
  CHECK(obj ==
        "# seed 7\n# style Terrace\nmtllib house.mtl\no way_12_3\n"
        "v 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\n"
        "v 4 0 0\nv 4 0 -5\nv 4 3 -5\nv 4 3 0\n"
        "vt 0 0\nvt 4 0\nvt 4 3\nvt 0 3\nvt 1 1\nvt 2 1\nvt 2 2\nvt 4 0\nvt 4 0\nvt 4 3\nvt 4 3\n"
        "vn 0 0 1\nvn 1 0 0\n"
        "g WALL\nusemtl brick\nf 1/1/1 2/2/1 3/3/1 4/4/1\nf 8/8/2 9/9/2 10/10/2 11/11/2\n"
        "g WINDOW\nusemtl glass\nf 5/5/1 6/6/1 7/7/1\n");
  CHECK(mtl == "newmtl brick\nKd 0.5 0.25 0.1\nd 1\nnewmtl glass\nKd 0.1 0.2 0.3\nd 0.5\n");
}

TEST_CASE("names that become one in an OBJ are numbered") {
  const Folder folder;
  Surface s;
  add_polygon(s, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 0, 0);
  const auto writer = write_obj(folder / "model.obj", Up::y, "");
  for (const char* const id : {"a b", "a_b", "a b"}) writer->add({id, &s}, symbols, looks);
  writer->finish(looks);
  std::string names;
  std::istringstream lines(content(folder / "model.obj"));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("o ")) names += line + "\n";
  }
  CHECK(names == "o a_b\no a_b_2\no a_b_3\n");
}

TEST_CASE("a building's lines do not depend on those before it but for their numbers") {
  const Folder folder;
  Surface s;
  add_polygon(s, {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}}, 0, 0);
  const auto writer = write_obj(folder / "a.obj", Up::y, "");
  writer->add({"a", &s}, symbols, looks);
  writer->add({"b", &s}, symbols, looks);
  writer->finish(looks);
  const std::string obj = content(folder / "a.obj");
  CHECK(obj.find("vn 0 0 1", obj.find("o b")) != obj.npos);
  CHECK(obj.find("f 4/4/2 5/5/2 6/6/2\n") != obj.npos);
}

TEST_CASE("z up turns the model and keeps it right-handed") {
  const Folder folder;
  Surface s;
  add_polygon(s, {{1, 2, 3}, {2, 2, 3}, {2, 4, 3}}, 0, 0);
  const auto writer = write_obj(folder / "a.obj", Up::z, "");
  writer->add({"a", &s}, symbols, looks);
  writer->finish(looks);
  const std::string obj = content(folder / "a.obj");
  CHECK(obj.find("v 1 -3 2\nv 2 -3 2\nv 2 -3 4\n") != obj.npos);
  CHECK(obj.find("vn 0 -1 0\n") != obj.npos);
}

TEST_CASE("random surfaces come back through tinyobjloader and Assimp") {
  const unsigned seed = 20240607;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const Folder folder;
  const std::string path = folder / "random.obj";
  std::vector<Surface> buildings;
  buildings.reserve(20);
  for (int i = 0; i < 20; ++i) buildings.push_back(random_surface(random, 1 + i * 15));
  const auto writer = write_obj(path, Up::y, "random");
  Loops expected;
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    writer->add({"b" + std::to_string(i), &buildings[i]}, symbols, looks);
    for (auto& loop : grouped(buildings[i])) expected.push_back(loop);
  }
  writer->finish(looks);

  std::string problem;
  const std::optional<ObjFile> file = read_obj(path, problem);
  REQUIRE(file);
  Loops read;
  for (const Mesh::Face& face : file->mesh.faces) {
    read.emplace_back();
    for (uint32_t c : file->mesh.loop(face)) read.back().push_back(file->mesh.points[c]);
  }
  check_same(expected, read);
  CHECK(file->mesh.materials.size() == 3);  // the plain one and two

  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, 0);
  REQUIRE(scene != nullptr);
  std::size_t faces = 0;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) faces += scene->mMeshes[m]->mNumFaces;
  CHECK(faces == expected.size());
  // Every object is there under its name; normals point the way the corners turn.
  std::size_t wrong = 0;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    REQUIRE(mesh.HasNormals());
    REQUIRE(mesh.HasTextureCoords(0));
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const unsigned* i = mesh.mFaces[f].mIndices;
      const aiVector3D n = (mesh.mVertices[i[1]] - mesh.mVertices[i[0]]) ^
                           (mesh.mVertices[i[2]] - mesh.mVertices[i[0]]);
      if (n * mesh.mNormals[i[0]] <= 0) ++wrong;
    }
  }
  CHECK(wrong == 0);
  for (int i = 0; i < 20; ++i) {
    CHECK(scene->mRootNode->FindNode(("b" + std::to_string(i)).c_str()) != nullptr);
  }
}

TEST_CASE("files appear whole or not at all") {
  const Folder folder;
  const std::string path = folder.write("town.obj", "the old one");
  Surface s;
  add_polygon(s, {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}}, 0, 0);
  {
    const auto writer = write_obj(path, Up::y, "");
    for (int i = 0; i < 50000; ++i) writer->add({"a", &s}, symbols, looks);
  }
  CHECK(content(path) == "the old one");
  CHECK(folder.files() == 1);
  const auto writer = write_obj(path, Up::y, "");
  writer->add({"a", &s}, symbols, looks);
  writer->finish(looks);
  CHECK(content(path) != "the old one");
  CHECK(folder.files() == 2);

  // A link stays a link.
  std::filesystem::create_symlink(path, folder / "link.obj");
  write_obj(folder / "link.obj", Up::y, "through the link")->finish(looks);
  CHECK(std::filesystem::is_symlink(folder / "link.obj"));
  CHECK(content(path).find("# through the link") == 0);
}

TEST_CASE("a full disk and a missing folder are said with the path") {
  const Folder folder;
  Surface s;
  add_polygon(s, {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}}, 0, 0);
  CHECK(failure_of([&] { write_obj(folder / "no/such.obj", Up::y, ""); }) ==
        "can not write '" + (folder / "no/such.obj") + "': No such file or directory");
  CHECK(failure_of([&] { write_obj(folder.string(), Up::y, ""); }) ==
        "can not write '" + folder.string() + "': Is a directory");
  const std::string full = folder / "full.obj";
  std::filesystem::create_symlink("/dev/full", full);
  CHECK(failure_of([&] {
          const auto writer = write_obj(full, Up::y, "");
          for (int i = 0; i < 100000; ++i) writer->add({"a", &s}, symbols, looks);
          writer->finish(looks);
        }) == "can not write '" + full + "': No space left on device");
  CHECK(folder.files() == 1);
  const Look missing{"m", {}, 1, folder / "none.png"};
  const std::string words =
      failure_of([&] { write_obj(folder / "a.obj", Up::y, "")->finish(std::span(&missing, 1)); });
  CHECK(words.find("can not read texture") == 0);
  CHECK(folder.files() == 1);
}

TEST_CASE("textures are copied beside, each once and under a name of its own") {
  const Folder folder;
  std::filesystem::create_directories(folder / "a b");
  std::filesystem::create_directories(folder / "out");
  const std::vector<Look> textured{
      {"one", {1, 1, 1}, 1, folder.write("brick wall.png", "first")},
      {"two", {1, 1, 1}, 1, folder.write("a b/brick wall.png", "second")},
      {"three", {1, 1, 1}, 1, folder / "brick wall.png"}};
  write_obj(folder / "out/my town.obj", Up::y, "")->finish(textured);
  CHECK(content(folder / "out/my_town_brick_wall.png") == "first");
  CHECK(content(folder / "out/my_town_brick_wall_2.png") == "second");
  const std::string mtl = content(folder / "out/my_town.mtl");
  CHECK(std::count(mtl.begin(), mtl.end(), '\n') == 12);
  CHECK(mtl.find("map_Kd my_town_brick_wall_2.png\n") != mtl.npos);
  CHECK(content(folder / "out/my town.obj") == "mtllib my_town.mtl\n");
}
