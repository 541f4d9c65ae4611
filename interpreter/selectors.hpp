// The words that choose faces and edges.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "interpreter/machine.hpp"

namespace mansard {

enum class Selector : uint8_t {
  faces,
  side,
  facades,
  sidefaces,
  front,
  back,
  left,
  right,
  top,
  bottom,
  vertical,
  horizontal,
  slanted,
  main,
  street,
  party,
  court,
  cut,
  corner,
  edges,
  vertices,
  ridge,
  hip,
  valley,
  eave,
  rake,
  all
};
inline constexpr std::array<std::string_view, 27> selector_words{
    "faces",  "side",     "facades",    "sidefaces", "front", "back",   "left",  "right", "top",
    "bottom", "vertical", "horizontal", "slanted",   "main",  "street", "party", "court", "cut",
    "corner", "edges",    "vertices",   "ridge",     "hip",   "valley", "eave",  "rake",  "all"};

/// One sentence on each of selector_words, for editors.
std::string_view selector_summary(Selector selector);

std::optional<Selector> find_selector(std::string_view word);

/// Programs intern NIL first and then these words, so that a label's number says its selector.
constexpr std::optional<Selector> selector_of(uint32_t symbol) {
  if (symbol == 0 || symbol > selector_words.size()) return std::nullopt;
  return static_cast<Selector>(symbol - 1);
}

/// Does the face belong? `parent` gives the frame of front, back, left and right.
bool selects(Selector selector, const Shape& face, const Shape& parent);
/// Does edge `tag` with outward direction `normal` (in the frame of the flat shape: x right, y into
/// the depth or up the face) belong?
bool selects_edge(Selector selector, EdgeTag tag, Vec2 normal);

/// One flag for each edge of the polygon, by the words and numbers of an argument. Fails for words
/// that choose no edges.
std::vector<bool> chosen_edges(Context& context, std::size_t argument, const Edges& edges,
                               const Polygon& polygon);

}  // namespace mansard
