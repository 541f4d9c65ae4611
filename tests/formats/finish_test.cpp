// Roughness, metal, relief and tints in glTF and MTL; pictures that are none.
#include <doctest/doctest.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#include <stb/stb_image.h>

#include <algorithm>

#include "formats/color.hpp"
#include "formats/pictures.hpp"
#include "formats/surface_writer.hpp"
#include "support.hpp"

using namespace mansard;
using mansard::test::content;
using mansard::test::Folder;

namespace {

const std::string pictures = "tests/golden/check/pictures/";

Surface triangle_of(std::size_t looks) {
  Surface s;
  for (uint32_t look = 0; look < looks; ++look) {
    for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
      s.points.push_back(p);
      s.uvs.push_back({p.x, p.y});
    }
    s.ends.push_back(static_cast<uint32_t>(s.points.size()));
    s.normals.push_back({0, 0, 1});
    s.runs.push_back({0, look, static_cast<uint32_t>(s.ends.size())});
  }
  return s;
}

void write(std::unique_ptr<SurfaceWriter> writer, const std::vector<Look>& looks) {
  const std::vector<std::string_view> symbols{"WALL"};
  const Surface surface = triangle_of(looks.size());
  writer->add({"a", &surface}, symbols, looks);
  writer->finish(looks);
}

Finish with_maps(double metallic, const std::string& metal) {
  Finish finish;
  finish.roughness = 0.5;
  finish.metallic = metallic;
  finish.roughness_map = pictures + "gray.png";
  finish.metallic_map = metal;
  return finish;
}

}  // namespace

TEST_CASE("finishes in glTF: factors, packed pictures, normals, linear tints") {
  const Folder folder;
  Finish leaning;
  leaning.normal_map = pictures + "gray.png";
  leaning.relief = 0.5;
  const std::vector<Look> looks{{"plain", {1, 0.5, 0.2}, 1, ""},
                                {"tinted", {1, 0.5, 0.2}, 1, pictures + "gray.png"},
                                {"glass", {0, 0, 0}, 0.25, "", {0.05, 0, 1, "", "", ""}},
                                {"stone", {1, 1, 1}, 1, "", with_maps(0, "")},
                                {"metal", {1, 1, 1}, 1, "", with_maps(1, pictures + "gray.png")},
                                {"leaning", {1, 1, 1}, 1, "", leaning}};
  write(write_gltf(folder / "m.gltf", ""), looks);
  const std::string model = content(folder / "m.gltf");
  const auto material = [&](const std::string& name, const std::string& members) {
    CAPTURE(model);
    CHECK(model.find("{\"name\":\"" + name + "\",\"pbrMetallicRoughness\":{" + members) !=
          std::string::npos);
  };
  const std::string linear = "\"baseColorFactor\":[1.0,0.21404";
  CHECK(to_linear(0.5) == doctest::Approx(0.21404).epsilon(1e-4));
  material("plain", linear);
  material("tinted", "\"baseColorTexture\":{\"index\":0}," + linear);
  material(
      "glass",
      "\"baseColorFactor\":[0.0,0.0,0.0,0.25],\"metallicFactor\":0.0,\"roughnessFactor\":0.05},"
      "\"alphaMode\":\"BLEND\"}");
  // A gray picture will do where there is no metal.
  material("stone",
           "\"baseColorFactor\":[1.0,1.0,1.0,1.0],\"metallicRoughnessTexture\":{\"index\":0},"
           "\"metallicFactor\":0.0,\"roughnessFactor\":0.5}}");
  material("metal",
           "\"baseColorFactor\":[1.0,1.0,1.0,1.0],\"metallicRoughnessTexture\":{\"index\":1},"
           "\"metallicFactor\":1.0,\"roughnessFactor\":0.5}}");
  material("leaning",
           "\"baseColorFactor\":[1.0,1.0,1.0,1.0],\"metallicFactor\":0.0},"
           "\"normalTexture\":{\"index\":0,\"scale\":0.5}}");
  CHECK(model.find("\"images\":[{\"uri\":\"m_gray.png\"},{\"uri\":\"m_metal_rough.png\"}]") !=
        std::string::npos);
  std::size_t with_uvs = 0;
  for (std::size_t at = 0; (at = model.find("TEXCOORD_0", at)) != std::string::npos; ++at)
    ++with_uvs;
  CHECK(with_uvs == 4);  // plain paint and glass have no pictures
  CHECK(model.find("\"TANGENT\"") != std::string::npos);
  CHECK(model.find("\"TANGENT\"") == model.rfind("\"TANGENT\""));  // where there are normals
  write(write_gltf(folder / "m.glb", ""), looks);
  CHECK(content(folder / "m.glb").find(content(folder / "m_metal_rough.png")) != std::string::npos);
}

