// What glTF shares, and instances of EXT_mesh_gpu_instancing put together as a client would.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "glb.hpp"
#include "support.hpp"

using namespace mansard;
using namespace mansard::test;

namespace {

/// As rules draw it: nobody's mesh, seen from the frame of its scope.
void place_solid(Surface& s, const Mesh& mesh, const Surface::Placed& at, uint32_t symbol) {
  place(s, mesh, at, symbol);
  s.placed.back().mesh = nullptr;
}

Surface::Placed somewhere(std::mt19937& random) {
  std::uniform_real_distribution<double> at(-20, 20), size(0.5, 3);
  const Vec3 x = normalized(Vec3{at(random), at(random), at(random)});
  const Vec3 y = normalized(cross(x, Vec3{at(random), at(random), at(random)}));
  return {nullptr,     {at(random), at(random), at(random)},      x, y,
          cross(x, y), {size(random), size(random), size(random)}};
}

Glb written(const Folder& folder, const std::string& name, const std::vector<Surface>& houses,
            const GltfOptions& options) {
  const auto writer = write_gltf(folder / name, "", options);
  for (std::size_t i = 0; i < houses.size(); ++i)
    writer->add({"house " + std::to_string(i), &houses[i]}, symbols, looks);
  writer->finish(looks);
  return read_glb(folder / name);
}

Vec3 rotated(const std::array<float, 4>& q, Vec3 v) {
  const Vec3 axis{q[0], q[1], q[2]};
  const Vec3 t = cross(axis, v) * 2;
  return v + t * double(q[3]) + cross(axis, t);
}

/// Area and weighted centre of all triangles of a node's mesh, at each of its places.
void add_moments(const Glb& glb, const json& node, Vec3 origin, Moments& sum) {
  std::vector<std::array<float, 3>> translations{{0, 0, 0}}, scales{{1, 1, 1}};
  std::vector<std::array<float, 4>> rotations{{0, 0, 0, 1}};
  if (node.contains("extensions")) {
    const json& attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    translations = items<float, 3>(glb, attributes["TRANSLATION"]);
    rotations = items<float, 4>(glb, attributes["ROTATION"]);
    scales = items<float, 3>(glb, attributes["SCALE"]);
    REQUIRE(translations.size() > 1);
    REQUIRE(rotations.size() == translations.size());
    REQUIRE(scales.size() == translations.size());
  } else if (node.contains("scale")) {
    node["translation"].get_to(translations[0]);
    node["rotation"].get_to(rotations[0]);
    node["scale"].get_to(scales[0]);
  }
  if (!node.contains("mesh")) return;
  for (const json& primitive : glb.document["meshes"][node["mesh"].get<int>()]["primitives"]) {
    const auto points = items<float, 3>(glb, primitive["attributes"]["POSITION"]);
    const auto indices = indices_of(glb, primitive["indices"]);
    for (std::size_t i = 0; i < translations.size(); ++i) {
      const auto at = [&](uint32_t k) {
        const auto &p = points[k], &s = scales[i], &t = translations[i];
        return origin + Vec3{t[0], t[1], t[2]} +
               rotated(rotations[i], {p[0] * s[0], p[1] * s[1], p[2] * s[2]});
      };
      for (std::size_t k = 0; k < indices.size(); k += 3) {
        const Vec3 a = at(indices[k]), b = at(indices[k + 1]), c = at(indices[k + 2]);
        const double area = length(cross(b - a, c - a)) / 2;
        ++sum.triangles;
        sum.area += area;
        sum.centre = sum.centre + (a + b + c) * (area / 3);
      }
    }
  }
}

Moments moments_of(const Glb& glb) {
  Moments sum;
  const json& nodes = glb.document["nodes"];
  for (const json& root : glb.document["scenes"][0]["nodes"]) {
    const json& building = nodes[root.get<int>()];
    Vec3 origin;
    if (building.contains("translation"))
      origin = {building["translation"][0], building["translation"][1], building["translation"][2]};
    for (const json& child : building["children"]) {
      const json& symbol = nodes[child.get<int>()];
      add_moments(glb, symbol, origin, sum);
      if (!symbol.contains("children")) continue;
      for (const json& placed : symbol["children"])
        add_moments(glb, nodes[placed.get<int>()], origin, sum);
    }
  }
  return sum;
}

void check_same(const Moments& a, const Moments& b) {
  CHECK(a.triangles == b.triangles);
  CHECK(a.area == doctest::Approx(b.area).epsilon(1e-5));
  CHECK(length(a.centre - b.centre) < 1e-4 * b.area);
}

}  // namespace

