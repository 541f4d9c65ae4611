// The result of a derivation: one building's surfaces, its shape tree and what was counted.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "grammar/diagnostic.hpp"
#include "interpreter/material.hpp"
#include "interpreter/shape.hpp"

namespace mansard {

/// Values given to report(key, value) under one key.
struct ReportEntry {
  std::size_t count = 0;
  double sum = 0, least = 0, most = 0;         ///< of numbers
  std::map<std::string, std::size_t> strings;  ///< how often each text came
};

struct TreeNode {
  Shape shape;
  uint32_t parent = Shape::none;
  bool terminal = false;
};

/// Reused from building to building: clear() keeps the capacity.
struct Building {
  std::string id;
  Surface surface;  ///< runs carry Program symbols, and materials: first the program's, then
                    ///< `materials`
  std::vector<Material> materials;  ///< looks that only this building has
  std::vector<TreeNode> tree;       ///< depth-first, only when DeriveOptions::keep_tree
  std::vector<uint32_t> terminals;  ///< how many, by symbol
  std::map<std::string, ReportEntry> report;
  std::vector<std::string> printed;  ///< by print()
  std::vector<Diagnostic> warnings;
  std::size_t shapes = 0, operations = 0;
  std::size_t parts_cut = 0;       ///< split parts cut or left out for want of room
  std::size_t unmatched = 0;       ///< shapes for which no production was a candidate
  std::size_t roof_fallbacks = 0;  ///< roofs that a simpler construction had to make

  void clear() {
    id.clear();
    surface.clear();
    materials.clear();
    tree.clear();
    std::fill(terminals.begin(), terminals.end(), 0);
    report.clear();
    printed.clear();
    warnings.clear();
    shapes = operations = parts_cut = unmatched = roof_fallbacks = 0;
  }
};

}  // namespace mansard
