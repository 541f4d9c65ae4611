// Buildings from footprints, and files from buildings. One thread.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <span>

#include "bench/workload.hpp"
#include "formats/surface_writer.hpp"

namespace mansard::bench {
namespace {

/// What a derivation can not do without writing.
std::size_t bytes_of(const Surface& surface) {
  const auto bytes = [](const auto& all) { return std::span(all).size_bytes(); };
  return bytes(surface.points) + bytes(surface.uvs) + bytes(surface.normals) + bytes(surface.ends) +
         bytes(surface.runs) + bytes(surface.placed);
}

struct Sums {
  std::size_t buildings = 0, shapes = 0, operations = 0, vertices = 0, bytes = 0;

  void add(const Building& building) {
    ++buildings;
    shapes += building.shapes;
    operations += building.operations;
    vertices += building.surface.points.size();
    bytes += bytes_of(building.surface);
  }
  void report(benchmark::State& state) const {
    const auto rate = [](std::size_t n) {
      return benchmark::Counter(static_cast<double>(n), benchmark::Counter::kIsRate);
    };
    const auto each = [&](std::size_t n) {
      return static_cast<double>(n) / static_cast<double>(buildings);
    };
    state.counters["buildings/s"] = rate(buildings);
    state.counters["shapes/s"] = rate(shapes);
    state.counters["operations/s"] = rate(operations);
    state.counters["shapes"] = each(shapes);
    state.counters["operations"] = each(operations);
    state.counters["vertices"] = each(vertices);
    state.counters["bytes"] = each(bytes);
  }
};

/// Memory of this program that is in the machine's, in kB.
double resident() {
  std::ifstream file("/proc/self/statm");
  double size = 0, pages = 0;
  file >> size >> pages;
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1024;
}

/// After one round over the footprints memory is to stay as it is: `grown` kB is what it did.
void derive(benchmark::State& state, Compiled& style, const std::vector<Footprint>& footprints,
            const DeriveOptions& options = {}) {
  Derivation derivation = style.derivation(options);
  Building building;
  Sums sums;
  for (const Footprint& footprint : footprints) derivation.derive(footprint, building);
  const double before = resident();
  for (auto _ : state) {
    for (const Footprint& footprint : footprints) {
      derivation.derive(footprint, building);
      benchmark::DoNotOptimize(building.surface.points.data());
      sums.add(building);
    }
  }
  sums.report(state);
  state.counters["grown"] = resident() - before;
}

/// The thesis's building: at least the vertices and operations that it is said to have.
void thesis(benchmark::State& state, const std::string& name, std::size_t operations) {
  Compiled style("bench/thesis.style", name);
  Building building;
  style.derivation().derive(rectangles(1, 10, 8)[0], building);
  if (building.surface.points.size() < 980 || building.operations < operations) {
    refuse(name + " makes " + std::to_string(building.surface.points.size()) + " vertices by " +
           std::to_string(building.operations) + " operations: fewer than the thesis's");
  }
  derive(state, style, rectangles(1000, 10, 8));
}

void thesis_by_61(benchmark::State& state) { thesis(state, "ThesisBy61", 61); }
void thesis_by_610(benchmark::State& state) { thesis(state, "ThesisBy610", 610); }

/// The thesis's listing 3.7 with its elements, at a level of detail.
void thesis_lod(benchmark::State& state, int lod) {
  Compiled style("styles/library/listings.style", "Building2");
  std::vector<Footprint> plots = rectangles(100, 10, 8);
  for (Footprint& plot : plots) plot.properties.push_back({"height", 9.0});
  derive(state, style, plots, {.lod = lod, .share_parts = false});
}

void thesis_lod1(benchmark::State& state) { thesis_lod(state, 1); }
void thesis_lod2(benchmark::State& state) { thesis_lod(state, 2); }
void thesis_lod3(benchmark::State& state) { thesis_lod(state, 3); }

/// The benchmark's own thesis building: a window is a pane and four reveals.
void plain_lod(benchmark::State& state, int lod) {
  Compiled style("bench/thesis.style", "ThesisBy61");
  derive(state, style, rectangles(1000, 10, 8), {.lod = lod, .share_parts = false});
}

void plain_lod1(benchmark::State& state) { plain_lod(state, 1); }
void plain_lod2(benchmark::State& state) { plain_lod(state, 2); }
void plain_lod3(benchmark::State& state) { plain_lod(state, 3); }

void facade_box(benchmark::State& state) {
  Compiled style("bench/facade_box.style");
  derive(state, style, rectangles(1000, 10, 8));
}

/// Each of its parts derived for itself.
void facade_box_apart(benchmark::State& state) {
  Compiled style("bench/facade_box.style");
  derive(state, style, rectangles(1000, 10, 8), {.share_parts = false});
}

/// Every tile asks whether something stands before it.
void facade_asks(benchmark::State& state) {
  Compiled style("bench/facade_asks.style");
  derive(state, style, rectangles(1000, 10, 8));
}

void facade_box_to_obj(benchmark::State& state) {
  Compiled style("bench/facade_box.style");
  const auto footprints = rectangles(1000, 10, 8);
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("mansard_bench_" + std::to_string(::getpid()) + ".obj"))
                               .string();
  const auto symbols = symbol_names(style.program());
  const auto looks = looks_of(style.program());
  Derivation derivation = style.derivation();
  Building building;
  std::size_t bytes = 0;
  for (auto _ : state) {
    const auto writer = write_obj(path, Up::y, "benchmark");
    for (const Footprint& footprint : footprints) {
      derivation.derive(footprint, building);
      writer->add({building.id, &building.surface}, symbols, looks);
    }
    bytes += writer->finish(looks);
  }
  state.SetBytesProcessed(static_cast<int64_t>(bytes));
  std::filesystem::remove(path);
  std::filesystem::remove(std::filesystem::path(path).replace_extension(".mtl"));
}

void quarter_houses(benchmark::State& state) {
  Compiled style("examples/quarter/quarter.style");
  derive(state, style, quarter());
}

void hip_roofs(benchmark::State& state) {
  Compiled style("bench/roofs.style", "Hip");
  derive(state, style, quarter());
}

void gable_roofs(benchmark::State& state) {
  Compiled style("bench/roofs.style", "Gable");
  derive(state, style, quarter());
}

BENCHMARK(thesis_by_61)->Unit(benchmark::kMillisecond);
BENCHMARK(thesis_by_610)->Unit(benchmark::kMillisecond);
BENCHMARK(thesis_lod1)->Unit(benchmark::kMillisecond);
BENCHMARK(thesis_lod2)->Unit(benchmark::kMillisecond);
BENCHMARK(thesis_lod3)->Unit(benchmark::kMillisecond);
BENCHMARK(plain_lod1)->Unit(benchmark::kMillisecond);
BENCHMARK(plain_lod2)->Unit(benchmark::kMillisecond);
BENCHMARK(plain_lod3)->Unit(benchmark::kMillisecond);
BENCHMARK(facade_box)->Unit(benchmark::kMillisecond);
BENCHMARK(facade_box_apart)->Unit(benchmark::kMillisecond);
BENCHMARK(facade_asks)->Unit(benchmark::kMillisecond);
BENCHMARK(facade_box_to_obj)->Unit(benchmark::kMillisecond);
BENCHMARK(quarter_houses)->Unit(benchmark::kMillisecond);
BENCHMARK(hip_roofs)->Unit(benchmark::kMillisecond);
BENCHMARK(gable_roofs)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mansard::bench
