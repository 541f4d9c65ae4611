// mansard render
#include "render/picture.hpp"

#include <cmath>

#include "cli/derive_all.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "formats/meshes.hpp"

namespace mansard {
namespace {

PictureOptions picture_options(const Arguments& arguments) {
  PictureOptions options;
  if (const auto text = arguments.value("--camera")) {
    const auto camera = parse_camera(*text);
    if (!camera)
      throw UsageError("--camera takes iso, street or x,y,z,tx,ty,tz, not '" + *text + "'");
    options.camera = *camera;
  }
  if (const auto text = arguments.value("--size")) {
    int width = 0, height = 0, end = 0;
    const bool read = std::sscanf(text->c_str(), "%5dx%5d%n", &width, &height, &end) == 2;
    if (!read || static_cast<std::size_t>(end) != text->size() || width < 16 || height < 16 ||
        width > 16000 || height > 16000) {
      throw UsageError("--size takes WIDTHxHEIGHT in pixels from 16x16 to 16000x16000, not '" +
                       *text + "'");
    }
    options.width = width;
    options.height = height;
  }
  options.threads = static_cast<int>(arguments.number("--threads", 0, 1, 1024));
  return options;
}

/// A model's faces as a surface, its materials as paints.
void add_model(const std::string& path, Scene& scene) {
  std::string problem;
  const auto mesh = read_mesh(path, problem);
  if (!mesh) {
    Diagnostic d;
    d.text = "can not read '" + path + "': " + problem;
    throw Failure(std::move(d));
  }
  for (const Mesh::Material& m : mesh->materials)
    scene.paints.push_back({m.color, is_glass(m.name, m.opacity), m.texture});
  if (scene.paints.empty()) scene.paints.push_back({});
  Surface surface;
  for (const Mesh::Face& face : mesh->faces) {
    for (uint32_t c = face.begin; c < face.end; ++c) {
      surface.points.push_back(mesh->points[mesh->corners[c]]);
      surface.uvs.push_back(mesh->uvs.empty() ? Vec2{} : mesh->uvs[c]);
    }
    surface.ends.push_back(static_cast<uint32_t>(surface.points.size()));
    surface.normals.push_back(normalized(newell(surface.loop(surface.ends.size() - 1))));
    surface.runs.push_back({0, face.material, static_cast<uint32_t>(surface.ends.size())});
  }
  scene.add(surface);
}

/// Returns how many footprints failed; nothing when the style did.
std::optional<std::size_t> add_derivation(Session& session, const Arguments& arguments,
                                          Scene& scene) {
  if (!session.compile(arguments.positional()[0], compile_options(arguments))) return std::nullopt;
  std::size_t failed = 0;
  const bool keep_going = arguments.has("--keep-going");
  const FootprintSet set = footprints(session, arguments.positional()[1], arguments, failed);
  Looks looks(session.program());
  Progress progress(set.footprints.size(), session.quiet());
  const Totals totals = derive_all(session, set.footprints, derive_options(arguments),
                                   static_cast<int>(arguments.number("--threads", 0, 1, 1024)),
                                   keep_going, [&](Derived& derived) {
                                     progress.step();
                                     if (derived.error) return session.print(*derived.error);
                                     looks.adopt(derived.building);
                                     scene.add(derived.building.surface);
                                   });
  scene.paints = looks.paints();
  if (totals.interrupted || (totals.failed > 0 && !keep_going)) return std::nullopt;
  return failed + totals.failed;
}

int draw(Session& session, const Arguments& arguments, const PictureOptions& options,
         const std::string& out) {
  Scene scene;
  std::size_t failed = 0;
  if (arguments.positional().size() == 2) {
    const auto result = add_derivation(session, arguments, scene);
    if (!result) return exit_input;
    failed = *result;
  } else {
    add_model(arguments.positional()[0], scene);
  }
  if (!write_png(render(scene, options), out)) {
    Diagnostic d;
    d.text = "can not write '" + out + "'";
    d.help = "is there such a folder, and room on the disk?";
    throw Failure(std::move(d));
  }
  session.say("picture: " + out);
  return failed > 0 ? exit_input : exit_done;
}

}  // namespace

int run_render(const Arguments& arguments) {
  const PictureOptions options = picture_options(arguments);
  const auto out = arguments.value("--output");
  if (!out || !out->ends_with(".png"))
    throw UsageError("say where the picture goes: -o PICTURE.png");
  const bool is_style = arguments.positional()[0].ends_with(".style");
  if (is_style != (arguments.positional().size() == 2)) {
    throw UsageError(
        "write: mansard render MODEL -o PICTURE.png, or mansard render FILE.style FOOTPRINTS -o "
        "PICTURE.png");
  }
  Session session(arguments);
  return session.guard([&] { return draw(session, arguments, options, *out); });
}

}  // namespace mansard
