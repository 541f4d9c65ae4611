// mansard render
#include "cli/derive_all.hpp"
#include "cli/output.hpp"
#include "cli/picture.hpp"
#include "cli/progress.hpp"
#include "cli/remarks.hpp"
#include "formats/meshes.hpp"

namespace mansard {
namespace {

/// Pictures are coloured; but some programs write black for the colour behind a picture.
Paint paint_of(const Mesh::Material& m) {
  const Vec3 tint = m.color == Vec3{} && !m.overlay ? Vec3{1, 1, 1} : m.color;
  return {m.color, is_glass(m.name, m.opacity), m.texture, {}, tint, m.overlay, m.picture};
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
  for (const Mesh::Material& m : mesh->materials) scene.paints.push_back(paint_of(m));
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
                                          Remarks& remarks, Scene& scene) {
  if (!session.compile(arguments.positional()[0], compile_options(arguments))) return std::nullopt;
  std::size_t failed = 0;
  const bool keep_going = arguments.has("--keep-going");
  const StoredSet set = stored_footprints(session, arguments.positional()[1], arguments, failed);
  Looks looks(session.program());
  const Totals totals = [&] {
    Progress progress(set.footprints.size(), session.quiet());
    return derive_all(session.program(), session.meshes(), set.footprints,
                      derive_options(arguments, session.program()), thread_option(arguments),
                      keep_going, {.number = [&](Derived& derived) {
                        remarks.add(derived.building);
                        progress.step();
                        if (derived.error) return session.print(*derived.error);
                        looks.adopt(derived.building);
                        scene.add(derived.building.surface);
                      }});
  }();
  scene.paints = looks.paints();
  if (totals.interrupted || (totals.failed > 0 && !keep_going)) return std::nullopt;
  return failed + totals.failed;
}

int draw(Session& session, const Arguments& arguments, const PictureOptions& options,
         const std::string& out) {
  Scene scene;
  Remarks remarks(session);
  std::size_t failed = 0;
  if (arguments.positional().size() == 2) {
    const auto result = add_derivation(session, arguments, remarks, scene);
    if (!result) return exit_input;
    failed = *result;
  } else {
    add_model(arguments.positional()[0], scene);
  }
  write_picture(render(scene, options), out);
  session.say("picture: " + out + (session.compiled() ? session.style_taken(arguments) : ""));
  if (session.compiled()) remarks.finish(session.program());
  return failed > 0 ? exit_input : exit_done;
}

}  // namespace

int run_render(const Arguments& arguments) {
  const PictureOptions options = picture_options(arguments, {1200, 800});
  const std::string out = picture_output(arguments);
  const bool is_style = arguments.positional()[0].ends_with(".style");
  if (is_style && arguments.positional().size() == 1)
    throw UsageError("say what to build on: mansard render " + arguments.positional()[0] +
                     " rect:10x8 -o " + out);
  if (is_style != (arguments.positional().size() == 2)) {
    throw UsageError(
        "write: mansard render MODEL -o PICTURE.png, or mansard render FILE.style FOOTPRINTS -o "
        "PICTURE.png");
  }
  Session session(arguments);
  return session.guard([&] { return draw(session, arguments, options, out); });
}

}  // namespace mansard
