#include "bench/workload.hpp"

#include <cstdio>
#include <cstdlib>

#include "formats/footprints.hpp"
#include "formats/meshes.hpp"
#include "geometry/solids.hpp"

namespace mansard::bench {

std::string source_path(const std::string& path) { return MANSARD_SOURCES "/" + path; }

void refuse(const std::string& why) {
  std::fprintf(stderr, "bench: %s\n", why.c_str());
  std::exit(1);
}

/// ball.obj is no file: a sphere of 100,000 faces.
const Mesh* Meshes::mesh(const std::string& path, std::string& problem) {
  for (const Entry& entry : known_) {
    if (entry.path == path) return entry.mesh.get();
  }
  auto read = path.ends_with("/ball.obj") ? std::optional<Mesh>(sphere({1, 1, 1}, 448))
                                          : read_mesh(path, problem);
  known_.push_back({path, read ? std::make_unique<Mesh>(*std::move(read)) : nullptr});
  return known_.back().mesh.get();
}

Compiled::Compiled(const std::string& script, const std::string& style)
    : library_(files_, {source_path("styles/library")}) {
  Diagnostics diagnostics;
  CompileOptions options;
  options.style = style;
  if (library_.load(source_path(script), diagnostics) && !diagnostics.has_errors()) {
    program_ = compile(library_, meshes_, options, diagnostics);
  }
  if (program_) return;
  for (const Diagnostic& d : diagnostics.all()) std::fputs(to_text(d).c_str(), stderr);
  refuse("'" + script + "' does not compile");
}

std::vector<Footprint> rectangles(std::size_t count, double width, double depth) {
  std::vector<Footprint> all;
  constexpr std::size_t row = 40;
  constexpr double gap = 4;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i % row) * (width + gap);
    const std::size_t rows_before = i / row;
    const double y = static_cast<double>(rows_before) * (depth + gap);
    Footprint& footprint = all.emplace_back();
    footprint.id = "plot " + std::to_string(i);
    footprint.polygon = rectangle(width, depth);
    for (Vec2& p : footprint.polygon.points) p = p + Vec2{x, y};
  }
  return all;
}

std::vector<Footprint> quarter() {
  auto set = read_footprints(source_path("examples/quarter/footprints.geojson"), {});
  mark_neighbours(set.footprints);
  return std::move(set.footprints);
}

std::vector<std::string_view> symbol_names(const Program& program) {
  std::vector<std::string_view> names;
  for (uint32_t i = 0; i < program.symbols.size(); ++i) names.push_back(program.symbols[i]);
  return names;
}

std::vector<Look> looks_of(const Program& program) {
  std::vector<Look> looks;
  for (const Material& m : program.materials) looks.push_back({m.name, m.color, m.opacity, {}});
  return looks;
}

}  // namespace mansard::bench
