// What --report writes.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "formats/output_file.hpp"
#include "interpreter/building.hpp"
#include "interpreter/program.hpp"

namespace mansard {

class Report;

/// A model that was written.
struct LevelReport {
  int lod = 3;
  std::string path;
  std::size_t bytes = 0;
  double seconds = 0;  ///< of deriving and writing
  const Report* report = nullptr;
};

/// What of a building's faces the report tells.
struct Faces {
  /// On any thread.
  void count(const Surface& surface, uint32_t stain_look);

  std::vector<double> areas;  ///< m² by symbol, as far as there are any
  std::size_t stains = 0;
};

class Report {
 public:
  explicit Report(const Program& program)
      : program_(program), terminals_(program.symbols.size()), areas_(program.symbols.size()) {}
  void add(const Building& building, const Faces& faces, const Polygon& footprint);
  void add_failure(const std::string& id, const Diagnostic& diagnostic);
  /// `levels` are the models that were written, this report's among them.
  void write(OutputFile& file, std::span<const LevelReport> levels) const;

  std::size_t shapes = 0, operations = 0, polygons = 0, vertices = 0, buildings = 0;
  std::size_t parts_cut = 0, unmatched = 0;
  std::size_t stains = 0;                  ///< faces that stain() laid on walls
  std::size_t walls = 0, party_walls = 0;  ///< edges of footprints
  std::size_t dropped = 0;                 ///< footprints left out as too small
  RoofTroubles roofs;

 private:
  const Program& program_;
  std::vector<std::size_t> terminals_;
  std::vector<double> areas_;
  std::map<std::string, ReportEntry> values_;
  std::vector<std::pair<std::string, std::string>> failures_;
};

}  // namespace mansard
