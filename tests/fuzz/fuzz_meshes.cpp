// Any bytes as a mesh: a sound one, or a few words about them. What Assimp reads is read in another
// process (formats/mesh_process.hpp); here it is the bytes that come back from there.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "formats/mesh_stream.hpp"
#include "formats/meshes.hpp"
#include "formats/obj_reader.hpp"

namespace {

using namespace mansard;

void check(std::optional<Mesh> read, std::string problem) {
  const std::optional<Mesh> mesh = read ? tidied(*std::move(read), problem) : std::nullopt;
  if (!mesh && problem.empty()) std::abort();
  if (!mesh) return;
  for (const Vec3& p : mesh->points) {
    if (!std::isfinite(p.x + p.y + p.z)) std::abort();
  }
  for (const uint32_t corner : mesh->corners) {
    if (corner >= mesh->points.size()) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  MeshLimits limits;
  limits.folders = {"/proc/self/fdinfo"};  // holds nothing that a mesh names
  std::string problem;
  auto file = read_obj_text(bytes, "/proc/self/fdinfo", problem, limits);
  check(file ? std::optional(std::move(file->mesh)) : std::nullopt, problem);
  problem = "cut off";
  check(mesh_from_bytes(bytes, problem), problem);
  return 0;
}
