#include "formats/assimp_reader.hpp"

#include <assimp/GltfMaterial.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/DefaultIOSystem.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <new>

#include "formats/color.hpp"

namespace mansard {
namespace {

namespace fs = std::filesystem;

/// Opens what the limits allow: a file names others, and those may be anything.
class AllowedFiles final : public Assimp::DefaultIOSystem {
 public:
  explicit AllowedFiles(const MeshLimits& limits) : limits_(limits) {}
  bool Exists(const char* path) const override { return refusal(path, limits_).empty(); }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    const std::string why = refusal(path, limits_);
    if (why.empty() && std::string_view(mode).find_first_of("wa+") == std::string_view::npos)
      return Assimp::DefaultIOSystem::Open(path, mode);
    if (problem.empty() && !why.empty() && why != "no such file")
      problem = "it names '" + std::string(path) + "', which " + why;
    return nullptr;
  }
  std::string problem;  ///< the first

 private:
  const MeshLimits& limits_;
};

/// COLLADA and FBX know no colour space and are written in sRGB; glTF's factors are linear.
bool is_linear(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending == ".gltf" || ending == ".glb";
}

/// The bytes of a picture that the file itself holds; empty where it names another file.
std::string own_picture(const aiScene& scene, const char* name) {
  const aiTexture* const picture = scene.GetEmbeddedTexture(name);
  if (picture == nullptr || picture->mHeight != 0) return {};  // pixels: of no format that we read
  return {reinterpret_cast<const char*>(picture->pcData), picture->mWidth};
}

/// A coloured picture that is blended over what lies behind it: what we write stains as.
bool is_overlay(const aiMaterial& from, const Mesh::Material& to) {
  aiString mode;
  if (to.picture.empty() && to.texture.empty()) return false;
  return from.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS &&
         std::string_view(mode.C_Str()) == "BLEND" && to.opacity == 1 && to.color != Vec3{1, 1, 1};
}

Mesh::Material convert(const aiScene& scene, const aiMaterial& from, const std::string& path,
                       const MeshLimits& limits, std::string& problem) {
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
    to.picture = own_picture(scene, text.C_Str());
    std::replace(name.begin(), name.end(), '\\', '/');
    if (to.picture.empty())
      to.texture = named_picture(fs::path(path).parent_path(), name, limits, problem);
    to.overlay = is_overlay(from, to);
  }
  return to;
}

class Collected {
 public:
  Collected(const aiScene& scene, Mesh& mesh) : scene_(scene), mesh_(mesh) {
    mesh_.clear();
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      has_uvs_ = has_uvs_ || scene.mMeshes[i]->HasTextureCoords(0);
    }
  }
  bool is_sound() const { return sound_; }
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
    const auto known = [&](unsigned at) { return at < part.mNumVertices; };
    if (!std::all_of(face.mIndices, face.mIndices + face.mNumIndices, known)) {
      sound_ = false;
      return;
    }
    const auto begin = static_cast<uint32_t>(mesh_.corners.size());
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      const unsigned at = face.mIndices[mirrored ? face.mNumIndices - 1 - i : i];
      mesh_.corners.push_back(base + at);
      if (!has_uvs_) continue;
      mesh_.uvs.push_back(part.HasTextureCoords(0)
                              ? Vec2{part.mTextureCoords[0][at].x, part.mTextureCoords[0][at].y}
                              : Vec2{});
    }
    mesh_.faces.push_back(
        {begin, static_cast<uint32_t>(mesh_.corners.size()), {}, part.mMaterialIndex});
  }

  const aiScene& scene_;
  Mesh& mesh_;
  bool has_uvs_ = false, sound_ = true;
};

}  // namespace

bool read_by_assimp(const std::string& path, const MeshLimits& limits, Mesh& mesh,
                    std::string& problem) {
  Assimp::Importer importer;
  auto* const files = new AllowedFiles(limits);
  importer.SetIOHandler(files);  // which owns it
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_LINE | aiPrimitiveType_POINT);
  const aiScene* scene = importer.ReadFile(path, aiProcess_SortByPType);
  problem = files->problem;
  if (!problem.empty()) return false;
  if (scene == nullptr || scene->mRootNode == nullptr) {
    problem = importer.GetErrorString();
    if (problem == "std::bad_alloc") throw std::bad_alloc();
    return false;
  }
  Collected collected(*scene, mesh);
  collected.add(*scene->mRootNode, aiMatrix4x4());
  for (unsigned i = 0; i < scene->mNumMaterials; ++i) {
    mesh.materials.push_back(convert(*scene, *scene->mMaterials[i], path, limits, problem));
  }
  if (!collected.is_sound()) problem = "it has a face of unknown vertices";
  if (mesh.faces.empty() && problem.empty()) problem = "it has no faces";
  return problem.empty();
}

}  // namespace mansard
