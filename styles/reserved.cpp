#include "styles/reserved.hpp"

#include <algorithm>
#include <array>

#include "grammar/parse.hpp"

namespace mansard {

std::span<const std::string_view> reserved_names() {
  static constexpr std::array<std::string_view, 27> names{"Shape",
                                                          "scope",
                                                          "split",
                                                          "comp",
                                                          "W",
                                                          "H",
                                                          "D",
                                                          "area",
                                                          "volume",
                                                          "perimeter",
                                                          "inradius",
                                                          "edges",
                                                          "is_rectangle",
                                                          "is_convex",
                                                          "is_planar",
                                                          "facing",
                                                          "slope",
                                                          "elevation",
                                                          "corner",
                                                          "level",
                                                          "index",
                                                          "symbol",
                                                          "seed",
                                                          "BUILDING_HEIGHT",
                                                          "BUILDING_LEVELS",
                                                          "BUILDING_NAME",
                                                          "BUILDING_USE"};
  return names;
}

bool is_reserved(std::string_view name) {
  const auto holds = [name](std::span<const std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
  };
  return holds(reserved_names()) || holds(keywords());
}

}  // namespace mansard
