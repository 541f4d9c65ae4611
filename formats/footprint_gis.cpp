// Footprints through the module mansard_gis.
#include "formats/footprint_sources.hpp"
#include "formats/gis_module.hpp"
#include "formats/module.hpp"

namespace mansard {
namespace {

RawSet read(const GisRequest& request) {
  RawSet set;
  GisProblem problem;
  std::string missing;
  const auto door = reinterpret_cast<decltype(&mansard_read_gis)>(
      module_symbol("mansard_gis", "mansard_read_gis", missing));
  if (door == nullptr) {
    problem.text = "can not load the reader of GIS files";
    problem.detail = missing;
  } else if (door(request, set, problem)) {
    return set;
  }
  Diagnostic d;
  d.text = problem.text;
  d.help = problem.help;
  if (!problem.detail.empty()) d.notes.push_back({problem.detail, {}});
  const std::vector<std::string_view> candidates(problem.candidates.begin(),
                                                 problem.candidates.end());
  if (const auto near = nearest(problem.word, candidates)) {
    d.help = "did you mean '" + std::string(*near) + "'?" + (d.help.empty() ? "" : " ") + d.help;
  }
  throw Failure(std::move(d));
}

}  // namespace

RawSet read_gis(const std::string& path, const FootprintOptions& options) {
  return read({path, options.layer, options.where, options.id});
}

RawSet read_gis_lines(const std::string& path, const StreetOptions& options,
                      const FootprintFacts& beside) {
  return read(
      {path, options.layer, options.where, "", GisRequest::Beside{beside.reference, beside.shift}});
}

}  // namespace mansard
