// Footprints drawn as faces of an OBJ.
#include <algorithm>
#include <unordered_map>

#include "formats/footprint_sources.hpp"
#include "formats/obj_reader.hpp"

namespace mansard {
namespace {

/// The first face of an object bears its name, the others are numbered; without a name, the place
/// in the file.
std::string face_id(const std::string& object, std::size_t place, std::size_t nth) {
  if (object.empty()) return std::to_string(place);
  return nth == 1 ? object : object + ":" + std::to_string(nth);
}

}  // namespace

RawSet read_obj_footprints(const std::string& path) {
  std::string problem;
  const std::optional<ObjFile> file = read_obj(path, problem);
  if (!file) {
    Diagnostic d;
    d.text = "can not read footprints from '" + path + "': " + problem;
    throw Failure(std::move(d));
  }
  RawSet set;
  set.origin = "the metres of '" + path + "'";
  const Mesh& mesh = file->mesh;
  std::unordered_map<std::string, std::size_t> faces_of;
  for (const ObjFile::Object& object : file->objects) {
    for (uint32_t f = object.begin; f < object.end; ++f) {
      RawFeature feature;
      feature.id = face_id(object.name, f, ++faces_of[object.name]);
      RawRing& ring = feature.parts.emplace_back().emplace_back();
      for (uint32_t corner : mesh.loop(mesh.faces[f])) {
        ring.push_back({mesh.points[corner].x, -mesh.points[corner].z});
      }
      set.features->add(feature);
    }
  }
  if (std::any_of(mesh.points.begin(), mesh.points.end(), [](Vec3 p) { return p.y != 0; })) {
    set.notes.push_back({"", "heights (y) of the points are ignored", false});
  }
  return set;
}

}  // namespace mansard
