// Meshes come from anywhere: whatever a file holds or names, it is a mesh or a few words about it.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "formats/mesh_stream.hpp"
#include "formats/meshes.hpp"
#include "support.hpp"

using namespace mansard;
using mansard::test::Folder;

namespace {

namespace fs = std::filesystem;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string problem_of(const std::string& path, const MeshLimits& limits = {}) {
  std::string problem;
  CHECK(!read_mesh(path, problem, limits));
  return problem;
}

MeshLimits within(const std::string& folder) {
  MeshLimits limits;
  limits.folders = {folder};
  return limits;
}

std::string gltf(const std::string& nodes, const std::string& uri) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
         R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
         uri + R"("}]})";
}
const std::string in_place =
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";

std::string ply(const std::string& kind, const std::string& vertices, const std::string& rest) {
  return "ply\nformat " + kind + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n" +
         rest;
}

const std::string collada = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>
<accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

}  // namespace

TEST_CASE("a mesh outside the project is not read, whatever way leads there") {
  const Folder outside, project;
  outside.write("door.obj", triangle);
  outside.write("door.ply", ply("ascii", "3", "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  const MeshLimits limits = within(project.string());
  const std::string why =
      "it lies outside the folders of the scripts, of --style-path and of the library";
  CHECK(problem_of(outside / "door.obj", limits) == why);
  CHECK(problem_of(outside / "door.ply", limits) == why);
  CHECK(problem_of(project / ("../" + fs::path(outside.string()).filename().string() + "/door.obj"),
                   limits) == why);
  fs::create_symlink(outside / "door.obj", project / "link.obj");
  CHECK(problem_of(project / "link.obj", limits) == why);
  fs::create_directory(project / "in");
  fs::create_directory(project / "inside");
  CHECK(problem_of(project.write("inside/door.obj", triangle), within(project / "in")) == why);
  std::string problem;
  CHECK(read_mesh(outside / "door.obj", problem));  // as `mansard render` reads a model
  CHECK(read_mesh(project.write("mine.obj", triangle), problem, limits));
  fs::create_directory_symlink(project.string(), outside / "way_in");
  CHECK(read_mesh(outside / "way_in/mine.obj", problem, limits));
}

TEST_CASE("what a mesh names is not read outside the project either") {
  const Folder outside, project;
  const std::string secret = outside.write("secret", "newmtl a\n");
  const MeshLimits limits = within(project.string());
  const std::string why =
      "lies outside the folders of the scripts, of --style-path and of the library";
  CHECK(problem_of(project.write("a.obj", "mtllib " + secret + "\n" + triangle), limits) ==
        "'" + secret + "' can not be read: it " + why);
  project.write("a.mtl", "newmtl a\nmap_Kd " + secret + "\n");
  CHECK(problem_of(project.write("b.obj", "mtllib a.mtl\nusemtl a\n" + triangle), limits) ==
        "it has the picture '" + secret + "', which " + why);
  const std::string beside = "../" + fs::path(outside.string()).filename().string() + "/secret";
  CHECK(problem_of(project.write("c.gltf", gltf(R"([{"mesh":0}])", beside)), limits).find(why) !=
        std::string::npos);
  CHECK(!problem_of(project.write("d.gltf", gltf(R"([{"mesh":0}])", secret)), limits).empty());
}

TEST_CASE("devices, pipes and folders are no meshes, and do not stop us") {
  const Folder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  for (const char* const name : {"a.obj", "a.glb", "a.ply"}) {
    fs::create_symlink("/dev/zero", folder / name);
    CHECK(problem_of(folder / name) == "it is a device or a pipe");
    fs::remove(folder / name);
    fs::create_symlink("pipe", folder / name);
    CHECK(problem_of(folder / name) == "it is a device or a pipe");
    fs::remove(folder / name);
    fs::create_directory(folder / name);
    CHECK(problem_of(folder / name) == "it is a folder");
    fs::remove(folder / name);
  }
  CHECK(problem_of(folder.write("b.obj", "mtllib pipe\n" + triangle)) ==
        "'" + folder / "pipe" + "' can not be read: it is a device or a pipe");
  CHECK(problem_of(folder.write("c.obj", "mtllib /dev/zero\n" + triangle)) ==
        "'/dev/zero' can not be read: it is a device or a pipe");
  CHECK(problem_of(folder.write("d.gltf", gltf(R"([{"mesh":0}])", "pipe")))
            .find("is a device or a pipe") != std::string::npos);
}

TEST_CASE("a mesh of a gigabyte is refused before it is read") {
  const Folder folder;
  for (const char* const name : {"a.obj", "a.glb"}) {
    fs::resize_file(folder.write(name, ""), 1ull << 30);  // a hole, on disk nothing
    CHECK(problem_of(folder / name) ==
          "it has 1024 MB, and at most 256 MB are read: make it coarser");
  }
  CHECK(problem_of(folder.write("b.obj", "mtllib a.glb\n" + triangle)).find("1024 MB") !=
        std::string::npos);
}

TEST_CASE("numbers of meshes are bounded") {
  const Folder folder;
  CHECK(problem_of(folder.write("a.obj", "v 0 0 0\nv 2e9 0 0\nv 0 1 0\nf 1 2 3\n")) ==
        "it reaches further than a million km");
  CHECK(problem_of(folder.write("b.ply", ply("ascii", "3", "0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n")))
            .find("finite") != std::string::npos);
  for (const char* const corner : {"3", "99"}) {
    const std::string text = std::string("0 0 0\n1 0 0\n0 1 0\n3 0 1 ") + corner + "\n";
    CHECK(problem_of(folder.write("c.ply", ply("ascii", "3", text))) ==
          "it has a face of unknown vertices");
  }
  std::string face = "f";
  for (int i = 0; i < 20000; ++i) face += " 1 2 3";
  CHECK(problem_of(folder.write("d.obj", triangle + face + "\n")) ==
        "it has a face of 60000 corners, more than 10000");
}

TEST_CASE("a mesh without an extent along an axis is one, a line or a point is none") {
  const Folder folder;
  std::string problem;
  const auto flat = read_mesh(folder.write("a.obj", triangle), problem);
  REQUIRE(flat);
  CHECK(bounds(flat->points).size().z == 0);
  CHECK(problem_of(folder.write("b.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n")) ==
        "it has no faces with an area");
  CHECK(problem_of(folder.write("c.obj", "v 0 0 0\nf 1 1 1\n")) == "it has no faces with an area");
  CHECK(problem_of(folder.write("d.obj", "v 0 0 0\n")) == "it has no faces");
  CHECK(problem_of(folder.write("e.obj", "")) == "it has no faces");
}

TEST_CASE("nodes that contain themselves are a problem, not an end") {
  const Folder folder;
  for (const char* const nodes :
       {R"([{"mesh":0,"children":[0]}])", R"([{"children":[1]},{"mesh":0,"children":[0]}])"}) {
    const std::string problem = problem_of(folder.write("a.gltf", gltf(nodes, in_place)));
    CAPTURE(problem);
    CHECK(!problem.empty());
  }
  std::string deep;
  for (int i = 0; i < 200000; ++i) deep += "<node>";
  std::string many = collada;
  many.replace(many.find("<node id=\"n\">"), 0, deep);
  CHECK(!problem_of(folder.write("deep.dae", many)).empty());
}

TEST_CASE("a reader that takes too much is stopped") {
  const Folder folder;
#ifndef __SANITIZE_ADDRESS__
  MeshLimits little;
  little.memory = 400;
  CHECK(problem_of(folder.write("a.ply", ply("ascii", "60000000", "0 0 0\n")), little) ==
        "it needs more than 400 MB of memory");
#endif
  MeshLimits quick;
  quick.seconds = 0.02;
  std::string points;
  constexpr int count = 400000;
  for (int i = 0; i < count; ++i) points += "0.25 0.5 0.75\n";
  CHECK(problem_of(folder.write("b.ply", ply("ascii", std::to_string(count), points + "3 0 1 2\n")),
                   quick) == "it takes more than 0.02 seconds to read");
}

TEST_CASE("bytes of a mesh come back, and none but whole ones") {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}};
  mesh.add_face(std::array<uint32_t, 3>{0, 1, 2}, {}, 1);
  mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
  mesh.materials = {{"red", {1, 0, 0}, 0.5, "red.png", {}, true},
                    {"own", {1, 1, 1}, 1, {}, "bytes of a picture"}};
  const std::string bytes = to_bytes(mesh);
  std::string problem;
  const auto back = mesh_from_bytes(bytes, problem);
  REQUIRE(back);
  CHECK(to_bytes(*back) == bytes);
  CHECK(back->materials[0].texture == "red.png");
  CHECK(back->materials[0].overlay);
  CHECK(back->materials[1].picture == "bytes of a picture");
  const std::string without = bytes.substr(0, to_bytes([&] {
                                                Mesh bare = mesh;
                                                bare.materials.clear();
                                                return bare;
                                              }())
                                                  .size());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    if (length != without.size() && mesh_from_bytes(bytes.substr(0, length), problem)) {
      CHECK(mesh_from_bytes(bytes.substr(0, length), problem)->materials.size() == 1);
    }
  }
  CHECK(!mesh_from_bytes(to_bytes("no"), problem));
  CHECK(problem == "no");
  mesh.corners[1] = 7;
  CHECK(!mesh_from_bytes(to_bytes(mesh), problem));
}

