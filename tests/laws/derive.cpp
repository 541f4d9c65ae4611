#include "tests/laws/derive.hpp"

#include <doctest/doctest.h>

namespace mansard::test {
namespace {

class OneText final : public Files {
 public:
  explicit OneText(std::string text) : text_(std::move(text)) {}
  std::optional<std::string> read(const std::string& path) override {
    if (path != "test.style") return std::nullopt;
    return text_;
  }
  bool exists(const std::string& path) override { return path == "test.style"; }

 private:
  std::string text_;
};

}  // namespace

Script Script::text(const std::string& text, const CompileOptions& options) {
  return compiled(std::make_unique<OneText>(text), "test.style", options);
}

Script Script::text(const std::string& text, std::unique_ptr<MeshSource> meshes) {
  return compiled(std::make_unique<OneText>(text), "test.style", {}, std::move(meshes));
}

Script Script::file(const std::string& path, const CompileOptions& options) {
  return compiled(std::make_unique<DiskFiles>(), std::string(MANSARD_ROOT) + "/" + path, options);
}

Script Script::files(std::unique_ptr<Files> files, const std::string& path,
                     const CompileOptions& options) {
  return compiled(std::move(files), path, options);
}

Script Script::compiled(std::unique_ptr<Files> files, const std::string& path,
                        const CompileOptions& options, std::unique_ptr<MeshSource> meshes) {
  Script script;
  script.files_ = std::move(files);
  script.library_ = std::make_unique<Library>(
      *script.files_, std::vector<std::string>{MANSARD_ROOT "/styles/library"});
  script.meshes_ = std::move(meshes);
  Diagnostics diagnostics;
  if (script.library_->load(path, diagnostics) && !diagnostics.has_errors()) {
    script.program_ = compile(*script.library_, *script.meshes_, options, diagnostics);
  }
  for (const Diagnostic& d : diagnostics.all()) {
    if (d.severity == Severity::error) script.problems_ += to_text(d, false);
  }
  CHECK_MESSAGE(script.good(), script.problems_);
  return script;
}

Building Script::derive(const Footprint& on, DeriveOptions options) const {
  Derivation derivation(*program_, *meshes_, options);
  Building building;
  derivation.derive(on, building);
  return building;
}

Building Script::derive(const std::string& literal, DeriveOptions options) const {
  return derive(footprint(literal), options);
}

Footprint footprint(const std::string& literal) {
  FootprintSet set = read_footprints(literal, {});
  mark_neighbours(set.footprints);
  return set.footprints.at(0);
}

std::map<std::string, std::vector<Vec3>> by_symbol(const Script& script, const Building& building) {
  std::map<std::string, std::vector<Vec3>> points;
  for_each_polygon(building.surface, [&](std::size_t polygon, uint32_t symbol) {
    auto& of = points[std::string(script.program().symbols[symbol])];
    const auto loop = building.surface.loop(polygon);
    of.insert(of.end(), loop.begin(), loop.end());
  });
  return points;
}

double area(const Surface& surface, std::size_t polygon) {
  return length(newell(surface.loop(polygon))) / 2;
}

double area_of(const Building& building, uint32_t symbol) {
  double sum = 0;
  for_each_polygon(building.surface, [&](std::size_t polygon, uint32_t of) {
    if (of == symbol) sum += area(building.surface, polygon);
  });
  return sum;
}

}  // namespace mansard::test