TEST_CASE("instances on the graphics card stand where they were drawn, and say what they are") {
  const Folder folder;
  const Mesh mesh = stool();
  std::mt19937 random(11);
  std::vector<Surface> houses(2);
  for (int i = 0; i < 200; ++i) place(houses[0], mesh, somewhere(random), i % 2);
  place(houses[1], mesh, somewhere(random), 1);  // one is a node
  const Glb plain = written(folder, "plain.glb", houses, {.instancing = Instancing::copies});
  CHECK_FALSE(plain.document.contains("extensionsUsed"));
  for (const bool draco : {false, true}) {
    CAPTURE(draco);
    const Glb gpu =
        written(folder, "gpu.glb", houses, {.instancing = Instancing::gpu, .draco = draco});
    const json& d = gpu.document;
    CHECK(d["extensionsRequired"][0] == "EXT_mesh_gpu_instancing");
    CHECK(d["extensionsUsed"] == d["extensionsRequired"]);
    // house, symbol, instances of each of two symbols; house, symbol, the only stool
    CHECK(d["nodes"].size() == 5 + 3);
    CHECK(d["meshes"].size() == 1);
    std::size_t instanced = 0;
    for (const json& node : d["nodes"]) {
      if (!node.contains("extensions")) continue;
      ++instanced;
      CHECK(node["extras"]["symbol"] == node["name"]);
      const json& all = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
      CHECK(d["accessors"][all["ROTATION"].get<int>()]["count"] == 100);
    }
    CHECK(instanced == 2);
    if (!draco) check_same(moments_of(gpu), moments_of(plain));
  }
}

TEST_CASE("solids that rules made are shared when they come twice and it pays") {
  const Folder folder;
  const Mesh mesh = stool();  // 18 polygons
  std::mt19937 random(13);
  std::vector<Surface> houses(2);
  for (int i = 0; i < 20; ++i) place_solid(houses[0], mesh, somewhere(random), 0);
  place_solid(houses[1], mesh, somewhere(random), 1);  // known by then
  for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    Mesh other = mesh;
    other.points[3].*axis += 0.1;
    place_solid(houses[0], other, somewhere(random), 2);  // alone of its kind
  }
  place_solid(houses[0], mesh, somewhere(random), 2);
  for (std::size_t i = 0; i < mesh.faces.size(); ++i)
    houses[0].runs.rbegin()[static_cast<std::ptrdiff_t>(i)].material = 0;  // the only one of one
  const Glb plain = written(folder, "plain.glb", houses, {.instancing = Instancing::copies});
  const Glb shared = written(folder, "shared.glb", houses, {});
  CHECK(shared.document["meshes"].size() == 2);
  CHECK(shared.document["nodes"].size() == 2 + 3 + 21);
  check_same(moments_of(shared), moments_of(plain));
  const Glb gpu = written(folder, "gpu.glb", houses, {.instancing = Instancing::gpu});
  CHECK(gpu.document["nodes"].size() == 2 + 3 + 2);
  check_same(moments_of(gpu), moments_of(plain));
}

TEST_CASE("boxes are instances on the graphics card, but no nodes") {
  const Folder folder;
  Mesh box = stool();
  box.faces.resize(6);
  std::mt19937 random(17);
  std::vector<Surface> houses(1);
  for (int i = 0; i < 50; ++i) place_solid(houses[0], box, somewhere(random), 0);
  const Glb nodes = written(folder, "nodes.glb", houses, {});
  CHECK(nodes.document["nodes"].size() == 2);
  const Glb gpu = written(folder, "gpu.glb", houses, {.instancing = Instancing::gpu});
  CHECK(gpu.document["nodes"].size() == 3);
  check_same(moments_of(gpu), moments_of(nodes));
  CHECK(std::filesystem::file_size(folder / "gpu.glb") * 4 <
        std::filesystem::file_size(folder / "nodes.glb"));
}

TEST_CASE("what is flat is drawn, but no instance: it has no frame to stand in") {
  const Folder folder;
  const Mesh mesh = stool();
  std::vector<Surface> houses(1);
  for (int i = 0; i < 2; ++i) {
    const Surface::Placed flat{nullptr,   {3.0 * i, 0, 0}, {1, 0, 0},
                               {0, 1, 0}, {0, 0, 1},       {1, 2, 0}};
    place_solid(houses[0], mesh, flat, 0);
  }
  const Glb plain = written(folder, "plain.glb", houses, {.instancing = Instancing::copies});
  for (const Instancing instancing : {Instancing::nodes, Instancing::gpu}) {
    const Glb flat = written(folder, "flat.glb", houses, {.instancing = instancing});
    CHECK(flat.document["nodes"].size() == 2);
    check_same(moments_of(flat), moments_of(plain));
  }
}
