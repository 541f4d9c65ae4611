// Colours are sRGB in styles and MTL, linear in meshes and glTF (IEC 61966-2-1).
#pragma once

#include <cmath>

namespace mansard {

inline double to_linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

}  // namespace mansard
