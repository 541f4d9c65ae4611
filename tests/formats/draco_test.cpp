// Compressed glTF, as Assimp's own Draco decoder reads it.
#include <algorithm>
#include <filesystem>

#include "glb.hpp"
#include "support.hpp"

using namespace mansard;
using namespace mansard::test;

TEST_CASE("what Draco compressed has the same triangles, and far fewer bytes") {
  const Folder folder;
  const std::vector<Look> textured{
      looks[0], {"brick", {1, 1, 1}, 1, folder.write("brick.png", "\x89PNG\r\n\x1a\nand so on")}};
  const Mesh mesh = stool();
  Surface s;
  for (int i = 0; i < 400; ++i) {  // a facade of tilted shingles, and stools before it
    const double x = 1.5 * (i % 40), y = 1.5 * (i / 40);
    add_polygon(s, {{x, y, 0}, {x + 1, y, 0.25}, {x + 1, y + 1, 0.25}, {x, y + 1, 0}}, 0, i % 2);
    if (i % 10 == 0)
      place(s, mesh, {nullptr, {x, y, 2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 1}}, 1);
  }
  const auto write = [&](const std::string& name, bool draco) {
    const auto writer = write_gltf(folder / name, "", {.draco = draco});
    writer->add({"a", &s}, symbols, textured);
    CHECK(writer->finish(textured) > 0);
    return moments_of(folder / name);
  };
  const Moments plain = write("plain.glb", false);
  for (const char* const name : {"small.glb", "small.gltf"}) {
    CAPTURE(name);
    const Moments small = write(name, true);
    CHECK(small.triangles == plain.triangles);
    CHECK(small.area == doctest::Approx(plain.area).epsilon(1e-4));
    CHECK(length(small.centre - plain.centre) < 2e-4 * plain.area);
    CHECK(length(small.flux - plain.flux) < 1e-3 * length(plain.flux));
    CHECK(small.facing == doctest::Approx(plain.area).epsilon(1e-4));
    CHECK(length(plain.uv) > 0.1 * plain.area);
    CHECK(length(small.uv - plain.uv) < 1e-4 * plain.area);
  }
  CHECK(std::filesystem::file_size(folder / "small.glb") * 2 <
        std::filesystem::file_size(folder / "plain.glb"));
  const json d = read_glb(folder / "small.glb").document;
  CHECK(d["extensionsRequired"] == json{"KHR_draco_mesh_compression"});
  for (const json& accessor : d["accessors"]) CHECK_FALSE(accessor.contains("bufferView"));
  CHECK(d["images"][0]["bufferView"] == d["bufferViews"].size() - 1);
}

namespace {

/// Two walls that share an edge at x = 7.7771, each its own part, and one that stands `away` from
/// the first: how far apart the parts' corners at that edge are.
double gap(const Folder& folder, double away) {
  Surface s;
  add_polygon(s, {{-away, 0, 0}, {1 - away, 0, 0}, {1 - away, 3, 0}}, 0, 0);
  add_polygon(s, {{0.0317, 0, 0}, {7.7771, 0, 0}, {7.7771, 3.1415, 0}, {0.0317, 3.1415, 0}}, 0, 0);
  add_polygon(s, {{7.7771, 0, 0}, {7.7771, 0, -9}, {7.7771, 3.1415, -9}, {7.7771, 3.1415, 0}}, 1,
              0);
  const auto writer = write_gltf(folder / "walls.glb", "", {.draco = true});
  writer->add({"a", &s}, symbols, looks);
  writer->finish(looks);
  std::vector<double> edges;
  for (const Vec3 p : points_of(folder / "walls.glb")) {
    double nearest = 1e9;
    for (const Vec3 q : s.points) nearest = std::min(nearest, length(p - q));
    CHECK(nearest < 2e-4);
    if (std::abs(p.x - 7.7771) < 0.01) edges.push_back(p.x);
  }
  REQUIRE(edges.size() == 6);
  const auto [least, most] = std::ranges::minmax(edges);
  return most - least;
}

}  // namespace

TEST_CASE("no gaps open between compressed parts, and large ones are as exact as small ones") {
  const Folder folder;
  CHECK(gap(folder, 31.43) < 1e-6);
  CHECK(gap(folder, 300) < 1.3e-4);  // as near as Draco's single precision comes
}
