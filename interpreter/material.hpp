// How a terminal looks.
#pragma once

#include <string>
#include <string_view>

#include "geometry/finish.hpp"
#include "geometry/mesh.hpp"

namespace mansard {

struct Material {
  std::string name;
  Vec3 color{0.8, 0.8, 0.8};  ///< sRGB, 0..1
  double opacity = 1;
  std::string texture;  ///< path of the picture that colours `color`, empty for none
  Vec2 metres{1, 1};    ///< of wall that one repeat of the pictures covers
  Finish finish = {};
  bool stains = false;  ///< lies before another surface, as opaque as its picture is white

  bool has_pictures() const { return !texture.empty() || finish.has_pictures(); }
  friend bool operator==(const Material&, const Material&) = default;
};

/// "#rgb", "#rrggbb" or a CSS colour name, as sRGB; false for other text.
bool parse_color(std::string_view text, Vec3& color);

/// Of a mesh's own file, whose colours are linear. What is seen only by its picture's opacity stays
/// plain.
Material material_from(const Mesh::Material& own);

}  // namespace mansard
