#include <doctest/doctest.h>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <random>
#include <set>

#include "formats/color.hpp"
#include "formats/surface_writer.hpp"
#include "glb.hpp"
#include "grammar/diagnostic.hpp"
#include "support.hpp"

using namespace mansard;
using namespace mansard::test;

namespace {

/// The area of a primitive's triangles, which must all face as their normals say.
double checked_area(const Glb& glb, const json& primitive) {
  const auto points = items<float, 3>(glb, primitive["attributes"]["POSITION"]);
  const auto normals = items<float, 3>(glb, primitive["attributes"]["NORMAL"]);
  REQUIRE(points.size() == normals.size());
  const json& bounds = glb.document["accessors"][primitive["attributes"]["POSITION"].get<int>()];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::ranges::minmax(points, {}, [&](const std::array<float, 3>& p) { return p[axis]; });
    CHECK(bounds["min"][axis].get<float>() == low[axis]);
    CHECK(bounds["max"][axis].get<float>() == high[axis]);
  }
  const auto vec = [](const std::array<float, 3>& a) { return Vec3{a[0], a[1], a[2]}; };
  for (const auto& n : normals) REQUIRE(std::abs(length(vec(n)) - 1) < 1e-5);
  const std::vector<uint32_t> indices = indices_of(glb, primitive["indices"]);
  REQUIRE(indices.size() % 3 == 0);
  double area = 0;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) REQUIRE(indices[i + k] < points.size());
    const Vec3 a = vec(points[indices[i]]);
    const Vec3 twice = cross(vec(points[indices[i + 1]]) - a, vec(points[indices[i + 2]]) - a);
    REQUIRE(dot(twice, vec(normals[indices[i]])) > -1e-3);
    area += length(twice) / 2;
  }
  return area;
}

std::string failure_of(auto action) {
  try {
    action();
  } catch (const Failure& f) {
    return f.diagnostic.text;
  }
  return "no failure";
}

}  // namespace

TEST_CASE("a .glb has all that was drawn") {
  const Folder folder;
  std::mt19937 random(3);
  const std::string path = folder / "model.glb";
  const auto writer = write_gltf(path, "style A, seed 0\nsomewhere");
  std::vector<Surface> surfaces;
  surfaces.reserve(3);
  for (int i = 0; i < 3; ++i) surfaces.push_back(random_surface(random, 200));
  const std::vector<Property> properties{{"height", 9.5}, {"listed", true}, {"name", "A \"B\""}};
  for (int i = 0; i < 3; ++i)
    writer->add({"house " + std::to_string(i), &surfaces[i], "Terrace", properties}, symbols,
                looks);
  const std::size_t bytes = writer->finish(looks);
  CHECK(bytes == std::filesystem::file_size(path));
  CHECK(folder.files() == 1);

  const Glb glb = read_glb(path);
  const json& d = glb.document;
  CHECK(d["asset"]["extras"]["comment"] == json{"style A, seed 0", "somewhere"});
  REQUIRE(d["scenes"][0]["nodes"].size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const json& house = d["nodes"][d["scenes"][0]["nodes"][i].get<std::size_t>()];
    CHECK(house["name"] == "house " + std::to_string(i));
    CHECK(house["extras"]["style"] == "Terrace");
    CHECK(house["extras"]["attributes"]["height"] == 9.5);
    CHECK(house["extras"]["attributes"]["listed"] == true);
    CHECK(house["extras"]["attributes"]["name"] == "A \"B\"");
    double area = 0;
    std::set<std::string> names;
    for (const json& child : house["children"]) {
      const json& part = d["nodes"][child.get<std::size_t>()];
      names.insert(part["extras"]["symbol"].get<std::string>());
      for (const json& primitive : d["meshes"][part["mesh"].get<std::size_t>()]["primitives"])
        area += checked_area(glb, primitive);
    }
    CHECK(names == std::set<std::string>(symbols.begin(), symbols.end()));
    CHECK(area == doctest::Approx(area_of(surfaces[i])).epsilon(1e-5));
  }
}

TEST_CASE("materials are linear, and only those that are used") {
  const Folder folder;
  Surface s;
  add_polygon(s, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 0, 1);
  add_polygon(s, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}}, 0, 0);
  const auto writer = write_gltf(folder / "m.glb", "");
  writer->add({"a", &s}, symbols, looks);
  writer->finish(looks);
  const json materials = read_glb(folder / "m.glb").document["materials"];
  REQUIRE(materials.size() == 2);
  CHECK(materials[0]["name"] == "glass");
  CHECK(materials[0]["alphaMode"] == "BLEND");
  const json& color = materials[1]["pbrMetallicRoughness"]["baseColorFactor"];
  CHECK(color[0].get<double>() == doctest::Approx(to_linear(0.5)));
  CHECK(color[3] == 1.0);
}

