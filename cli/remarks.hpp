// What every command that derives tells of it: warnings at once, what was counted at the end.
#pragma once

#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "cli/session.hpp"
#include "interpreter/building.hpp"

namespace mansard {

/// What has been said once a run of one place is not said again.
class Remarks {
 public:
  explicit Remarks(const Session& session) : session_(session) {}

  void print(std::span<const Diagnostic> diagnostics);
  /// Prints the building's warnings and what print() said, and counts the rest.
  void add(const Building& building);
  /// Says what was counted since the last time, of buildings of one program: parts that were cut,
  /// `fits` that never held, splits that never snapped, roofs made otherwise. `where` comes first:
  /// "in the picture 'x' ".
  void finish(const Program& program, const std::string& where = {});

 private:
  void add_snap_split(const SnapSplit& split);
  void tell_cuts(const std::string& where);
  void tell_snap_splits(const std::string& where);
  void tell_roofs(const std::string& where);
  void tell_misfits(const Program& program, const RuleSet& rules, const std::string& where);
  bool is_news(std::string_view kind, Span at);

  const Session& session_;
  std::vector<CutSplit> cuts_;          ///< by place
  std::vector<SnapSplit> snap_splits_;  ///< likewise
  std::vector<std::size_t> taken_;      ///< by production
  RoofTroubles roofs_;
  std::set<std::tuple<std::string, const Source*, uint32_t, std::string>> said_;
};

}  // namespace mansard
