#include "interpreter/selectors.hpp"

#include <algorithm>
#include <cmath>

#include "interpreter/context.hpp"
#include "interpreter/messages.hpp"

namespace mansard {

std::string_view selector_summary(Selector selector) {
  constexpr std::array<std::string_view, selector_words.size()> summaries{
      "All faces.",
      "Faces steeper than 45°.",
      "Faces steeper than 45°; the same as side.",
      "Faces steeper than 45°; the same as side.",
      "Sides or edges that look to the front of the parent's frame.",
      "Sides or edges that look to the back of the parent's frame.",
      "Sides or edges that look to the left of the parent's frame.",
      "Sides or edges that look to the right of the parent's frame.",
      "Faces that look up.",
      "Faces that look down.",
      "Faces that stand upright.",
      "Faces that lie level.",
      "Faces that neither stand upright nor lie level.",
      "The longest of the street walls.",
      "Walls that look at a line of --streets; without any, outer walls with no neighbour within "
      "6 m before them, or all outer free walls when there is none.",
      "Walls that touch a neighbour's footprint, within 5 cm.",
      "Walls around a hole of the footprint.",
      "Faces that a split made.",
      "Street walls that meet another street wall in an outer corner, at less than 150°.",
      "The lines of a flat shape, or of the base of an extruded footprint.",
      "The points of a flat shape, or of the base of an extruded footprint.",
      "Lines from which two slopes fall away to opposite sides.",
      "Lines where two slopes meet in an outer corner.",
      "Lines where two slopes, or a slope's foot and a wall, meet in an inner corner.",
      "Level lower borders of slopes.",
      "Inclined borders of slopes.",
      "All faces; standing last it takes the rest."};
  return summaries[static_cast<std::size_t>(selector)];
}

std::optional<Selector> find_selector(std::string_view word) {
  const auto it = std::ranges::find(selector_words, word);
  if (it == selector_words.end()) return std::nullopt;
  return static_cast<Selector>(it - selector_words.begin());
}

namespace {

/// Which of the four sides a direction belongs to; quarters, so that every wall has one.
bool faces_towards(Selector selector, double x, double z) {
  switch (selector) {
    case Selector::front:
      return z > 0 && z >= std::abs(x);
    case Selector::back:
      return z < 0 && -z >= std::abs(x);
    case Selector::right:
      return x > 0 && x > std::abs(z);
    default:
      return x < 0 && -x > std::abs(z);
  }
}

}  // namespace

bool selects(Selector selector, const Shape& face, const Shape& parent) {
  const Vec3 normal = face.scope.z;
  constexpr double steep = 0.7;      // 45 degrees part sides from tops
  constexpr double exact = 0.99999;  // a quarter of a degree
  switch (selector) {
    case Selector::faces:
    case Selector::all:
      return true;
    case Selector::side:
    case Selector::facades:
    case Selector::sidefaces:
      return std::abs(normal.y) <= steep;
    case Selector::top:
      return normal.y > steep;
    case Selector::bottom:
      return normal.y < -steep;
    case Selector::front:
    case Selector::back:
    case Selector::left:
    case Selector::right:
      return std::abs(normal.y) <= steep &&
             faces_towards(selector, dot(normal, parent.scope.x), dot(normal, parent.scope.z));
    case Selector::vertical:
      return std::abs(normal.y) < 1 - exact + 0.004;
    case Selector::horizontal:
      return std::abs(normal.y) > exact;
    case Selector::slanted:
      return std::abs(normal.y) >= 1 - exact + 0.004 && std::abs(normal.y) <= exact;
    case Selector::main:
      return face.tag.has(EdgeTag::main);
    case Selector::street:
      return face.tag.has(EdgeTag::street);
    case Selector::party:
      return face.tag.has(EdgeTag::party);
    case Selector::court:
      return face.tag.has(EdgeTag::court);
    case Selector::cut:
      return face.tag.has(EdgeTag::cut);
    case Selector::corner:
      return face.tag.has(EdgeTag::corner);
    case Selector::edges:
    case Selector::vertices:
    case Selector::ridge:
    case Selector::hip:
    case Selector::valley:
    case Selector::eave:
    case Selector::rake:
      return false;
  }
  return false;
}

bool selects_edge(Selector selector, EdgeTag tag, Vec2 normal) {
  switch (selector) {
    case Selector::main:
      return tag.has(EdgeTag::main);
    case Selector::street:
      return tag.has(EdgeTag::street);
    case Selector::party:
      return tag.has(EdgeTag::party);
    case Selector::court:
      return tag.has(EdgeTag::court);
    case Selector::cut:
      return tag.has(EdgeTag::cut);
    case Selector::corner:
      return tag.has(EdgeTag::corner);
    case Selector::front:
    case Selector::back:
    case Selector::left:
    case Selector::right:
      return faces_towards(selector, normal.x, -normal.y);
    case Selector::bottom:
      return faces_towards(Selector::front, normal.x, -normal.y);
    case Selector::top:
      return faces_towards(Selector::back, normal.x, -normal.y);
    default:
      return true;
  }
}

namespace {

bool chooses_edges(Selector selector) {
  switch (selector) {
    case Selector::faces:
    case Selector::vertical:
    case Selector::horizontal:
    case Selector::slanted:
    case Selector::vertices:
    case Selector::ridge:
    case Selector::hip:
    case Selector::valley:
    case Selector::eave:
    case Selector::rake:
      return false;
    default:
      return true;
  }
}

std::vector<std::string_view> edge_words() {
  std::vector<std::string_view> words;
  for (const std::string_view word : selector_words) {
    if (chooses_edges(*find_selector(word))) words.push_back(word);
  }
  return words;
}

}  // namespace

std::vector<bool> chosen_edges(Context& context, std::size_t argument, const Edges& edges,
                               const Polygon& polygon) {
  std::vector<bool> chosen(polygon.points.size(), false);
  const Value& value = edges.value;
  const std::span<const Value> items =
      value.type == Type::list ? value.list() : std::span<const Value>(&value, 1);
  for (const Value& item : items) {
    if (item.type == Type::number) {
      const bool there = item.number >= 0 && item.number < static_cast<double>(chosen.size());
      if (there) {
        chosen[static_cast<std::size_t>(item.number)] = true;
      } else {
        context.machine.warn(
            "W014", context.at(argument), "a shape has no edge " + number_text(item.number),
            "its edges are numbered from 0 to " + std::to_string(chosen.size() - 1));
      }
      continue;
    }
    const auto selector = item.type == Type::string ? find_selector(item.string()) : std::nullopt;
    if (!selector || !chooses_edges(*selector)) {
      const auto word = item.type == Type::string ? std::string(item.string()) : "this";
      const auto meant = nearest(word, edge_words());
      context.fail(argument, "'" + word + "' chooses no edges",
                   meant ? "did you mean \"" + std::string(*meant) + "\"?"
                         : "words like \"street\", \"party\", \"front\", or the number of an edge");
    }
    for_each_edge(polygon, [&](uint32_t i, Vec2 from, Vec2 to) {
      const Vec2 out = left_of(normalized(to - from)) * -1;
      if (selects_edge(*selector, polygon.tags[i], out)) chosen[i] = true;
    });
  }
  return chosen;
}

}  // namespace mansard