TEST_CASE("assimp reads .glb and .gltf alike, where the building stands") {
  const Folder folder;
  std::mt19937 random(5);
  Surface s = random_surface(random, 50);
  for (Vec3& p : s.points) p = p + Vec3{6000, 0, -6000};
  for (const char* const name : {"model.glb", "my model.gltf"}) {
    const std::string path = folder / name;
    const auto writer = write_gltf(path, "");
    writer->add({"far", &s}, symbols, looks);
    writer->finish(looks);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path, aiProcess_PreTransformVertices);
    REQUIRE_MESSAGE(scene, importer.GetErrorString());
    double worst = 0, area = 0;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
      const aiMesh& mesh = *scene->mMeshes[m];
      for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const Vec3 p{mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z};
        double nearest = 1e9;
        for (const Vec3 q : s.points) nearest = std::min(nearest, length(p - q));
        worst = std::max(worst, nearest);
      }
      for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const auto at = [&](int k) { return mesh.mVertices[mesh.mFaces[f].mIndices[k]]; };
        area += ((at(1) - at(0)) ^ (at(2) - at(0))).Length() / 2;
      }
    }
    CHECK(worst < 1e-3);  // assimp's floats, 6 km away
    CHECK(area == doctest::Approx(area_of(s)).epsilon(1e-3));
  }
  CHECK(folder.files() == 3);  // my model.gltf, my_model.bin
}

TEST_CASE("more vertices than a short index counts") {
  const Folder folder;
  Surface s;
  for (int i = 0; i < 30000; ++i) {
    const double x = i;
    add_polygon(s, {{x, 0, 0}, {x + 0.5, 0, 0}, {x, 1, 0}}, 0, 0);
  }
  const auto writer = write_gltf(folder / "large.glb", "");
  writer->add({"a", &s}, symbols, looks);
  writer->finish(looks);
  const Glb glb = read_glb(folder / "large.glb");
  const json& primitive = glb.document["meshes"][0]["primitives"][0];
  CHECK(glb.document["accessors"][primitive["indices"].get<int>()]["componentType"] == 5125);
  CHECK(checked_area(glb, primitive) == doctest::Approx(30000 * 0.25).epsilon(1e-3));
}

TEST_CASE("textures are in a .glb and beside a .gltf, and begin at the top") {
  const Folder folder;
  const std::string png("\x89PNG\r\n\x1a\nand so on", 17);
  const std::vector<Look> textured{{"brick", {1, 1, 1}, 1, folder.write("brick.png", png)},
                                   {"brick too", {1, 1, 1}, 1, folder / "brick.png"}};
  Surface s;
  add_polygon(s, {{0, 0, 0}, {1, 0, 0}, {1, 0.25, 0}}, 0, 0);
  add_polygon(s, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}}, 0, 1);
  for (const char* const name : {"m.glb", "m.gltf"}) {
    const auto writer = write_gltf(folder / name, "");
    writer->add({"a", &s}, symbols, textured);
    writer->finish(textured);
  }
  const Glb glb = read_glb(folder / "m.glb");
  const json& d = glb.document;
  REQUIRE(d["images"].size() == 1);
  CHECK(d["images"][0]["mimeType"] == "image/png");
  const json& view = d["bufferViews"][d["images"][0]["bufferView"].get<int>()];
  CHECK(glb.binary.substr(view["byteOffset"], view["byteLength"]) == png);
  CHECK(d["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"]["index"] == 0);
  const auto uvs =
      items<float, 2>(glb, d["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"]);
  CHECK(uvs[0] == std::array<float, 2>{0, 1});
  CHECK(uvs[2] == std::array<float, 2>{1, 0.75});
  CHECK(content(folder / "m_brick.png") == png);
  const json beside = json::parse(content(folder / "m.gltf"));
  CHECK(beside["images"][0]["uri"] == "m_brick.png");
  CHECK(beside["buffers"][0]["uri"] == "m.bin");
}

