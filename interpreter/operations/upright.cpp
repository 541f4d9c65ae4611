// upright(kind, ...): a dormer on a rectangle of a slope.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/dormer.hpp"
#include "interpreter/component.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"
#include "interpreter/roof_lines.hpp"
#include "interpreter/roof_words.hpp"

namespace mansard {
namespace {

constexpr std::array<std::string_view, 8> dormer_parts{"front", "cheek",  "top",    "gable",
                                                       "slope", "soffit", "fascia", "rest"};

DormerKind kind_of(Context& c, std::string_view word) {
  const auto it = std::ranges::find(dormer_kinds, word);
  if (it != dormer_kinds.end()) return static_cast<DormerKind>(it - dormer_kinds.begin());
  const WrongWord unknown = unknown_dormer_kind(word);
  c.fail(0, unknown.text, unknown.help);
}

bool is_rectangle(const Context& c) {
  if (c.shape.form == Form::rectangle) return true;
  return c.shape.form == Form::polygon && !c.shape.ground &&
         is_axis_rectangle(plan_of(c.machine, c.shape), 1e-4);
}

/// Degrees from level of a rectangle that leans back over a level lower edge.
double slope_under(Context& c) {
  const Scope& scope = c.shape.scope;
  const auto refuse = [&](std::string_view why, std::string_view help) {
    c.machine.fail(c.call.at, "'upright' needs a rectangle of a slope, this " + std::string(why),
                   std::string(help));
  };
  if (c.shape.form != Form::rectangle && c.shape.form != Form::polygon)
    refuse("is a solid or has no surface", "take a slope: roof(\"gable\", 45) { slope : A }");
  const double degrees = std::acos(std::clamp(scope.z.y, -1.0, 1.0)) * 180 / std::numbers::pi;
  const bool level = c.shape.ground || degrees <= 1;
  if (level || degrees >= 89)
    refuse(level ? "shape lies level" : "shape stands or looks down",
           "take a slope: roof(\"gable\", 45) { slope : A }");
  if (std::abs(scope.x.y) > 1e-6) refuse("one's lower edge is not level", "");
  if (!is_rectangle(c))
    refuse("one has another outline",
           "inner_rectangle() { upright(...) { ... } | TILES } finds one in it");
  return degrees;
}

double own_pitch(Context& c, DormerKind kind, std::optional<double> pitch, double slope) {
  if (pitch) {
    if (const auto wrong = wrong_roof_number("pitch", *pitch)) c.fail(1, wrong->text, wrong->help);
  }
  const auto tangent = [](double d) { return std::tan(d * std::numbers::pi / 180); };
  if (kind != DormerKind::shed) return pitch.value_or(slope);
  if (!pitch) return std::atan(tangent(slope) / 3) * 180 / std::numbers::pi;
  if (*pitch >= slope) {
    c.fail(1,
           "the roof of a \"shed\" dormer, here of " + number_text(*pitch) +
               " degrees, must be shallower than its slope of " + number_text(slope),
           "leave the pitch out for a third of the slope's rise");
  }
  return *pitch;
}

void read(Context& c, std::size_t i, std::optional<double> given, double& option) {
  if (!given) return;
  if (const auto wrong = wrong_roof_number(c.call.operation->parameter_name(i), *given))
    c.fail(i, wrong->text, wrong->help);
  option = *given;
}

void warn_unnamed(Context& c, std::size_t part) {
  const std::string word(dormer_parts[part]);
  c.machine.warn("W011", c.call.parts_at,
                 "this dormer makes '" + word + "', which no part takes: it is left out",
                 "add '" + word + " : SYMBOL', or NIL to leave it out");
}

/// The slope around a dormer: what it stands on meets its roof in valleys. Borders that no other
/// face has are the dormer's foot.
void add_slope_around(FaceBorders& borders, Vec3 normal) {
  const std::vector<BorderEdge> edges = borders.edges;
  const auto around = static_cast<uint32_t>(borders.normals.size());
  borders.normals.push_back(normal);
  borders.tags.emplace_back();
  for (const BorderEdge& edge : edges) {
    const bool inside = std::ranges::any_of(edges, [&](const BorderEdge& other) {
      return length(other.from - edge.to) < 1e-6 && length(other.to - edge.from) < 1e-6;
    });
    if (!inside) borders.edges.push_back({edge.to, edge.from, around});
  }
}

/// What a curved roof leaves of the slope is slope, where no part tells them apart.
std::size_t part_for(const Context& c, DormerPart part) {
  const auto own = static_cast<std::size_t>(part);
  const bool slope = part == DormerPart::rest && !c.wants(own);
  return slope ? static_cast<std::size_t>(DormerPart::slope) : own;
}

/// Its faces, in the world, as a solid of the world; where it lies on the slope it is open.
void show_dormer(Context& c, const std::vector<DormerFace>& faces,
                 const std::vector<std::vector<Vec3>>& loops) {
  Mesh mesh;
  std::vector<uint32_t> numbers;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f].part == DormerPart::rest) continue;
    numbers.clear();
    for (const Vec3 p : loops[f]) {
      numbers.push_back(static_cast<uint32_t>(mesh.points.size()));
      mesh.points.push_back(p);
    }
    mesh.add_face(numbers);
  }
  if (mesh.faces.empty()) return;
  Shape solid = c.shape;
  solid.scope = {};
  c.machine.adopt(solid, std::move(mesh));
  c.machine.show(solid, false);
  c.shape.solid = solid.solid;
}

void give(Context& c, const std::vector<DormerFace>& faces) {
  const Scope& on = c.shape.scope;
  const bool left = mirrored(on);
  const Vec3 along = on.x * (left ? -1.0 : 1.0), into = cross(Vec3{0, 1, 0}, along);
  const Vec3 corner = left ? on.at({on.size.x, 0, 0}) : on.origin;
  std::vector<std::vector<Vec3>> loops;
  for (const DormerFace& face : faces) {
    auto& loop = loops.emplace_back();
    for (const Vec3 p : face.loop)
      loop.push_back(corner + along * p.x + into * p.y + Vec3{0, p.z, 0});
  }
  const uint32_t solid = c.shape.solid;
  if (c.machine.program.asks) show_dormer(c, faces, loops);
  constexpr std::size_t first_line = dormer_parts.size();
  FaceBorders borders;
  const bool lines = wants_lines(c, first_line);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::size_t part = part_for(c, faces[f].part);
    const std::vector<Vec3>& loop = loops[f];
    if (lines) borders.add_face(loop, c.shape.tag);
    if (!c.wants(part)) {
      warn_unnamed(c, part);
      continue;
    }
    Shape piece = face_of(c.machine, c.shape, loop, {}, c.shape.tag);
    c.named_part(part, piece);
  }
  if (lines) {
    add_slope_around(borders, on.z);
    give_lines(c, borders, first_line);
  }
  c.shape.solid = solid;
}

}  // namespace

namespace operation {

void upright(Context& c, std::optional<std::string_view> kind, std::optional<double> pitch,
             std::optional<double> overhang, std::optional<double> thickness) {
  DormerOptions options;
  options.kind = kind_of(c, kind.value_or("flat"));
  options.slope = slope_under(c);
  options.pitch = own_pitch(c, options.kind, pitch, options.slope);
  read(c, 2, overhang, options.overhang);
  read(c, 3, thickness, options.thickness);
  options.width = c.shape.scope.size.x;
  options.height = c.shape.scope.size.y;
  constexpr double least = 1e-3;
  if (std::min(options.width, options.height) < least) return;
  give(c, dormer(options));
}

}  // namespace operation
}  // namespace mansard
