// What is written loads in libraries that are not ours, with the counts of the report. Real towns
// (../shared/data beside the project, not part of it); their first 40 buildings;
// MANSARD_LONG_TESTS=1 takes all of all four.
#include <assimp/scene.h>
#include <doctest/doctest.h>
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <assimp/Importer.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/cli/run.hpp"

namespace {

using namespace mansard::test;
using nlohmann::json;

const std::string root = MANSARD_ROOT;

void check_model(const std::string& footprints, const char* limit = "1000000") {
  CAPTURE(footprints);
  const TemporaryFolder folder;
  const std::string model = folder / "model.obj";
  const Run derive =
      run({"derive", root + "/examples/quarter/quarter.style", footprints, "--keep-going",
           "--limit", limit, "--quiet", "-o", model, "--report", folder / "report.json"});
  REQUIRE_MESSAGE(derive.status <= 1, derive.err);
  const json report = json::parse(contents(folder / "report.json"));
  CHECK(report["buildings"] > 0);
  CHECK(report["failed"].size() * 100 <= report["buildings"].get<std::size_t>());

  tinyobj::attrib_t points;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  REQUIRE(tinyobj::LoadObj(&points, &shapes, &materials, &warning, &error, model.c_str(),
                           (folder.path().string() + "/").c_str(), false));
  CHECK(error.empty());
  CHECK(warning.empty());
  std::size_t polygons = 0, corners = 0;
  for (const tinyobj::shape_t& shape : shapes) {
    polygons += shape.mesh.num_face_vertices.size();
    corners += shape.mesh.indices.size();
  }
  CHECK(polygons == report["polygons"]);
  CHECK(corners == report["vertices"]);

  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(model, 0);
  REQUIRE_MESSAGE(scene, importer.GetErrorString());
  std::size_t faces = 0;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) faces += scene->mMeshes[i]->mNumFaces;
  CHECK(faces == report["polygons"]);
}

void check_town(const std::string& name) {
  const std::string path = root + "/../shared/data/" + name + ".osm.pbf";
  if (!std::filesystem::exists(path)) {
    MESSAGE(path, " is missing: not tested");
    return;
  }
  // Assimp takes its time over millions of polygons.
  check_model(path, std::getenv("MANSARD_LONG_TESTS") ? "1000000" : "40");
}

}  // namespace

TEST_CASE("the quarter loads elsewhere") {
  check_model(root + "/examples/quarter/footprints.geojson");
}
TEST_CASE("Monaco loads elsewhere") { check_town("monaco"); }
TEST_CASE("Helsinki loads elsewhere") { check_town("helsinki"); }
TEST_CASE("other towns load elsewhere") {
  if (!std::getenv("MANSARD_LONG_TESTS")) return;
  check_town("baltimore");
  check_town("liechtenstein");
}