TEST_CASE("a picture that is none is named, and nothing is left") {
  const Folder folder;
  const std::vector<Look> broken{{"brick", {1, 1, 1}, 1, folder.write("brick.bmp", "BM...")}};
  Surface s;
  add_polygon(s, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 0, 0);
  const std::string said = failure_of([&] {
    const auto writer = write_gltf(folder / "m.glb", "");
    writer->add({"a", &s}, symbols, broken);
    writer->finish(broken);
  });
  CHECK(said == "texture '" + (folder / "brick.bmp") +
                    "' is neither a PNG nor a JPEG picture: glTF takes no other");
  CHECK(folder.files() == 1);
  CHECK(failure_of([&] { write_gltf(folder / "none/m.glb", ""); }).starts_with("can not write"));
}

TEST_CASE("a .glb that grows beyond what it can say ends at once, with nothing left") {
  const Folder folder;
  std::mt19937 random(5);
  const Surface s = random_surface(random, 30);
  std::size_t buildings = 0;
  const auto write = [&](const std::string& name) {
    const auto writer = write_gltf(folder / name, "", {.most = 5000});
    for (buildings = 0; buildings < 50; ++buildings) writer->add({"a", &s}, symbols, looks);
    writer->finish(looks);
  };
  CHECK(failure_of([&] { write("m.glb"); }) ==
        "a .glb holds at most 0 MB, and '" + (folder / "m.glb") +
            "' would have more from its building " + std::to_string(buildings + 1) + " on");
  CHECK(buildings < 10);
  CHECK(folder.files() == 0);
  CHECK(failure_of([&] { write("m.gltf"); }) == "no failure");
}

TEST_CASE("a model of nothing is a model") {
  const Folder folder;
  const Surface nothing;
  const auto writer = write_gltf(folder / "m.glb", "");
  writer->add({"a", &nothing}, symbols, looks);
  writer->finish(looks);
  const Glb glb = read_glb(folder / "m.glb");
  CHECK(glb.binary.empty());
  CHECK_FALSE(glb.document.contains("nodes"));
  CHECK_FALSE(glb.document.contains("buffers"));
}

TEST_CASE("meshes that stand in many places are written once and stand where they were drawn") {
  bool mirrored = false;
  SUBCASE("as they are") {}
  SUBCASE("some mirrored") { mirrored = true; }
  const Folder folder;
  const Mesh mesh = stool();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(-20, 20), size(0.5, 3);
  Surface s;
  add_polygon(s, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 1, 0);
  for (int i = 0; i < 300; ++i) {
    const Vec3 x = normalized(Vec3{at(random), at(random), at(random)});
    const Vec3 y = normalized(cross(x, Vec3{at(random), at(random), at(random)}));
    const Vec3 z = cross(x, y) * (mirrored && i % 4 == 0 ? -1 : 1);
    place(s, mesh,
          {nullptr,
           {at(random), at(random), at(random)},
           x,
           y,
           z,
           {size(random), size(random), size(random)}},
          i % 2);
    if (i % 7 == 0) add_polygon(s, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}}, 1, 0);
  }
  Surface plain = s;
  plain.placed.clear();
  for (const auto& [name, surface] : {std::pair{"shared.glb", &s}, {"plain.glb", &plain}}) {
    const auto writer = write_gltf(folder / name, "");
    writer->add({"a", surface}, symbols, looks);
    writer->finish(looks);
  }
  const Glb shared = read_glb(folder / "shared.glb");
  const json& d = shared.document;
  for (const json& one : d["meshes"]) {
    for (const json& primitive : one["primitives"]) checked_area(shared, primitive);
  }
  CHECK(d["meshes"].size() == 2);  // the triangles, and the stool for both symbols
  CHECK(d["nodes"].size() == 1 + 2 + 300);
  CHECK(std::filesystem::file_size(folder / "shared.glb") * 4 <
        std::filesystem::file_size(folder / "plain.glb"));
  const Moments a = moments_of(folder / "shared.glb"), b = moments_of(folder / "plain.glb");
  CHECK(a.area == doctest::Approx(b.area).epsilon(1e-4));
  CHECK(length(a.centre - b.centre) < 1e-4 * b.area * 20);
  if (!mirrored) {
    CHECK(length(a.flux - b.flux) < 1e-3 * length(b.flux));
    return;
  }
  // Which way round a mirrored node shows its triangles is for whoever reads it to know.
  const auto is_mirrored = [](const json& node) {
    return node.contains("scale") && node["scale"][0].get<double>() < 0;
  };
  CHECK(std::ranges::count_if(d["nodes"], is_mirrored) == 75);
}
