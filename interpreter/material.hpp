// How a terminal looks.
#pragma once

#include <string>
#include <string_view>

#include "geometry/mesh.hpp"

namespace mansard {

struct Material {
  std::string name;
  Vec3 color{0.8, 0.8, 0.8};  ///< sRGB, 0..1
  double opacity = 1;
  std::string texture;  ///< path of the picture, empty for none
  Vec2 metres{1, 1};    ///< of wall that one repeat of the texture covers
};

/// "#rgb", "#rrggbb" or a CSS colour name, as sRGB; false for other text.
bool parse_color(std::string_view text, Vec3& color);

/// Of a mesh's own file, whose colours are linear.
Material material_from(const Mesh::Material& own);

}  // namespace mansard