TEST_CASE("roughness is green and metal blue") {
  const std::string bytes = packed_metal_rough(pictures + "gray.png", pictures + "gray.png");
  int width = 0, height = 0, channels = 0;
  stbi_uc* const pixels =
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                            static_cast<int>(bytes.size()), &width, &height, &channels, 3);
  REQUIRE(pixels);
  CHECK(width == 4);
  CHECK(height == 4);
  CHECK(std::vector<int>(pixels, pixels + 6) == std::vector<int>{255, 120, 120, 255, 130, 130});
  stbi_image_free(pixels);
}

TEST_CASE("of two pictures the smaller is stretched") {
  const Folder folder;
  // A TGA of two pixels side by side: blue, green and red of each.
  const std::string small = folder.write(
      "two.tga", std::string("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\30\0\12\0\0\310\0\0", 24));
  const std::string bytes = packed_metal_rough(pictures + "gray.png", small);
  int width = 0, height = 0, channels = 0;
  stbi_uc* const pixels =
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                            static_cast<int>(bytes.size()), &width, &height, &channels, 3);
  REQUIRE(pixels);
  REQUIRE(width == 4);
  REQUIRE(height == 4);
  for (std::size_t i = 0; i < 16; ++i) {
    CHECK(pixels[3 * i] == 255);
    CHECK(pixels[3 * i + 2] == (i % 4 < 2 ? 10 : 200));
  }
  stbi_image_free(pixels);
}

TEST_CASE("finishes in an MTL, matt surfaces without them") {
  const Folder folder;
  Finish brick = with_maps(0, "");
  brick.normal_map = pictures + "gray.png";
  brick.relief = 0.5;
  write(write_obj(folder / "m.obj", Up::y, ""),
        {{"plain", {1, 0.5, 0.25}, 1, ""},
         {"copper", {1, 0.5, 0.25}, 1, "", {0.5, 1, 1, "", "", ""}},
         {"brick", {1, 1, 1}, 1, pictures + "gray.png", brick}});
  CHECK(content(folder / "m.mtl") ==
        "newmtl plain\nKd 1 0.5 0.25\nd 1\n"
        "newmtl copper\nKd 1 0.5 0.25\nd 1\nKs 1 0.5 0.25\nNs 250\nPr 0.5\nPm 1\n"
        "newmtl brick\nKd 1 1 1\nd 1\nmap_Kd m_gray.png\nKs 0.04 0.04 0.04\nNs 250\nPr 0.5\nPm 0\n"
        "map_Pr m_gray.png\nmap_Bump -bm 0.5 m_gray.png\nnorm m_gray.png\n");
}

TEST_CASE("what is no picture is told of in a few words") {
  const Folder folder;
  CHECK(picture_problem(pictures + "gray.png").empty());
  CHECK(picture_problem(pictures + "words.png") == "it is no PNG, JPEG, BMP or TGA picture");
  CHECK(picture_problem(pictures + "cut_off.png") == "it is cut off");
  CHECK(picture_problem(pictures + "huge.png") ==
        "it has 20000 x 30000 pixels, and a side may have 8192");
  CHECK(picture_problem(folder / "none.png") == "it can not be read");
  CHECK(picture_problem(folder.write("empty.png", "")) == "it is no PNG, JPEG, BMP or TGA picture");
  const std::string large = folder.write("large.png", content(pictures + "gray.png"));
  std::filesystem::resize_file(large, most_picture_bytes + (1 << 20));
  CHECK(picture_problem(large) == "it has 65 MB, and a picture may have 64");
}
