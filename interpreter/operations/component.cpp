// comp: the faces, edges and vertices of a shape.
#include "interpreter/component.hpp"

#include <algorithm>
#include <array>

#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"
#include "interpreter/roof_lines.hpp"
#include "interpreter/selectors.hpp"

namespace mansard {
namespace {

/// Does the part's label choose component number i?
bool label_selects(const CallPart& part, double number, const Shape& face, const Shape& parent,
                   std::size_t i) {
  if (part.name != none) return selects(*selector_of(part.name), face, parent);
  return number == static_cast<double>(i);
}

/// Gives each face to the first part that selects it. The numbers of parts, how many components
/// came to each part and which part each component goes to lie above what the shapes around keep.
void distribute(Context& c, std::size_t first, std::optional<Selector> single) {
  auto& faces = c.machine.scratch_shapes;
  auto& numbers = c.machine.scratch_sizes;
  auto& counts = c.machine.scratch_counts;
  const std::size_t n = faces.size() - first, parts = c.call.parts.size();
  const std::size_t number = numbers.size(), count = counts.size(), chosen = count + parts;
  numbers.resize(number + parts, -1);
  counts.resize(chosen, 0);
  counts.resize(chosen + n, none);
  for (std::size_t p = 0; p < parts; ++p) {
    const CallPart& part = c.call.parts[p];
    if (!part.labelled || part.name != none) continue;
    const double wanted = c.machine.number(part.size.value, c.env);
    if (!is_component_number(wanted)) {
      c.machine.fail(c.machine.program.spans[part.size.value], wrong_component(wanted),
                     "they are numbered from 0");
    }
    numbers[number + p] = wanted;
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t p = 0; p < parts && counts[chosen + i] == none; ++p) {
      const Shape& face = faces[first + i];
      const bool yes = single
                           ? selects(*single, face, c.shape)
                           : label_selects(c.call.parts[p], numbers[number + p], face, c.shape, i);
      if (!yes) continue;
      counts[chosen + i] = static_cast<uint32_t>(p);
      faces[first + i].comp_index = counts[count + p]++;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const uint32_t part = counts[chosen + i];
    if (part == none) continue;
    Shape piece = faces[first + i];
    piece.comp_count = counts[count + part];
    piece.comp_name = single ? static_cast<uint32_t>(*single) + 1 : c.call.parts[part].name;
    piece.index = c.shape.index;
    c.go_on(c.call.parts[part], piece.comp_index, piece);
  }
  faces.resize(first);
  numbers.resize(number);
  counts.resize(count);
}

bool is_line_selector(const CallPart& part, Selector which) {
  return part.name != none && selector_of(part.name) == which;
}

/// The lines of a roof of one kind.
void push_roof_lines(Context& c, RoofLineKind kind) {
  const FaceBorders borders = borders_of(c.machine, c.shape);
  for (const RoofLine& line : roof_lines(borders.edges, borders.normals, {0, 1, 0})) {
    if (line.kind != kind) continue;
    const EdgeTag tag = borders.tags[borders.edges[line.edge].face];
    c.machine.scratch_shapes.push_back(shape_of(c.shape, line, tag));
  }
}

constexpr std::array line_selectors{Selector::edges, Selector::vertices, Selector::ridge,
                                    Selector::hip,   Selector::valley,   Selector::eave,
                                    Selector::rake};

/// Edges, vertices and lines of roofs: every one of them, in order.
void lines(Context& c, Selector which, const CallPart& part) {
  auto& out = c.machine.scratch_shapes;
  const std::size_t first = out.size();
  switch (which) {
    case Selector::edges:
      push_edges(c.machine, c.shape);
      break;
    case Selector::vertices:
      push_vertices(c.machine, c.shape);
      break;
    default:
      push_roof_lines(c, static_cast<RoofLineKind>(static_cast<int>(which) -
                                                   static_cast<int>(Selector::ridge)));
  }
  const std::size_t end = out.size();
  for (std::size_t i = first; i < end; ++i) {
    Shape piece = out[i];
    piece.comp_index = static_cast<uint32_t>(i - first);
    piece.comp_count = static_cast<uint32_t>(end - first);
    piece.comp_name = static_cast<uint32_t>(which) + 1;
    c.go_on(part, i - first, piece);
  }
  out.resize(first);
}

}  // namespace

namespace operation {

void comp(Context& c, std::optional<Edges> selector) {
  std::optional<Selector> single;
  if (selector) {
    const Value& v = selector->value;
    if (v.type != Type::string) c.wrong_type(0, v, "a selector like \"facades\"");
    single = find_selector(v.string());
    if (!single) {
      const auto meant = nearest(v.string(), selector_words);
      c.fail(0, "\"" + std::string(v.string()) + "\" selects no components",
             meant ? "did you mean \"" + std::string(*meant) + "\"?" : "");
    }
  }
  for (const Selector which : line_selectors) {
    if (single == which) return lines(c, which, c.call.parts[0]);
    for (const CallPart& part : c.call.parts) {
      if (is_line_selector(part, which)) lines(c, which, part);
    }
  }
  const std::size_t first = c.machine.scratch_shapes.size();
  const uint32_t solid = c.shape.solid;
  if (c.machine.program.asks) c.machine.show_apart(c.shape);
  push_faces(c.machine, c.shape);
  distribute(c, first, single);
  c.shape.solid = solid;
}

}  // namespace operation
}  // namespace mansard
