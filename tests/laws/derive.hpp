// Styles and derivations in a line, for tests of what always holds.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "formats/footprints.hpp"
#include "interpreter/derivation.hpp"
#include "interpreter/program.hpp"
#include "styles/library.hpp"

namespace mansard::test {

/// A script that is linked and compiled, from its text or from a file of the project.
class Script {
 public:
  static Script text(const std::string& text, const CompileOptions& options = {});
  static Script text(const std::string& text, std::unique_ptr<MeshSource> meshes);
  static Script file(const std::string& path, const CompileOptions& options = {});
  static Script files(std::unique_ptr<Files> files, const std::string& path,
                      const CompileOptions& options = {});

  bool good() const { return program_ != nullptr; }
  const std::string& problems() const { return problems_; }  ///< errors as they are printed
  const Program& program() const { return *program_; }
  MeshSource& meshes() const { return *meshes_; }
  uint32_t symbol(std::string_view name) const { return program_->symbols.find(name).value_or(0); }

  Building derive(const Footprint& on, DeriveOptions options = {}) const;
  Building derive(const std::string& literal, DeriveOptions options = {}) const;

 private:
  std::unique_ptr<Files> files_;
  std::unique_ptr<Library> library_;
  std::unique_ptr<MeshSource> meshes_;
  std::unique_ptr<Program> program_;
  std::string problems_;
  static Script compiled(std::unique_ptr<Files> files, const std::string& path,
                         const CompileOptions& options,
                         std::unique_ptr<MeshSource> meshes = std::make_unique<NoMeshes>());
};

/// `rect:10x8` and its like, with neighbours marked.
Footprint footprint(const std::string& literal);

/// f(polygon number, symbol) for every polygon of the surface.
template <class F>
void for_each_polygon(const Surface& surface, F f) {
  std::size_t polygon = 0;
  for (const Surface::Run& run : surface.runs) {
    for (; polygon < run.end; ++polygon) f(polygon, run.symbol);
  }
}

/// Points of every terminal, by its symbol's name: the numbers of symbols depend on the script.
std::map<std::string, std::vector<Vec3>> by_symbol(const Script& script, const Building& building);

double area(const Surface& surface, std::size_t polygon);
double area_of(const Building& building, uint32_t symbol);

}  // namespace mansard::test
