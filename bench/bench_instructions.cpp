// One kind of work, so many times, for bench/instructions to count the instructions of:
//     bench_instructions NAME TIMES
// It prints how many shapes were made or written, and the compiler, as JSON.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "bench/workload.hpp"
#include "formats/surface_writer.hpp"

namespace mansard::bench {
namespace {

namespace fs = std::filesystem;

std::size_t derive(const char* script, const char* name, const std::vector<Footprint>& footprints,
                   std::size_t rounds, const DeriveOptions& options = {}) {
  Compiled style(script, name);
  Derivation derivation = style.derivation(options);
  Building building;
  std::size_t shapes = 0;
  for (std::size_t i = 0; i < rounds; ++i) {
    for (const Footprint& footprint : footprints) {
      derivation.derive(footprint, building);
      shapes += building.shapes;
    }
  }
  return shapes;
}

std::size_t thesis_by_61(std::size_t times) {
  return derive("bench/thesis.style", "ThesisBy61", rectangles(times, 10, 8), 1);
}
std::size_t thesis_by_610(std::size_t times) {
  return derive("bench/thesis.style", "ThesisBy610", rectangles(times, 10, 8), 1);
}
std::size_t facade_box(std::size_t times) {
  return derive("bench/facade_box.style", "", rectangles(times, 10, 8), 1);
}
/// Each of its parts derived for itself.
std::size_t facade_box_apart(std::size_t times) {
  return derive("bench/facade_box.style", "", rectangles(times, 10, 8), 1, {.share_parts = false});
}
std::size_t quarter_houses(std::size_t times) {
  return derive("examples/quarter/quarter.style", "", quarter(), times);
}
std::size_t quarter_apart(std::size_t times) {
  return derive("examples/quarter/quarter.style", "", quarter(), times, {.share_parts = false});
}

/// One facade box that is derived once and written so often: writing alone.
template <class Open>
std::size_t write(std::size_t times, const char* ending, Open open) {
  Compiled style("bench/facade_box.style");
  Building building;
  style.derivation().derive(rectangles(1, 10, 8)[0], building);
  const auto symbols = symbol_names(style.program());
  const auto looks = looks_of(style.program());
  const fs::path folder =
      fs::temp_directory_path() / ("mansard_instructions_" + std::to_string(::getpid()));
  fs::create_directory(folder);
  {
    const auto writer = open((folder / "boxes").string() + ending);
    for (std::size_t i = 0; i < times; ++i) {
      const std::string id = "plot " + std::to_string(i);
      writer->add({id, &building.surface}, symbols, looks);
    }
    writer->finish(looks);
  }
  fs::remove_all(folder);
  return times * building.shapes;
}

std::size_t write_boxes_obj(std::size_t times) {
  return write(times, ".obj",
               [](const std::string& path) { return write_obj(path, Up::y, "benchmark"); });
}
std::size_t write_boxes_glb(std::size_t times) {
  return write(times, ".glb",
               [](const std::string& path) { return write_gltf(path, "benchmark"); });
}

struct Work {
  std::string_view name;
  std::size_t (*run)(std::size_t times);
};
constexpr std::array all{
    Work{"facade_box", facade_box},           Work{"thesis_by_61", thesis_by_61},
    Work{"thesis_by_610", thesis_by_610},     Work{"facade_box_apart", facade_box_apart},
    Work{"quarter_houses", quarter_houses},   Work{"quarter_apart", quarter_apart},
    Work{"write_boxes_obj", write_boxes_obj}, Work{"write_boxes_glb", write_boxes_glb}};

int main(std::span<char*> words) {
  const auto work = std::ranges::find(all, words.size() == 3 ? words[1] : "", &Work::name);
  if (work == all.end()) refuse("bench_instructions NAME TIMES");
  const std::string_view number = words[2];
  std::size_t times = 0;
  std::from_chars(number.data(), number.data() + number.size(), times);
  std::printf("{\"shapes\": %zu, \"compiler\": \"%s\"}\n", work->run(times), __VERSION__);
  return 0;
}

}  // namespace
}  // namespace mansard::bench

int main(int count, char** words) {
  return mansard::bench::main({words, static_cast<std::size_t>(count)});
}
