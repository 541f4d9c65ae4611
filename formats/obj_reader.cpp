#include "formats/obj_reader.hpp"

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <istream>
#include <sstream>
#include <streambuf>

#include "formats/color.hpp"

namespace mansard {
namespace {

namespace fs = std::filesystem;

/// The text with continued lines joined; knows the line of the file that is being read.
class Text final : public std::streambuf {
 public:
  explicit Text(std::string text) : original_(std::move(text)), joined_(original_) {
    for (std::size_t at = 0; (at = joined_.find("\\\n", at)) != std::string::npos;) {
      joined_[at] = joined_[at + 1] = ' ';
    }
    setg(joined_.data(), joined_.data(), joined_.data() + joined_.size());
  }
  /// The line that was read last.
  std::string_view current() const {
    const std::string_view read(eback(), static_cast<std::size_t>(gptr() - eback()));
    const std::string_view whole = read.substr(0, read.find_last_not_of("\r\n") + 1);
    return whole.substr(whole.find_last_of("\r\n") + 1);
  }
  std::size_t line() const {
    const auto read = gptr() - eback();
    const auto ends = std::count(original_.begin(), original_.begin() + read, '\n');
    return ends + (read > 0 && original_[read - 1] != '\n');
  }

 private:
  std::string original_, joined_;
};

/// Keeps what tinyobjloader read of the MTL files: its callbacks would fail on an empty one. A file
/// that is refused is a problem, one that is missing is not.
class Materials final : public tinyobj::MaterialReader {
 public:
  Materials(fs::path folder, const MeshLimits& limits)
      : folder_(std::move(folder)), limits_(limits) {}
  bool operator()(const std::string& name, std::vector<tinyobj::material_t>* all,
                  std::map<std::string, int>* numbers, std::string* warning,
                  std::string* error) override {
    const std::string path = (folder_ / name).string();
    std::string why;
    std::istringstream text(content_within(path, limits_, why));
    if (!why.empty() && why != "no such file" && problem.empty())
      problem = "'" + path + "' can not be read: it " + why;
    if (!why.empty()) return false;
    tinyobj::LoadMtl(numbers, all, &text, warning, error);
    all_ = *all;
    return true;
  }
  const std::vector<tinyobj::material_t>& all() const { return all_; }
  std::string problem;  ///< the first

 private:
  fs::path folder_;
  const MeshLimits& limits_;
  std::vector<tinyobj::material_t> all_;
};

/// What the callbacks fill.
struct Reading {
  ObjFile file;
  const Text* text = nullptr;
  std::vector<Vec2> uvs;
  std::string object, group;
  int material = -1;
  bool has_uvs = false;
  std::string problem;  ///< the first one

  void fail(const std::string& what) {
    if (problem.empty()) problem = "line " + std::to_string(text->line()) + ": " + what;
  }
  /// From the file's number (from 1, or back from the end) to ours; -1 when there is no such thing.
  static int64_t resolve(int number, std::size_t count) {
    const int64_t at = number > 0 ? int64_t{number} - 1 : int64_t(count) + number;
    return number != 0 && at >= 0 && at < int64_t(count) ? at : -1;
  }
  void add_face(const tinyobj::index_t* corners, int count);
  void start_object();
  void check_numbers();
};

/// tinyobjloader reads what is no number as 0, `nan` among it.
void Reading::check_numbers() {
  std::string_view rest = text->current();
  for (int i = 0; i < 4; ++i) {  // v and its three coordinates
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
    rest.remove_prefix(word.size());
    if (i == 0) continue;
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto read = std::from_chars(word.data() + word.starts_with('+'), end, value);
    if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value))
      return fail(word.empty() ? "vertex with fewer than three coordinates"
                               : "'" + std::string(word) + "' is no coordinate");
  }
}

void Reading::start_object() {
  std::vector<ObjFile::Object>& objects = file.objects;
  const auto faces = static_cast<uint32_t>(file.mesh.faces.size());
  if (!objects.empty()) objects.back().end = faces;
  if (objects.empty() || objects.back().begin != faces) objects.push_back({"", faces, faces});
  objects.back().name = object.empty() ? group : object;
}

