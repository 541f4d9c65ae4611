// Streaks of rain: the flow of particles, and the picture of sixteen stains made of it.
#include <benchmark/benchmark.h>

#include "render/stain.hpp"
#include "render/stain_picture.hpp"

namespace mansard::bench {
namespace {

/// Two million steps of single particles: four more start with each of the first thousand steps.
void flow_of_stain(benchmark::State& state) {
  StainFlow flow;
  flow.sources = {{64, 40, 1}};
  flow.steps = 1000;
  std::size_t moves = 0;
  for (auto _ : state) moves += run_down(flow, 1).moves;
  state.SetItemsProcessed(static_cast<int64_t>(moves));
}

void stain_atlas(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(make_stain_atlas(0, 1));
}

BENCHMARK(flow_of_stain)->Unit(benchmark::kMillisecond);
BENCHMARK(stain_atlas)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mansard::bench
