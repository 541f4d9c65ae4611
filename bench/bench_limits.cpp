// What no derivation can be faster than: moving memory, and turning numbers into text.
#include <benchmark/benchmark.h>

#include <cstring>
#include <random>
#include <vector>

#include "formats/numbers.hpp"

namespace mansard::bench {
namespace {

/// Far more than any cache holds; counted is what is written.
void copy_memory(benchmark::State& state) {
  const std::vector<char> from(std::size_t(64) << 20, 'x');
  std::vector<char> to(from.size());
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * from.size()));
}

/// Metres with as many digits as a facade's points have, a space between; they stay in the cache.
void numbers_to_text(benchmark::State& state) {
  std::mt19937 random(1);
  std::vector<double> numbers(10'000);
  for (double& number : numbers) number = static_cast<double>(random() % 4'000'000) / 10'000 - 200;
  std::vector<char> text(numbers.size() * (number_length + 1));
  std::size_t bytes = 0;
  for (auto _ : state) {
    char* to = text.data();
    for (const double number : numbers) {
      to = put_number(to, number);
      *to++ = ' ';
    }
    benchmark::DoNotOptimize(text.data());
    benchmark::ClobberMemory();
    bytes += static_cast<std::size_t>(to - text.data());
  }
  state.SetBytesProcessed(static_cast<int64_t>(bytes));
}

BENCHMARK(copy_memory)->Unit(benchmark::kMillisecond);
BENCHMARK(numbers_to_text)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mansard::bench
