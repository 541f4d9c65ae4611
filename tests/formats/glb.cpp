#include "glb.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>

#include "support.hpp"

namespace mansard::test {

const std::vector<std::string_view> symbols{"WALL", "WINDOW", "a \"roof\""};

const std::vector<Look> looks{{"brick", {0.5, 0.25, 0.1}, 1, ""},
                              {"glass", {0.1, 0.2, 0.3}, 0.5, ""},
                              {"unused", {1, 0, 0}, 1, ""}};

void add_polygon(Surface& s, const std::vector<Vec3>& loop, uint32_t symbol, uint32_t look) {
  for (const Vec3 p : loop) {
    s.points.push_back(p);
    s.uvs.push_back({p.x, p.y});
  }
  s.ends.push_back(static_cast<uint32_t>(s.points.size()));
  s.normals.push_back(normalized(newell(loop)));
  s.runs.push_back({symbol, look, static_cast<uint32_t>(s.ends.size())});
}

Surface random_surface(std::mt19937& random, int polygons) {
  std::uniform_real_distribution<double> at(-500, 500), radius(0.1, 20);
  Surface s;
  for (int i = 0; i < polygons; ++i) {
    const Vec3 center{at(random), at(random), at(random)};
    const Vec3 u = normalized(Vec3{at(random), at(random), at(random)});
    const Vec3 v = normalized(cross(u, Vec3{at(random), at(random), at(random)}));
    const int corners = 3 + static_cast<int>(random() % 6);
    const double r = radius(random);
    std::vector<Vec3> loop;
    for (int c = 0; c < corners; ++c) {
      const double a = 6.283185307179586 * c / corners;
      const double out = corners > 4 && i % 3 == 0 && c == 1 ? 0.2 * r : r;
      loop.push_back(center + u * (out * std::cos(a)) + v * (out * std::sin(a)));
    }
    add_polygon(s, loop, random() % 3, random() % 2);
  }
  return s;
}

double area_of(const Surface& s) {
  double sum = 0;
  for (std::size_t i = 0; i < s.polygons(); ++i) sum += length(newell(s.loop(i))) / 2;
  return sum;
}

Mesh stool() {
  Mesh mesh;
  const auto box = [&](Vec3 low, Vec3 high) {
    const auto first = static_cast<uint32_t>(mesh.points.size());
    for (int i = 0; i < 8; ++i)
      mesh.points.push_back(
          {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    for (const std::array<uint32_t, 4>& face : std::array<std::array<uint32_t, 4>, 6>{
             {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}})
      mesh.add_face(std::array{first + face[0], first + face[1], first + face[2], first + face[3]});
  };
  box({0, 1, 0}, {2, 1.2, 1});
  box({0, 0, 0}, {0.2, 1, 1});
  box({1.8, 0, 0.5}, {2, 1, 1});
  return mesh;
}

void place(Surface& s, const Mesh& mesh, const Surface::Placed& at, uint32_t symbol) {
  Surface::Placed placed = at;
  placed.mesh = &mesh;
  placed.begin = static_cast<uint32_t>(s.polygons());
  for (const Mesh::Face& face : mesh.faces) {
    std::vector<Vec3> loop;
    for (const uint32_t corner : mesh.loop(face)) {
      const Vec3 p = mesh.points[corner];
      loop.push_back(at.origin + at.x * (at.scale.x * p.x) + at.y * (at.scale.y * p.y) +
                     at.z * (at.scale.z * p.z));
    }
    if (dot(cross(at.x, at.y), at.z) < 0) std::ranges::reverse(loop);
    add_polygon(s, loop, symbol, placed.begin % 2);
    s.runs.back().material = face.begin < 24 ? 0 : 1;
  }
  placed.end = static_cast<uint32_t>(s.polygons());
  s.placed.push_back(placed);
}

namespace {

uint32_t number_at(const std::string& bytes, std::size_t at) {
  uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

}  // namespace

Glb read_glb(const std::string& path) {
  const std::string file = content(path);
  REQUIRE(file.size() >= 20);
  CHECK(file.starts_with("glTF"));
  CHECK(number_at(file, 4) == 2);
  CHECK(number_at(file, 8) == file.size());
  const uint32_t length = number_at(file, 12);
  CHECK(length % 4 == 0);
  CHECK(file.substr(16, 4) == "JSON");
  Glb glb{json::parse(file.substr(20, length)), {}};
  if (file.size() == 20 + length) return glb;
  CHECK(number_at(file, 20 + length) % 4 == 0);
  CHECK(file.substr(24 + length, 4) == std::string("BIN\0", 4));
  glb.binary = file.substr(28 + length);
  CHECK(glb.binary.size() == number_at(file, 20 + length));
  return glb;
}

std::vector<uint32_t> indices_of(const Glb& glb, std::size_t accessor) {
  std::vector<uint32_t> all;
  if (glb.document["accessors"][accessor]["componentType"] == 5123) {
    for (const auto i : items<uint16_t, 1>(glb, accessor)) all.push_back(i[0]);
  } else {
    for (const auto i : items<uint32_t, 1>(glb, accessor)) all.push_back(i[0]);
  }
  return all;
}

Moments moments_of(const std::string& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, aiProcess_PreTransformVertices);
  REQUIRE_MESSAGE(scene, importer.GetErrorString());
  Moments m;
  for (unsigned k = 0; k < scene->mNumMeshes; ++k) {
    const aiMesh& mesh = *scene->mMeshes[k];
    m.triangles += mesh.mNumFaces;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      std::array<Vec3, 3> p;
      for (std::size_t i = 0; i < 3; ++i) {
        const aiVector3D v = mesh.mVertices[mesh.mFaces[f].mIndices[i]];
        p[i] = {v.x, v.y, v.z};
      }
      const Vec3 twice = cross(p[1] - p[0], p[2] - p[0]), middle = (p[0] + p[1] + p[2]) * (1.0 / 3);
      m.area += length(twice) / 2;
      m.centre = m.centre + middle * (length(twice) / 2);
      m.flux = m.flux + Vec3{twice.x * middle.x, twice.y * middle.y, twice.z * middle.z};
      for (std::size_t i = 0; i < 3; ++i) {
        const unsigned at = mesh.mFaces[f].mIndices[i];
        if (mesh.HasNormals()) {
          const aiVector3D n = mesh.mNormals[at];
          m.facing += dot(twice, {n.x, n.y, n.z}) / 6;
        }
        if (mesh.HasTextureCoords(0)) {
          const aiVector3D uv = mesh.mTextureCoords[0][at];
          m.uv = m.uv + Vec2{uv.x, uv.y} * (length(twice) / 6);
        }
      }
    }
  }
  return m;
}

std::vector<Vec3> points_of(const std::string& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, aiProcess_PreTransformVertices);
  REQUIRE_MESSAGE(scene, importer.GetErrorString());
  std::vector<Vec3> points;
  for (unsigned k = 0; k < scene->mNumMeshes; ++k) {
    const aiMesh& mesh = *scene->mMeshes[k];
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
      points.push_back({mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z});
  }
  return points;
}

}  // namespace mansard::test
