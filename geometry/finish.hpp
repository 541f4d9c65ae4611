// How a surface shines and feels, beside its colour: the metallic-roughness model of glTF 2.0.
#pragma once

#include <string>

namespace mansard {

/// Pictures are paths, empty for none. All of a surface's pictures repeat together.
struct Finish {
  double roughness = 1;       ///< 0 mirrors, 1 is matt; times the green of its picture
  double metallic = 0;        ///< 0 stone or paint, 1 metal; times the blue of its picture
  double relief = 1;          ///< how far normals lean
  std::string roughness_map;  ///< gray
  std::string metallic_map;   ///< gray
  std::string normal_map;     ///< in the surface's frame, green up

  friend bool operator==(const Finish&, const Finish&) = default;
  bool has_pictures() const {
    return !roughness_map.empty() || !metallic_map.empty() || !normal_map.empty();
  }
};

}  // namespace mansard
