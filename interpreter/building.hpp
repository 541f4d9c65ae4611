// The result of a derivation: one building's surfaces, its shape tree and what was counted.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/streaks.hpp"
#include "grammar/diagnostic.hpp"
#include "interpreter/axes.hpp"
#include "interpreter/material.hpp"
#include "interpreter/natural_size.hpp"
#include "interpreter/shape.hpp"

namespace mansard {

/// Values given to report(key, value) under one key.
struct ReportEntry {
  std::size_t count = 0;
  double sum = 0, least = 0, most = 0;         ///< of numbers
  std::map<std::string, std::size_t> strings;  ///< how often each text came
};

/// A split that had too little room.
struct CutSplit {
  Span at;                  ///< its sizes
  std::string_view symbol;  ///< whose rule it is; lives as long as the script
  std::size_t parts = 0;    ///< cut or left out
};

/// A split whose axis snaps, by place.
struct SnapSplit {
  Span at;                      ///< its axis
  std::string_view symbol;      ///< whose rule it is; lives as long as the script
  std::optional<uint64_t> to;   ///< hash_of the label that it asked for last
  std::size_t shapes = 0;       ///< that were split
  std::size_t with_planes = 0;  ///< of these, where there were planes to choose from
  std::size_t with_lines = 0;   ///< of these, where some plane crosses the shape
  bool late = false;            ///< planes were recorded, but no sooner than it was split
};

/// A split that snapped, and the lines that it saw.
struct Snapping {
  struct Line {
    double at = 0;
    bool used = false;
    std::string by;
  };
  uint32_t node = Shape::none;
  std::string split;
  std::vector<Line> lines;
};

/// What came of a size ':'.
struct MeasuredPart {
  uint32_t node = Shape::none;  ///< whose rule split itself
  Span split;                   ///< the operation's name
  Axis axis = Axis::x;
  std::size_t part = 0;  ///< which of its parts
  NaturalSize natural;
  double got = 0;  ///< metres
};

/// What a shape asked about others: an expression, what came of it and which solids decided.
struct Answer {
  uint32_t node = Shape::none;
  std::string asked, answer, why;
};
/// Shapes that were answered together.
struct Round {
  int stage = 0;
  std::size_t shapes = 0;
  std::vector<Answer> answers;
  std::vector<Snapping> snappings;
};

struct TreeNode {
  Shape shape;
  uint32_t parent = Shape::none;
  bool terminal = false;
};

/// Roofs that are not quite as asked, by reason.
struct RoofTroubles {
  std::size_t coarser = 0;    ///< built on an outline coarser by centimetres
  std::size_t one_ridge = 0;  ///< one ridge over the whole instead of a skeleton's
  std::size_t flat = 0;       ///< nothing but a flat roof could be built
  std::size_t no_apex = 0;    ///< pyramids that became hips
  std::size_t no_break = 0;   ///< roofs of two slopes that have one
  std::size_t low = 0;        ///< height below twice the thickness: a thinner edge

  /// Roofs that a simpler construction had to make.
  std::size_t fallbacks() const { return coarser + one_ridge + flat; }
  void add(const RoofTroubles& other) {
    coarser += other.coarser;
    one_ridge += other.one_ridge;
    flat += other.flat;
    no_apex += other.no_apex;
    no_break += other.no_break;
    low += other.low;
  }
};

/// Reused from building to building: clear() keeps the capacity.
struct Building {
  std::string id;
  Surface surface;  ///< runs carry Program symbols, and materials: first the program's, then
                    ///< `materials`
  std::vector<Material> materials;     ///< looks that only this building has
  std::vector<Drip> drips;             ///< what rain runs off, where stain() asks
  std::vector<TreeNode> tree;          ///< depth-first, only when DeriveOptions::keep_tree
  std::vector<Round> rounds;           ///< likewise
  std::vector<MeasuredPart> measures;  ///< likewise
  std::vector<uint32_t> terminals;     ///< how many, by symbol
  std::vector<uint32_t> taken;         ///< how often, by production of the program
  std::vector<CutSplit> cuts;
  std::vector<SnapSplit> snap_splits;
  std::map<std::string, ReportEntry> report;
  std::vector<std::string> printed;  ///< by print()
  std::vector<Diagnostic> warnings;
  std::size_t shapes = 0, operations = 0;
  std::size_t copied = 0;     ///< of the shapes, those of parts that were derived before
  std::size_t parts_cut = 0;  ///< split parts cut or left out for want of room
  std::size_t unmatched = 0;  ///< shapes for which no production was a candidate
  RoofTroubles roofs;

  void clear() {
    id.clear();
    surface.clear();
    materials.clear();
    drips.clear();
    tree.clear();
    rounds.clear();
    measures.clear();
    std::fill(terminals.begin(), terminals.end(), 0);
    std::fill(taken.begin(), taken.end(), 0);
    cuts.clear();
    snap_splits.clear();
    report.clear();
    printed.clear();
    warnings.clear();
    shapes = operations = copied = parts_cut = unmatched = 0;
    roofs = {};
  }
};

}  // namespace mansard
