#include "cli/remarks.hpp"

#include <algorithm>
#include <utility>

#include "grammar/codes.hpp"

namespace mansard {
namespace {

/// "house.style:19"
std::string place(Span at) {
  return at.source->name() + ":" + std::to_string(at.source->line_of(at.begin));
}

}  // namespace

void Remarks::print(std::span<const Diagnostic> diagnostics) {
  for (const Diagnostic& d : diagnostics) {
    const std::string text = d.code.empty() || each_text_is_news(d.code) ? d.text : "";
    if (said_.emplace(std::string(d.code), d.at.source, d.at.begin, text).second) session_.print(d);
  }
}

void Remarks::add(const Building& building) {
  print(building.warnings);
  for (const std::string& line : building.printed) session_.say(building.id + ": " + line);
  roofs_.add(building.roofs);
  taken_.resize(building.taken.size());
  for (std::size_t i = 0; i < taken_.size(); ++i) taken_[i] += building.taken[i];
  for (const CutSplit& cut : building.cuts) {
    const auto known = std::ranges::find(cuts_, cut.at, &CutSplit::at);
    if (known == cuts_.end()) {
      cuts_.push_back(cut);
    } else {
      known->parts += cut.parts;
    }
  }
  for (const SnapSplit& split : building.snap_splits) add_snap_split(split);
}

void Remarks::add_snap_split(const SnapSplit& split) {
  const auto known = std::ranges::find(snap_splits_, split.at, &SnapSplit::at);
  if (known == snap_splits_.end()) return snap_splits_.push_back(split);
  known->shapes += split.shapes;
  known->with_planes += split.with_planes;
  known->with_lines += split.with_lines;
  known->late = known->late || split.late;
}

bool Remarks::is_news(std::string_view kind, Span at) {
  return said_.emplace(std::string(kind), at.source, at.begin, "").second;
}

void Remarks::finish(const Program& program, const std::string& where) {
  if (!cuts_.empty()) tell_cuts(where);
  if (!taken_.empty()) {
    for (const RuleSet& rules : program.rule_sets) tell_misfits(program, rules, where);
  }
  tell_snap_splits(where);
  tell_roofs(where);
  cuts_.clear();
  snap_splits_.clear();
  taken_.clear();
  roofs_ = {};
}

/// "note: 3 roofs had to be made by a simpler construction: 2 coarser, 1 flat".
void Remarks::tell_roofs(const std::string& where) {
  using Reason = std::pair<std::size_t, std::string_view>;
  const auto tell = [&](std::string_view what, std::initializer_list<Reason> reasons) {
    std::size_t sum = 0;
    std::string list;
    for (const auto& [count, reason] : reasons) {
      sum += count;
      if (count > 0)
        list += (list.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(reason);
    }
    if (sum > 0 && is_news(what, {}))
      session_.say("note: " + where + std::to_string(sum) + (sum == 1 ? " roof " : " roofs ") +
                   std::string(what) + ": " + list);
  };
  tell("had to be made by a simpler construction",
       {{roofs_.coarser, "on an outline coarser by centimetres"},
        {roofs_.one_ridge, "with one ridge over the whole"},
        {roofs_.flat, "flat"}});
  tell("could not have all that was asked", {{roofs_.no_apex, "without a pyramid's point"},
                                             {roofs_.no_break, "without a break"},
                                             {roofs_.low, "with a thinner edge"}});
}

/// The places where most were cut.
void Remarks::tell_cuts(const std::string& where) {
  constexpr std::size_t most_places = 3;
  std::ranges::stable_sort(cuts_, std::greater<>(), &CutSplit::parts);
  if (!is_news("cuts", cuts_.front().at)) return;
  std::size_t all = 0;
  for (const CutSplit& cut : cuts_) all += cut.parts;
  std::string places;
  for (std::size_t i = 0; i < std::min(cuts_.size(), most_places); ++i) {
    places += (i == 0 ? "" : ", ") +
              (cuts_.size() == 1 ? "" : std::to_string(cuts_[i].parts) + " ") + "in '" +
              std::string(cuts_[i].symbol) + "' (" + place(cuts_[i].at) + ")";
  }
  session_.say("note: " + where + std::to_string(all) +
               (all == 1 ? " part of a split was" : " parts of splits were") +
               " cut for want of room: " + places + (cuts_.size() > most_places ? ", …" : ""));
}

/// Splits that snap and met no line in all of a run.
void Remarks::tell_snap_splits(const std::string& where) {
  for (const SnapSplit& split : snap_splits_) {
    if (split.with_lines > 0 || !is_news("snaps", split.at)) continue;
    const auto symbol = "'" + std::string(split.symbol) + "'";
    std::string why = "no plane was recorded, and no other mass meets its own";
    if (split.to) why = "no plane and no mass that meets its own has this label";
    if (split.late)
      why = "planes were recorded, but not before its round; a later @stage of " + symbol +
            " sees them";
    if (split.with_planes > 0)
      why = "no plane crosses " + (split.shapes == 1
                                       ? "its shape"
                                       : "any of its " + std::to_string(split.shapes) + " shapes");
    session_.say("note: " + where + std::string(split.at.text()) + " in " + symbol + " (" +
                 place(split.at) + ") snapped to nothing: " + why);
  }
}

/// Where `fits` held for no shape, and no other condition of the symbol did.
void Remarks::tell_misfits(const Program& program, const RuleSet& rules, const std::string& where) {
  const Production* asks = nullptr;
  std::size_t shapes = 0;
  for (uint32_t i = rules.first; i < rules.first + rules.count; ++i) {
    const Production& p = program.productions[i];
    if (p.guard != none && taken_[i] > 0) return;
    if (p.asks_fits && !asks) asks = &p;
    shapes += taken_[i];
  }
  if (!asks || shapes == 0 || !is_news("fits", asks->syntax->head)) return;
  session_.say(
      "note: " + where + "'" + std::string(asks->syntax->head.text()) + "' (" +
      place(asks->syntax->head) + ") held for " +
      (shapes == 1 ? "no shape: there was one" : "none of " + std::to_string(shapes) + " shapes"));
}

}  // namespace mansard
