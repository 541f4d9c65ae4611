// What the benchmarks run on: compiled styles and the footprints they are derived from.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "formats/surface_writer.hpp"
#include "geometry/mesh.hpp"
#include "interpreter/derivation.hpp"
#include "styles/library.hpp"

namespace mansard::bench {

/// A path in the sources.
std::string source_path(const std::string& path);
/// Ends the program with a message: a benchmark of something else than it says is worse than none.
[[noreturn]] void refuse(const std::string& why);

/// Meshes from disk, each read once.
class Meshes final : public MeshSource {
 public:
  const Mesh* mesh(const std::string& path, std::string& problem) override;
  bool has_picture(const std::string&) override { return true; }

 private:
  struct Entry {
    std::string path;
    std::unique_ptr<Mesh> mesh;
  };
  std::deque<Entry> known_;
};

/// A style compiled from a script of the sources.
class Compiled {
 public:
  explicit Compiled(const std::string& script, const std::string& style = {});
  const Program& program() const { return *program_; }
  Derivation derivation(const DeriveOptions& options = {}) {
    return Derivation(*program_, meshes_, options);
  }

 private:
  DiskFiles files_;
  Library library_;
  Meshes meshes_;
  std::unique_ptr<Program> program_;
};

/// Equal rectangles side by side, with ids of their own and so with seeds of their own.
std::vector<Footprint> rectangles(std::size_t count, double width, double depth);
std::vector<Footprint> quarter();

/// What writers want to know of a program.
std::vector<std::string_view> symbol_names(const Program& program);
std::vector<Look> looks_of(const Program& program);

}  // namespace mansard::bench