TEST_CASE("files cut off or damaged anywhere are a mesh or a problem") {
  const Folder folder;
  const std::vector<std::pair<std::string, std::string>> sound{
      {"a.gltf", gltf(R"([{"mesh":0,"scale":[2,1,1]}])", in_place)},
      {"a.dae", collada},
      {"a.ply", ply("ascii", "3", "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")},
      {"a.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
       "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n"},
      {"a.obj", "mtllib a.mtl\nusemtl a\n" + triangle}};
  std::mt19937 random(11);
  MeshLimits limits;
  limits.seconds = 0.1;  // Assimp runs on and on over some of these
  int meshes = 0, problems = 0;
  const auto tried = [&](const std::string& path) {
    std::string problem;
    const auto mesh = read_mesh(path, problem, limits);
    CHECK(mesh.has_value() == problem.empty());
    if (mesh) {
      CHECK(
          std::ranges::all_of(mesh->points, [](Vec3 p) { return std::isfinite(p.x + p.y + p.z); }));
    }
    ++(mesh ? meshes : problems);
  };
  for (const auto& [name, text] : sound) {
    CAPTURE(name);
    tried(folder.write(name, text));
    for (int i = 0; i < 16; ++i) {
      std::string damaged = text;
      for (auto times = 1 + random() % 3; times > 0; --times) {
        const std::size_t at = random() % damaged.size();
        const auto byte = static_cast<char>(random() % 256);
        if (random() % 3 == 0) damaged.resize(at + 1);
        damaged[at] = random() % 2 == 0 ? byte : static_cast<char>('0' + random() % 10);
      }
      tried(folder.write(name, damaged));
    }
  }
  CHECK(meshes >= 10);
  CHECK(problems >= 30);
}