void Reading::add_face(const tinyobj::index_t* corners, int count) {
  if (!problem.empty()) return;
  if (count < 3) return fail("face with fewer than three corners");
  Mesh& mesh = file.mesh;
  const auto begin = static_cast<uint32_t>(mesh.corners.size());
  for (int i = 0; i < count; ++i) {
    const int64_t point = resolve(corners[i].vertex_index, mesh.points.size());
    if (point < 0) return fail("face of unknown vertex");
    mesh.corners.push_back(static_cast<uint32_t>(point));
    const int64_t uv = resolve(corners[i].texcoord_index, uvs.size());
    if (uv < 0 && corners[i].texcoord_index != 0) return fail("face of unknown texture coordinate");
    has_uvs = has_uvs || uv >= 0;
    mesh.uvs.push_back(uv < 0 ? Vec2{} : uvs[uv]);
  }
  // Material 0 is the plain look of faces before any usemtl.
  mesh.faces.push_back(
      {begin, static_cast<uint32_t>(mesh.corners.size()), {}, static_cast<uint32_t>(material + 1)});
}

tinyobj::callback_t callbacks() {
  tinyobj::callback_t to;
  to.vertex_cb = [](void* user, double x, double y, double z, double) {
    auto& r = *static_cast<Reading*>(user);
    if (!std::isfinite(x + y + z)) r.fail("vertex that is not finite");
    r.check_numbers();
    r.file.mesh.points.push_back({x, y, z});
  };
  to.texcoord_cb = [](void* user, double u, double v, double) {
    static_cast<Reading*>(user)->uvs.push_back({u, v});
  };
  to.index_cb = [](void* user, tinyobj::index_t* corners, int count) {
    static_cast<Reading*>(user)->add_face(corners, count);
  };
  to.usemtl_cb = [](void* user, const char*, int number) {
    static_cast<Reading*>(user)->material = number;
  };
  to.group_cb = [](void* user, const char** names, int count) {
    auto& r = *static_cast<Reading*>(user);
    r.group = count > 0 ? names[0] : "";
    r.start_object();
  };
  to.object_cb = [](void* user, const char* name) {
    auto& r = *static_cast<Reading*>(user);
    r.object = name;
    r.start_object();
  };
  return to;
}

Mesh::Material convert(const tinyobj::material_t& from, const fs::path& folder,
                       const MeshLimits& limits, std::string& problem) {
  Mesh::Material to;
  to.name = from.name;
  to.color = {to_linear(from.diffuse[0]), to_linear(from.diffuse[1]), to_linear(from.diffuse[2])};
  to.opacity = std::clamp<double>(from.dissolve, 0, 1);
  const bool is_mask = from.diffuse_texname.empty();
  std::string name = is_mask ? from.alpha_texname : from.diffuse_texname;
  if (!name.empty()) {
    std::replace(name.begin(), name.end(), '\\', '/');
    to.texture = named_picture(folder, name, limits, problem);
    to.overlay = is_mask && !to.texture.empty();
  }
  return to;
}

}  // namespace

std::optional<ObjFile> read_obj(const std::string& path, std::string& problem,
                                const MeshLimits& limits) {
  std::string content = content_within(path, limits, problem);
  if (!problem.empty()) return {};
  return read_obj_text(std::move(content), fs::path(path).parent_path(), problem, limits);
}

std::optional<ObjFile> read_obj_text(std::string content, const fs::path& folder,
                                     std::string& problem, const MeshLimits& limits) {
  Text text(std::move(content));
  std::istream in(&text);
  Materials materials(folder, limits);
  Reading reading;
  reading.text = &text;
  reading.start_object();
  std::string warning, error;
  tinyobj::LoadObjWithCallback(in, callbacks(), &reading, &materials, &warning, &error);
  problem = !reading.problem.empty() ? reading.problem : materials.problem;
  if (problem.empty() && reading.file.mesh.faces.empty()) problem = "it has no faces";
  if (!problem.empty()) return {};
  reading.file.objects.back().end = static_cast<uint32_t>(reading.file.mesh.faces.size());
  std::erase_if(reading.file.objects, [](const auto& o) { return o.begin == o.end; });
  Mesh& mesh = reading.file.mesh;
  if (!reading.has_uvs) mesh.uvs.clear();
  mesh.materials.push_back({});
  for (const tinyobj::material_t& m : materials.all()) {
    mesh.materials.push_back(convert(m, folder, limits, problem));
  }
  if (!problem.empty()) return {};
  return std::move(reading.file);
}

}  // namespace mansard
