#include "interpreter/roof_lines.hpp"

#include <array>

#include "geometry/mesh.hpp"
#include "interpreter/component.hpp"
#include "interpreter/context.hpp"
#include "interpreter/corners.hpp"

namespace mansard {

void FaceBorders::add_face(std::span<const Vec3> outline, EdgeTag tag) {
  normals.push_back(normalized(newell(outline)));
  tags.push_back(tag);
  add_ring(outline);
}

void FaceBorders::add_ring(std::span<const Vec3> ring) {
  const auto face = static_cast<uint32_t>(normals.size() - 1);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    edges.push_back({ring[i], ring[(i + 1) % ring.size()], face});
  }
}

FaceBorders borders_of(Machine& machine, const Shape& shape) {
  const std::size_t first = machine.scratch_shapes.size();
  push_faces(machine, shape);
  FaceBorders borders;
  std::vector<Vec3> ring;
  for (std::size_t f = first; f < machine.scratch_shapes.size(); ++f) {
    const Shape& face = machine.scratch_shapes[f];
    const Polygon plan = plan_of(machine, face);
    for (std::size_t r = 0; r < plan.rings(); ++r) {
      ring.clear();
      for (const Vec2 p : plan.ring(r)) ring.push_back(face.scope.at({p.x, p.y, 0}));
      r == 0 ? borders.add_face(ring, face.tag) : borders.add_ring(ring);
    }
  }
  machine.scratch_shapes.resize(first);
  return borders;
}

Shape shape_of(const Shape& parent, const RoofLine& line, EdgeTag tag) {
  const Vec3 x = normalized(line.to - line.from);
  Shape piece = parent;
  piece.form = Form::line;
  piece.scope = {line.from, x, line.away, cross(x, line.away), {length(line.to - line.from), 0, 0}};
  piece.ground = false;
  piece.geometry = piece.uv_frame = Shape::none;
  piece.cuts = piece.open = 0;
  piece.tag = tag;
  return piece;
}

bool wants_lines(const Context& c, std::size_t first) {
  for (std::size_t i = 0; i < roof_line_words.size(); ++i) {
    if (c.wants(first + i)) return true;
  }
  return false;
}

namespace {

/// Eaves meet at the angles of the walls below them.
void set_eave_corners(std::span<const RoofLine> lines, const RoofLine& line, Shape& piece) {
  constexpr double touch = 1e-6;  // metres
  const auto along = [](const RoofLine& l) {
    return Vec2{l.to.x - l.from.x, l.from.z - l.to.z};  // in the plan
  };
  piece.corner_left = piece.corner_right = 180;
  if (line.kind != RoofLineKind::eave) return;
  for (const RoofLine& beside : lines) {
    if (beside.kind != RoofLineKind::eave) continue;
    if (length(beside.to - line.from) <= touch)
      piece.corner_left = static_cast<float>(corner_angle(along(beside), along(line)));
    if (length(beside.from - line.to) <= touch)
      piece.corner_right = static_cast<float>(corner_angle(along(line), along(beside)));
  }
}

}  // namespace

void give_lines(Context& c, const FaceBorders& borders, std::size_t first) {
  if (!wants_lines(c, first)) return;
  const std::vector<RoofLine> lines = roof_lines(borders.edges, borders.normals, {0, 1, 0});
  std::array<uint32_t, roof_line_words.size()> counts{}, given{};
  for (const RoofLine& line : lines) ++counts[static_cast<std::size_t>(line.kind)];
  for (const RoofLine& line : lines) {
    const auto kind = static_cast<std::size_t>(line.kind);
    if (!c.wants(first + kind)) continue;
    Shape piece = shape_of(c.shape, line, borders.tags[borders.edges[line.edge].face]);
    if (c.machine.program.reads_corners) set_eave_corners(lines, line, piece);
    piece.comp_index = given[kind]++;
    piece.comp_count = counts[kind];
    piece.comp_name = c.call.parts[c.call.part_of[first + kind]].name;
    c.named_part(first + kind, piece);
  }
}

}  // namespace mansard
