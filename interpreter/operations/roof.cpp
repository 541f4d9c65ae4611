// roof(kind, pitch, ...): the faces and lines of a roof over a flat shape.
#include "geometry/roof.hpp"

#include <algorithm>

#include "geometry/offset.hpp"
#include "interpreter/component.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"
#include "interpreter/roof_lines.hpp"
#include "interpreter/roof_words.hpp"
#include "interpreter/selectors.hpp"

namespace mansard {
namespace {

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

// ---- what is made

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

/// The tags of a face's edges, in the order that placed() gives its points.
std::vector<EdgeTag> edges_of(const Shape& base, const RoofFace& face) {
  std::vector<EdgeTag> edges = face.edges;
  if (edges.empty() || !mirrored(base.scope)) return edges;
  auto begin = edges.begin();
  const auto turn = [&](std::size_t n) {  // an edge bears the number of its first point
    std::reverse(begin, begin + static_cast<std::ptrdiff_t>(n));
    std::rotate(begin, begin + 1, begin + static_cast<std::ptrdiff_t>(n));
    begin += static_cast<std::ptrdiff_t>(n);
  };
  turn(face.loop.size());
  for (const auto& hole : face.holes) turn(hole.size());
  return edges;
}

void warn_unnamed(Context& c, RoofPart part) {
  const auto word = std::string(roof_parts[static_cast<std::size_t>(part)]);
  c.machine.warn("W011", c.call.parts_at,
                 "this roof makes '" + word + "', which no part takes: it is left out",
                 "add '" + word + " : SYMBOL', or NIL to leave it out");
}

/// Both slopes of roofs with two are slopes where no part tells them apart; so are the ledges of
/// centimetres that close a roof on a coarser outline to its walls, where no overhang is asked for.
std::size_t part_for(const Context& c, RoofPart part, bool overhangs) {
  const bool one_of_two = part == RoofPart::lower || part == RoofPart::upper;
  const bool ledge = !overhangs && (part == RoofPart::soffit || part == RoofPart::fascia);
  const auto own = static_cast<std::size_t>(part);
  return (one_of_two || ledge) && !c.wants(own) ? static_cast<std::size_t>(RoofPart::slope) : own;
}

void give_faces(Context& c, const Roof& roof, bool overhangs) {
  constexpr std::size_t first_line = roof_parts.size();
  const bool lines = wants_lines(c, first_line);
  FaceBorders borders;
  for (const RoofFace& face : roof.faces) {
    const std::size_t part = part_for(c, face.part, overhangs);
    if (!lines && !c.wants(part)) {
      warn_unnamed(c, face.part);
      continue;
    }
    const auto loop = placed(c.shape, face.loop);
    std::vector<std::vector<Vec3>> holes;
    for (const auto& hole : face.holes) holes.push_back(placed(c.shape, hole));
    if (lines) borders.add_face(loop, face.tag);
    for (const auto& hole : holes) {
      if (lines) borders.add_ring(hole);
    }
    if (!c.wants(part)) {
      warn_unnamed(c, face.part);
      continue;
    }
    Shape piece = face_of(c.machine, c.shape, loop, holes, face.tag, edges_of(c.shape, face));
    c.named_part(part, piece);
  }
  give_lines(c, borders, first_line);
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

/// All faces as one mesh.
Shape mesh_shape(Context& c, const Roof& roof) {
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
  solid.uv_frame = Shape::none;
  c.machine.adopt(solid, std::move(mesh));
  return solid;
}

void become_mesh(Context& c, const Roof& roof) {
  Shape solid = mesh_shape(c, roof);
  c.become(solid);
}

/// What the faces enclose, for shapes that ask about others.
void show_roof(Context& c, const Roof& roof) {
  Shape solid = mesh_shape(c, roof);
  c.machine.show_apart(solid);
  c.shape.solid = solid.solid;
}

// ---- what is told

/// Once a place; how often is in the report.
void tell_fallbacks(Context& c, const Roof& roof) {
  RoofTroubles& count = c.machine.building->roofs;
  const auto simpler = [&](std::size_t& counter, std::string_view how) {
    ++counter;
    c.machine.warn("W023", c.call.at,
                   "this roof had to be made by a simpler construction: " + std::string(how),
                   "look at the footprint's outline");
  };
  if (roof.fallback == 6) simpler(count.flat, "it is flat");
  if (roof.fallback == 5) simpler(count.one_ridge, "one ridge over the whole");
  if (roof.fallback > 1 && roof.fallback < 5)
    simpler(count.coarser, "on an outline coarser by centimetres");
  const auto without = [&](std::size_t& counter, std::string_view what, std::string_view help) {
    ++counter;
    c.machine.warn("W024", c.call.at, std::string(what), std::string(help));
  };
  if (roof.no_apex)
    without(count.no_apex, "no single point above this shape sees every edge: its pyramid is a hip",
            "take \"pyramid\" for convex shapes");
  if (roof.no_break)
    without(count.no_break, "the slopes end below the break: one pitch throughout",
            "a smaller break_height or break_inset, or none");
  if (roof.low)
    without(count.low, "'height' is less than twice the roof's thickness: its edge is made thinner",
            "more height, or less thickness");
}

/// The breadth of a shape is at most four times its area over its perimeter, so most need no more.
void tell_wide_overhang(Context& c, const Polygon& plan, double overhang) {
  const double around = perimeter(plan);
  if (!(around > 0) || overhang <= 2 * area(plan) / around) return;
  const double breadth = 2 * inradius(plan);
  if (overhang <= breadth) return;
  c.machine.warn(
      "W025", c.at(2),
      "an overhang of " + number_text(overhang) + " m around a shape that is " +
          number_text(breadth) + " m wide",
      "is it in metres? min(" + std::string(c.at(2).text()) + ", inradius) keeps it small");
}

// ---- what is asked for

void read(Context& c, std::size_t i, std::optional<double> given, double& option) {
  if (!given) return;
  if (const auto wrong = wrong_roof_number(c.call.operation->parameter_name(i), *given))
    c.fail(i, wrong->text, wrong->help);
  option = *given;
}

std::optional<std::vector<char>> flags(Context& c, std::size_t i, const std::optional<Edges>& edges,
                                       const Polygon& plan) {
  if (!edges) return std::nullopt;
  const std::vector<bool> chosen = chosen_edges(c, i, *edges, plan);
  return std::vector<char>(chosen.begin(), chosen.end());
}

/// The longest of the chosen edges; none when nothing is chosen.
std::optional<uint32_t> ridge_edge(Context& c, std::size_t i, const std::optional<Edges>& edges,
                                   const Polygon& plan) {
  if (!edges) return std::nullopt;
  const Value& value = edges->value;
  if (value.type == Type::string && value.string() == "longest") return std::nullopt;
  const std::vector<bool> chosen = chosen_edges(c, i, *edges, plan);
  std::optional<uint32_t> best;
  double longest = 0;
  for_each_edge(plan, [&](uint32_t edge, Vec2 from, Vec2 to) {
    // Of edges that are as long the first, however the last bits fall.
    if (!chosen[edge] || length(to - from) <= longest + 1e-6) return;
    best = edge;
    longest = length(to - from);
  });
  return best;
}

RoofKind kind_of(Context& c, std::string_view word) {
  if (const auto kind = find_roof_kind(word)) return *kind;
  const WrongWord unknown = unknown_roof_kind(word);
  c.fail(0, unknown.text, unknown.help);
}

}  // namespace

namespace operation {

void roof(Context& c, std::string_view kind, std::optional<double> pitch,
          std::optional<double> overhang, std::optional<double> height, std::optional<Edges> gables,
          std::optional<double> parapet, std::optional<double> thickness,
          std::optional<double> verge, std::optional<Edges> hips, std::optional<Edges> ridge,
          std::optional<double> upper_pitch, std::optional<double> break_height,
          std::optional<double> break_inset, std::optional<double> clipped,
          std::optional<double> tooth, std::optional<double> parapet_width) {
  RoofOptions options;
  options.kind = kind_of(c, kind);
  read(c, 1, pitch, options.pitch);
  read(c, 2, overhang, options.overhang);
  read(c, 3, height, options.height);
  read(c, 5, parapet, options.parapet);
  read(c, 6, thickness, options.thickness);
  read(c, 7, verge, options.verge);
  read(c, 10, upper_pitch, options.upper_pitch);
  read(c, 11, break_height, options.break_height);
  read(c, 12, break_inset, options.break_inset);
  read(c, 13, clipped, options.clipped);
  read(c, 14, tooth, options.tooth);
  read(c, 15, parapet_width, options.parapet_width);
  const bool bare = options.kind == RoofKind::flat && options.overhang == 0 && options.parapet == 0;
  if (bare && c.has_parts()) return give_flat(c);
  need_lying(c);
  const Polygon plan = plan_of(c.machine, c.shape);
  options.gables = flags(c, 4, gables, plan);
  options.hips = flags(c, 8, hips, plan);
  options.ridge = ridge_edge(c, 9, ridge, plan);
  if (options.overhang > 0) tell_wide_overhang(c, plan, options.overhang);
  const Roof made = mansard::roof(plan, options);
  tell_fallbacks(c, made);
  if (c.machine.program.asks && c.has_parts()) show_roof(c, made);
  c.has_parts() ? give_faces(c, made, options.overhang > 0 || options.verge > 0)
                : become_mesh(c, made);
}

}  // namespace operation
}  // namespace mansard
