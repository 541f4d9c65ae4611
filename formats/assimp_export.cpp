#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <memory>

#include "formats/assimp_export.hpp"

namespace mansard {
namespace {

aiVector3D* vectors_of(std::span<const float> values) {
  auto* const all = new aiVector3D[values.size() / 3];
  for (std::size_t i = 0; i < values.size(); i += 3)
    all[i / 3] = {values[i], values[i + 1], values[i + 2]};
  return all;
}

/// Its destructor frees all of it.
std::unique_ptr<aiScene> scene_of(const Triangles& triangles) {
  auto scene = std::make_unique<aiScene>();
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  scene->mNumMaterials = 1;
  auto* const mesh = new aiMesh;
  scene->mMeshes = new aiMesh* [1] { mesh };
  scene->mNumMeshes = 1;
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mVertices = vectors_of(triangles.positions);
  mesh->mNormals = vectors_of(triangles.normals);
  mesh->mNumVertices = static_cast<unsigned>(triangles.positions.size() / 3);
  mesh->mNumFaces = static_cast<unsigned>(triangles.indices.size() / 3);
  mesh->mFaces = new aiFace[mesh->mNumFaces];
  for (unsigned f = 0; f < mesh->mNumFaces; ++f) {
    mesh->mFaces[f].mIndices = new unsigned[3];
    mesh->mFaces[f].mNumIndices = 3;
    std::copy_n(triangles.indices.begin() + 3 * std::ptrdiff_t(f), 3, mesh->mFaces[f].mIndices);
  }
  scene->mRootNode = new aiNode;
  scene->mRootNode->mMeshes = new unsigned[1]{0};
  scene->mRootNode->mNumMeshes = 1;
  return scene;
}

}  // namespace
}  // namespace mansard

extern "C" bool mansard_write_mesh(const char* format, const mansard::Triangles& triangles,
                                   std::string& bytes, std::string& problem) try {
  const auto scene = mansard::scene_of(triangles);
  Assimp::Exporter exporter;
  const aiExportDataBlob* const blob = exporter.ExportToBlob(scene.get(), format);
  if (blob == nullptr) {
    problem = exporter.GetErrorString();
    return false;
  }
  bytes.assign(static_cast<const char*>(blob->data), blob->size);
  return true;
} catch (const std::exception& e) {
  problem = e.what();
  return false;
}
