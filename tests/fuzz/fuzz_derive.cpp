// Any bytes as a script, derived on two footprints: only diagnostics may come of it.
#include <cstdint>
#include <map>
#include <string>

#include "interpreter/derivation.hpp"
#include "styles/library.hpp"

namespace {

using namespace mansard;

/// One script and nothing else.
class OneFile final : public Files {
 public:
  explicit OneFile(std::string text) : text_(std::move(text)) {}
  std::optional<std::string> read(const std::string& path) override {
    return exists(path) ? std::optional(text_) : std::nullopt;
  }
  bool exists(const std::string& path) override { return path == "fuzz.style"; }

 private:
  std::string text_;
};

struct OneMesh final : MeshSource {
  Mesh box;
  OneMesh() {
    box.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const uint32_t loop[] = {0, 1, 2, 3};
    box.add_face(loop);
  }
  const Mesh* mesh(const std::string& path, std::string& problem) override {
    problem = "no such file";
    return path.ends_with(".obj") ? &box : nullptr;
  }
  bool has_picture(const std::string& path) override { return path.ends_with(".png"); }
};

Footprint ring() {
  Footprint f;
  f.id = "ring";
  for (const Vec2 p : {Vec2{0, 0}, {12, 0}, {12, 9}, {5, 9}, {5, 14}, {0, 14}})
    f.polygon.add_point(p, {EdgeTag::street, 0});
  f.polygon.close_ring();
  for (const Vec2 p : {Vec2{2, 2}, {2, 5}, {6, 5}, {6, 2}})
    f.polygon.add_point(p, {EdgeTag::court, 1});
  f.polygon.close_ring();
  f.properties = {{"height", std::string("12 m")}, {"building:levels", 3.0}};
  return f;
}

Footprint box() {
  Footprint f;
  f.id = "box";
  f.polygon = rectangle(10, 8);
  return f;
}

void derive(Derivation& derivation, const Footprint& footprint, Building& building) {
  try {
    derivation.derive(footprint, building);
  } catch (const Failure& failure) {
    (void)to_text(failure.diagnostic);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  OneFile files(std::string(reinterpret_cast<const char*>(data), size));
  OneMesh meshes;
  Library library(files);
  Diagnostics diagnostics;
  std::unique_ptr<Program> program;
  if (library.load("fuzz.style", diagnostics)) {
    CompileOptions options;
    options.all_styles = true;
    program = compile(library, meshes, options, diagnostics);
  }
  for (const Diagnostic& d : diagnostics.all()) (void)to_text(d);
  if (!program) return 0;
  DeriveOptions options;
  options.max_depth = 100;
  options.max_shapes = 3000;
  Derivation derivation(*program, meshes, options);
  Building building;
  derive(derivation, box(), building);
  derive(derivation, ring(), building);
  return 0;
}
