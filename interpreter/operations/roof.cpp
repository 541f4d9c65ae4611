// roof(kind, pitch, ...): the faces of a roof over a flat shape.
#include "geometry/roof.hpp"

#include <algorithm>
#include <array>

#include "interpreter/component.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"
#include "interpreter/selectors.hpp"

namespace mansard {
namespace {

constexpr std::array<std::string_view, 8> part_words{"slope",  "gable",   "top",   "soffit",
                                                     "fascia", "parapet", "lower", "upper"};
RoofKind kind_of(Context& c, std::string_view word) {
  if (word == "flat") return RoofKind::flat;
  if (word == "hip") return RoofKind::hip;
  if (word == "gable") return RoofKind::gable;
  if (is_later_word("kind", word)) {
    c.fail(0, "roof kind \"" + std::string(word) + "\" comes with a later version",
           "this version has \"flat\", \"hip\" and \"gable\"");
  }
  constexpr std::array<std::string_view, 3> kinds{"flat", "hip", "gable"};
  const auto meant = nearest(word, kinds);
  c.fail(
      0, "\"" + std::string(word) + "\" is no kind of roof",
      meant ? "did you mean \"" + std::string(*meant) + "\"?" : "\"flat\", \"hip\" or \"gable\"");
}

double in_range(Context& c, std::size_t i, std::optional<double> given, double fallback, double low,
                double high) {
  if (!given) return fallback;
  if (*given < low || *given > high) {
    c.fail(i, "'" + std::string(c.call.operation->parameter_name(i)) + "' must lie between " +
                  number_text(low) + " and " + number_text(high) + ", it is " +
                  number_text(*given));
  }
  return *given;
}

void need_lying(Context& c) {
  const bool flat = c.shape.form == Form::rectangle || c.shape.form == Form::polygon;
  const bool lies = c.shape.ground || c.shape.scope.z.y > 0.999;
  if (!flat || !lies) {
    c.machine.fail(c.call.at,
                   "'roof' needs a flat shape that looks up, this one " +
                       std::string(flat ? "stands or slopes" : "is a solid or has no surface"),
                   "take the top first: comp { top : ROOF }");
  }
}

std::vector<Vec3> placed(const Shape& base, std::span<const Vec3> loop) {
  const double depth = base.scope.size.z;
  std::vector<Vec3> world;
  world.reserve(loop.size());
  for (const Vec3& p : loop) {
    world.push_back(base.scope.at(base.ground ? Vec3{p.x, p.z, depth - p.y} : p));
  }
  if (mirrored(base.scope)) std::reverse(world.begin(), world.end());
  return world;
}

void warn_unnamed(Context& c, RoofPart part) {
  const auto word = std::string(part_words[static_cast<std::size_t>(part)]);
  c.machine.warn("W011", c.call.parts_at,
                 "this roof makes '" + word + "', which no part takes: it is left out",
                 "add '" + word + " : SYMBOL', or NIL to leave it out");
}

void give_faces(Context& c, const Roof& roof) {
  for (const RoofFace& face : roof.faces) {
    const auto part = static_cast<std::size_t>(face.part);
    if (!c.wants(part)) {
      warn_unnamed(c, face.part);
      continue;
    }
    const auto loop = placed(c.shape, face.loop);
    std::vector<std::vector<Vec3>> holes;
    for (const auto& hole : face.holes) holes.push_back(placed(c.shape, hole));
    Shape piece = face_of(c.machine, c.shape, loop, holes, face.tag);
    c.named_part(part, piece);
  }
}

/// A flat roof without edges of its own is the shape itself.
void give_flat(Context& c) {
  need_lying(c);
  constexpr auto top = static_cast<std::size_t>(RoofPart::top);
  if (!c.wants(top)) return warn_unnamed(c, RoofPart::top);
  Shape piece = c.shape.ground ? lying_face(c.shape) : c.shape;
  piece.cuts = piece.open = 0;
  c.named_part(top, piece);
}

/// All faces as one mesh that goes on as the shape.
void become_mesh(Context& c, const Roof& roof) {
  Mesh mesh;
  const double depth = c.shape.scope.size.z;
  for (const RoofFace& face : roof.faces) {
    Polygon rings;
    std::vector<uint32_t> numbers;
    const auto add = [&](const std::vector<Vec3>& ring) {
      for (const Vec3& p : ring) {
        numbers.push_back(static_cast<uint32_t>(mesh.points.size()));
        mesh.points.push_back(c.shape.ground ? Vec3{p.x, p.z, depth - p.y} : p);
        rings.add_point({p.x, p.y});
      }
      rings.close_ring();
    };
    add(face.loop);
    for (const auto& hole : face.holes) add(hole);
    add_flat(mesh, rings, std::move(numbers), face.tag, false);
  }
  Shape solid = c.shape;
  const Box3 box = bounds(mesh.points);
  solid.scope.origin = c.shape.scope.at(box.low);
  solid.scope.size = box.size();
  solid.form = Form::mesh;
  solid.ground = false;
  solid.uv_frame = Shape::none;
  solid.geometry = c.machine.add_mesh(std::move(mesh));
  c.become(solid);
}

}  // namespace

namespace operation {

void roof(Context& c, std::string_view kind, std::optional<double> pitch,
          std::optional<double> overhang, std::optional<double> height, std::optional<Edges> gables,
          std::optional<double> parapet, std::optional<double> thickness) {
  RoofOptions options;
  options.kind = kind_of(c, kind);
  options.pitch = in_range(c, 1, pitch, options.pitch, 0.5, 85);
  options.overhang = in_range(c, 2, overhang, 0, 0, 10);
  options.height = in_range(c, 3, height, 0, 0, 1000);
  options.parapet = in_range(c, 5, parapet, 0, 0, 100);
  options.thickness = in_range(c, 6, thickness, options.thickness, 0.001, 10);
  const bool bare = options.kind == RoofKind::flat && options.overhang == 0 && options.parapet == 0;
  if (bare && c.has_parts()) return give_flat(c);
  need_lying(c);
  const Polygon plan = plan_of(c.machine, c.shape);
  if (gables) {
    const std::vector<bool> chosen = chosen_edges(c, 4, *gables, plan);
    options.gables.emplace(chosen.begin(), chosen.end());
  }
  const Roof made = mansard::roof(plan, options);
  if (made.fallback > 1) ++c.machine.building->roof_fallbacks;
  c.has_parts() ? give_faces(c, made) : become_mesh(c, made);
}

}  // namespace operation
}  // namespace mansard
