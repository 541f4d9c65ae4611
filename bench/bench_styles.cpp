// From text to a program.
#include <benchmark/benchmark.h>

#include "bench/workload.hpp"
#include "grammar/parse.hpp"

namespace mansard::bench {
namespace {

constexpr const char* script = "examples/quarter/quarter.style";

/// The quarter's script, as often as makes a megabyte.
void parse_script(benchmark::State& state) {
  DiskFiles files;
  const auto once = files.read(source_path(script));
  if (!once) refuse("the quarter's script can not be read");
  std::string text;
  while (text.size() < 1'000'000) text += *once;
  const Source source("quarter.style", text);
  for (auto _ : state) {
    Diagnostics diagnostics;
    benchmark::DoNotOptimize(parse(source, diagnostics));
    if (diagnostics.has_errors()) refuse("the quarter's script does not parse");
  }
  state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * text.size()));
}

void load_and_compile(benchmark::State& state) {
  for (auto _ : state) {
    const Compiled compiled(script);
    benchmark::DoNotOptimize(&compiled.program());
  }
}

BENCHMARK(parse_script)->Unit(benchmark::kMillisecond);
BENCHMARK(load_and_compile)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mansard::bench

BENCHMARK_MAIN();
