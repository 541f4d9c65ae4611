#include <doctest/doctest.h>
#include <sys/stat.h>

#include <cmath>

#include "formats/meshes.hpp"
#include "support.hpp"

using namespace mansard;
using mansard::test::Folder;

namespace {

std::string problem_of(const std::string& path) {
  std::string problem;
  CHECK(!read_mesh(path, problem));
  return problem;
}

double total_area(const Mesh& mesh) {
  double sum = 0;
  for (const Mesh::Face& face : mesh.faces) {
    std::vector<Vec3> loop;
    for (uint32_t c : mesh.loop(face)) loop.push_back(mesh.points[c]);
    sum += length(newell(loop)) / 2;
  }
  return sum;
}

}  // namespace

TEST_CASE("OBJ meshes keep polygons, coordinates, materials and textures") {
  const Folder folder;
  folder.write("glass.png", "picture");
  folder.write("door.mtl", "newmtl wood\nKd 0.5 0.5 0.5\nd 0.25\nmap_Kd glass.png\n");
  const std::string path =
      folder.write("door.obj",
                   "mtllib door.mtl\no door\nv 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\n"
                   "v 0.5 2.5 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                   "usemtl wood\nf 1/1 2/2 3/3 4/4\nusemtl none\nf -3 -1 \\\n -2\n");
  std::string problem;
  const std::optional<Mesh> mesh = read_mesh(path, problem);
  REQUIRE_MESSAGE(mesh, problem);
  REQUIRE(mesh->faces.size() == 2);
  CHECK(mesh->loop(mesh->faces[0]).size() == 4);
  CHECK(mesh->points.size() == 5);
  REQUIRE(mesh->uvs.size() == mesh->corners.size());
  CHECK(mesh->uvs[2] == Vec2{1, 1});
  const Mesh::Material& wood = mesh->materials.at(mesh->faces[0].material);
  CHECK(wood.name == "wood");
  CHECK(wood.color.x == doctest::Approx(0.2140411));  // sRGB 0.5 is linear 0.214
  CHECK(wood.opacity == doctest::Approx(0.25));
  CHECK(wood.texture == folder / "glass.png");
  CHECK(mesh->faces[1].material == 0);
}

TEST_CASE("a map of opacity is an overlay where it is alone, and there") {
  const Folder folder;
  folder.write("mask.png", "picture");
  folder.write("a.mtl",
               "newmtl dirt\nKd 0 0 0\nmap_d mask.png\n"
               "newmtl lost\nmap_d none.png\n"
               "newmtl leaf\nmap_d mask.png\nmap_Kd mask.png\n");
  std::string problem;
  const auto mesh =
      read_mesh(folder.write("a.obj",
                             "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 2 0\nusemtl dirt\nf 1 2 3\n"
                             "usemtl lost\nf 1 2 3\nusemtl leaf\nf 1 2 3\n"),
                problem);
  REQUIRE_MESSAGE(mesh, problem);
  REQUIRE(mesh->faces.size() == 3);
  const auto look = [&](std::size_t face) {
    return mesh->materials.at(mesh->faces[face].material);
  };
  CHECK(look(0).overlay);
  CHECK(look(0).texture == folder / "mask.png");
  CHECK(!look(1).overlay);
  CHECK(look(1).texture.empty());
  CHECK(!look(2).overlay);
}

TEST_CASE("crooked polygons are divided, planar ones are not, flat ones go") {
  const Folder folder;
  std::string problem;
  const auto mesh = read_mesh(
      folder.write("a.obj",
                   "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\n"
                   "f 1 2 3 4\nf 1 5 6 7 8\nf 1 2 5\n"),
      problem);
  REQUIRE_MESSAGE(mesh, problem);
  REQUIRE(mesh->faces.size() == 3);
  CHECK(mesh->loop(mesh->faces[2]).size() == 5);  // concave, and planar
}

TEST_CASE("meshes that can not be read say why") {
  const Folder folder;
  CHECK(problem_of(folder / "none.obj") == "no such file");
  CHECK(problem_of(folder / "none.glb") == "no such file");
  CHECK(problem_of(folder.string()) == "it is a folder");
  REQUIRE(mkfifo((folder / "pipe.obj").c_str(), 0600) == 0);
  CHECK(problem_of(folder / "pipe.obj") == "it is a device or a pipe");
  CHECK(problem_of(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n")) ==
        "line 3: face of unknown vertex");
  CHECK(problem_of(folder.write("b.obj", "v 0 0 0\n\nf 1 1\n")) ==
        "line 3: face with fewer than three corners");
  CHECK(problem_of(folder.write("c.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1/1 2/1 3/1\n")) ==
        "line 4: face of unknown texture coordinate");
  CHECK(problem_of(folder.write("d.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf x y z\n")) ==
        "line 4: face of unknown vertex");
  CHECK(problem_of(folder.write("e.obj", "hello")) == "it has no faces");
  CHECK(problem_of(folder.write("f.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3")) ==
        "it has no faces with an area");
  CHECK(problem_of(folder.write("g.obj", "v 1e999 0 0\n")) == "line 1: vertex that is not finite");
  CHECK(problem_of(folder.write("n.obj", "v 0 0 0\nv 1 nan 0\n")) ==
        "line 2: 'nan' is no coordinate");
  CHECK(problem_of(folder.write("o.obj", "v 0 0 0\nv 1 2\n")) ==
        "line 2: vertex with fewer than three coordinates");
  CHECK(!problem_of(folder.write("h.glb", "glTF garbage")).empty());
  CHECK(!problem_of(folder.write("i.xyz", "what")).empty());
}

TEST_CASE("faces with hundreds of corners stay whole") {
  const Folder folder;
  std::string text = "", face = "f";
  for (int i = 0; i < 1000; ++i) {
    const double a = 6.283185307179586 * i / 1000;
    text += "v " + std::to_string(std::cos(a)) + " 0 " + std::to_string(-std::sin(a)) + "\n";
    face += " " + std::to_string(i + 1);
  }
  std::string problem;
  const auto mesh = read_mesh(folder.write("disc.obj", text + face + "\n"), problem);
  REQUIRE_MESSAGE(mesh, problem);
  REQUIRE(mesh->faces.size() == 1);
  CHECK(mesh->corners.size() == 1000);
}

TEST_CASE("a closed mesh that shows its inside is turned, an open one is not") {
  const Folder folder;
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string outwards = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  const std::string inwards = "f 2 3 1\nf 4 2 1\nf 4 3 2\nf 4 1 3\n";
  std::string problem;
  for (const std::string& faces : {outwards, inwards}) {
    const auto mesh = read_mesh(folder.write("a.obj", points + faces), problem);
    REQUIRE_MESSAGE(mesh, problem);
    for (const Mesh::Face& face : mesh->faces) {
      std::vector<Vec3> loop;
      for (uint32_t c : mesh->loop(face)) loop.push_back(mesh->points[c]);
      CHECK(dot(newell(loop), loop[0] - Vec3{0.1, 0.1, 0.1}) > 0);
    }
  }
  const auto open = read_mesh(folder.write("b.obj", points + "f 2 3 1\n"), problem);
  REQUIRE(open);
  CHECK(open->loop(open->faces[0])[0] == 1);
}

TEST_CASE("PLY, COLLADA and glTF come through Assimp, nodes merged") {
  const Folder folder;
  std::string problem;
  const auto ply = read_mesh(
      folder.write("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                   "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                   "end_header\n0 0 0\n2 0 0\n2 3 0\n0 3 0\n4 0 1 2 3\n"),
      problem);
  REQUIRE_MESSAGE(ply, problem);
  CHECK(ply->faces.size() == 1);
  CHECK(total_area(*ply) == doctest::Approx(6));

  // One triangle (0,0,0) (1,0,0) (0,1,0), used by two nodes: moved by (5, 0, 0), and mirrored.
  const std::string buffer = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  const auto gltf =
      read_mesh(folder.write("a.gltf",
                             R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0,"translation":[5,0,0]},{"mesh":0,"scale":[-2,1,1]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
"materials":[{"name":"red","pbrMetallicRoughness":{"baseColorFactor":[0.5,0,0,1]}}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)" +
                                 buffer + R"("}]})"),
                problem);
  REQUIRE_MESSAGE(gltf, problem);
  REQUIRE(gltf->faces.size() == 2);
  CHECK(total_area(*gltf) == doctest::Approx(0.5 + 1));
  CHECK(bounds(gltf->points).high.x == doctest::Approx(6));
  CHECK(bounds(gltf->points).low.x == doctest::Approx(-2));
  CHECK(gltf->materials.at(gltf->faces[0].material).color.x == doctest::Approx(0.5));
  // A mirrored node still shows its front.
  for (const Mesh::Face& face : gltf->faces) {
    std::vector<Vec3> loop;
    for (uint32_t c : gltf->loop(face)) loop.push_back(gltf->points[c]);
    CHECK(newell(loop).z > 0);
  }
}
