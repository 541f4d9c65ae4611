#include "cli/report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace mansard {

void Faces::count(const Surface& surface, uint32_t stain_look) {
  areas.clear();
  stains = 0;
  std::size_t polygon = 0;
  for (const Surface::Run& run : surface.runs) {
    if (run.symbol >= areas.size()) areas.resize(run.symbol + 1);
    if (run.material == stain_look) stains += run.end - polygon;
    for (; polygon < run.end; ++polygon)
      areas[run.symbol] += length(newell(surface.loop(polygon))) / 2;
  }
}

void Report::add(const Building& building, const Faces& faces, const Polygon& footprint) {
  ++buildings;
  walls += footprint.tags.size();
  party_walls += static_cast<std::size_t>(
      std::ranges::count_if(footprint.tags, [](EdgeTag tag) { return tag.has(EdgeTag::party); }));
  shapes += building.shapes;
  operations += building.operations;
  polygons += building.surface.polygons();
  vertices += building.surface.points.size();
  parts_cut += building.parts_cut;
  unmatched += building.unmatched;
  roofs.add(building.roofs);
  for (std::size_t i = 0; i < building.terminals.size(); ++i)
    terminals_[i] += building.terminals[i];
  for (std::size_t i = 0; i < faces.areas.size(); ++i) areas_[i] += faces.areas[i];
  stains += faces.stains;
  for (const auto& [key, entry] : building.report) {
    ReportEntry& sum = values_[key];
    sum.least = sum.count == 0 ? entry.least : std::min(sum.least, entry.least);
    sum.most = sum.count == 0 ? entry.most : std::max(sum.most, entry.most);
    sum.count += entry.count;
    sum.sum += entry.sum;
    for (const auto& [text, count] : entry.strings) sum.strings[text] += count;
  }
}

void Report::add_failure(const std::string& id, const Diagnostic& diagnostic) {
  failures_.emplace_back(id, diagnostic.text);
}

namespace {

using nlohmann::ordered_json;

ordered_json to_json(std::span<const LevelReport> levels) {
  ordered_json all = ordered_json::array();
  for (const LevelReport& level : levels)
    all.push_back({{"lod", level.lod},
                   {"model", level.path},
                   {"bytes", level.bytes},
                   {"shapes", level.report->shapes},
                   {"polygons", level.report->polygons},
                   {"vertices", level.report->vertices},
                   {"seconds", level.seconds}});
  return all;
}

}  // namespace

void Report::write(OutputFile& file, std::span<const LevelReport> levels) const {
  double seconds = 0;
  for (const LevelReport& level : levels) seconds += level.seconds;
  ordered_json json;
  json["buildings"] = buildings;
  json["failed"] = ordered_json::array();
  for (const auto& [id, text] : failures_) json["failed"].push_back({{"id", id}, {"error", text}});
  json["dropped_small"] = dropped;
  json["walls"] = walls;
  json["party_walls"] = party_walls;
  json["shapes"] = shapes;
  json["operations"] = operations;
  json["polygons"] = polygons;
  json["vertices"] = vertices;
  json["seconds"] = seconds;
  json["levels"] = to_json(levels);
  json["parts_cut"] = parts_cut;
  json["shapes_without_production"] = unmatched;
  json["stains"] = stains;
  json["roof_fallbacks"] = roofs.fallbacks();
  json["roofs_not_as_asked"] = {
      {"coarser_outline", roofs.coarser}, {"one_ridge", roofs.one_ridge}, {"flat", roofs.flat},
      {"no_apex", roofs.no_apex},         {"no_break", roofs.no_break},   {"low", roofs.low}};
  json["terminals"] = ordered_json::object();
  for (uint32_t i = 0; i < terminals_.size(); ++i) {
    if (terminals_[i] == 0) continue;
    json["terminals"][std::string(program_.symbols[i])] = {{"count", terminals_[i]},
                                                           {"area", areas_[i]}};
  }
  json["report"] = ordered_json::object();
  for (const auto& [key, entry] : values_) {
    ordered_json value{{"count", entry.count}};
    if (entry.strings.empty()) {
      value["sum"] = entry.sum;
      value["min"] = entry.least;
      value["max"] = entry.most;
      value["average"] = entry.sum / static_cast<double>(entry.count);
    } else {
      value["values"] = entry.strings;
    }
    json["report"][key] = value;
  }
  const std::string text = json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
  file.put(text);
  file.commit();
}

}  // namespace mansard
