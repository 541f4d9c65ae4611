#include "formats/assimp_module.hpp"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "formats/color.hpp"

namespace mansard {
namespace {

namespace fs = std::filesystem;

/// COLLADA and FBX know no colour space and are written in sRGB; glTF's factors are linear.
bool is_linear(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending == ".gltf" || ending == ".glb";
}

Mesh::Material convert(const aiMaterial& from, const std::string& path) {
  Mesh::Material to;
  aiString text;
  if (from.Get(AI_MATKEY_NAME, text) == aiReturn_SUCCESS) to.name = text.C_Str();
  aiColor4D color(0.8f, 0.8f, 0.8f, 1);
  if (from.Get(AI_MATKEY_BASE_COLOR, color) != aiReturn_SUCCESS) {
    from.Get(AI_MATKEY_COLOR_DIFFUSE, color);
  }
  to.color = {color.r, color.g, color.b};
  if (!is_linear(path)) to.color = {to_linear(color.r), to_linear(color.g), to_linear(color.b)};
  float opacity = 1;
  from.Get(AI_MATKEY_OPACITY, opacity);
  to.opacity = std::clamp<double>(std::min(opacity, color.a), 0, 1);
  if (from.GetTexture(aiTextureType_BASE_COLOR, 0, &text) == aiReturn_SUCCESS ||
      from.GetTexture(aiTextureType_DIFFUSE, 0, &text) == aiReturn_SUCCESS) {
    std::string name = text.C_Str();
    std::replace(name.begin(), name.end(), '\\', '/');
    const fs::path texture = fs::path(path).parent_path() / name;
    std::error_code ignored;
    if (fs::is_regular_file(texture, ignored)) to.texture = texture.string();
  }
  return to;
}

class Collected {
 public:
  Collected(const aiScene& scene, Mesh& mesh) : scene_(scene), mesh_(mesh) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      has_uvs_ = has_uvs_ || scene.mMeshes[i]->HasTextureCoords(0);
    }
  }
  void add(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 transform = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], transform);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], transform);
  }

 private:
  void add(const aiMesh& part, const aiMatrix4x4& transform) {
    const auto base = static_cast<uint32_t>(mesh_.points.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D p = transform * part.mVertices[i];
      mesh_.points.push_back({p.x, p.y, p.z});
    }
    const bool mirrored = transform.Determinant() < 0;
    for (unsigned f = 0; f < part.mNumFaces; ++f) add(part, part.mFaces[f], base, mirrored);
  }
  void add(const aiMesh& part, const aiFace& face, uint32_t base, bool mirrored) {
    if (face.mNumIndices < 3) return;
    const auto begin = static_cast<uint32_t>(mesh_.corners.size());
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      const unsigned at = face.mIndices[mirrored ? face.mNumIndices - 1 - i : i];
      mesh_.corners.push_back(base + at);
      if (!has_uvs_) continue;
      const bool known = part.HasTextureCoords(0);
      mesh_.uvs.push_back(known ? Vec2{part.mTextureCoords[0][at].x, part.mTextureCoords[0][at].y}
                                : Vec2{});
    }
    mesh_.faces.push_back(
        {begin, static_cast<uint32_t>(mesh_.corners.size()), {}, part.mMaterialIndex});
  }

  const aiScene& scene_;
  Mesh& mesh_;
  bool has_uvs_ = false;
};

}  // namespace
}  // namespace mansard

extern "C" bool mansard_read_mesh(const char* path, mansard::Mesh& mesh, std::string& problem) try {
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_LINE | aiPrimitiveType_POINT);
  const aiScene* scene = importer.ReadFile(path, aiProcess_SortByPType);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    problem = importer.GetErrorString();
    return false;
  }
  mansard::Collected(*scene, mesh).add(*scene->mRootNode, aiMatrix4x4());
  for (unsigned i = 0; i < scene->mNumMaterials; ++i) {
    mesh.materials.push_back(mansard::convert(*scene->mMaterials[i], path));
  }
  const bool finite = std::all_of(mesh.points.begin(), mesh.points.end(),
                                  [](mansard::Vec3 p) { return std::isfinite(p.x + p.y + p.z); });
  if (!finite) problem = "has a vertex that is not finite";
  if (mesh.faces.empty()) problem = "has no faces";
  return finite && !mesh.faces.empty();
} catch (const std::exception& e) {
  problem = e.what();
  return false;
}
