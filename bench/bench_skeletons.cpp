// Times skeletons of real footprints, from raw footprint to checked skeleton, beside CGAL's plain
// call on the cleaned polygon, in CPU time of one thread. Prints a table by number of corners.
//
//     bench_skeletons [PASSES]        5
#include <ctime>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "geometry/skeleton.hpp"
#include "tests/geometry/roof_input.hpp"

namespace mansard {
namespace {

double cpu_microseconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e6 + static_cast<double>(t.tv_nsec) * 1e-3;
}

struct Timed {
  Polygon raw, clean;
  double ours = 1e300, cgals = 1e300;  // microseconds, the best of the passes
};

// The clock's own time is taken off.
template <class F>
double time_of(F f) {
  static const double clock = [] {
    double least = 1e300;
    for (int i = 0; i < 1000; ++i) {
      const double begin = cpu_microseconds();
      least = std::min(least, cpu_microseconds() - begin);
    }
    return least;
  }();
  const double begin = cpu_microseconds();
  f();
  return std::max(cpu_microseconds() - begin - clock, 0.0);
}

std::vector<Timed> footprints() {
  std::vector<Timed> all;
  for (test::Named& named : test::real_footprints(1, 1)) {
    if (auto on = best_skeleton(named.polygon)) {
      all.push_back({std::move(named.polygon), std::move(on->polygon)});
    }
  }
  return all;
}

struct Column {
  double sum = 0, median = 0, p99 = 0, slowest = 0;
};

Column column(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  Column c;
  for (const double t : times) c.sum += t;
  c.median = times[times.size() / 2];
  c.p99 = times[times.size() * 99 / 100];
  c.slowest = times.back();
  return c;
}

void print_row(const std::vector<Timed>& all, std::size_t low, std::size_t high) {
  std::vector<double> ours, cgals;
  for (const Timed& t : all) {
    const std::size_t n = t.clean.points.size();
    if (n < low || n > high) continue;
    ours.push_back(t.ours);
    cgals.push_back(t.cgals);
  }
  if (ours.empty()) return;
  const Column a = column(ours), b = column(cgals);
  std::printf("%4zu-%-5zu %6zu   %8.1f %8.1f %9.1f   %9.1f %9.1f %9.1f   %6.1f %6.1f %6.1f %6.1f\n",
              low, high, ours.size(), a.median, a.p99, a.slowest, b.median, b.p99, b.slowest,
              b.median / a.median, b.p99 / a.p99, b.slowest / a.slowest, b.sum / a.sum);
}

}  // namespace
}  // namespace mansard

int main(int argc, char** argv) {
  using namespace mansard;
  const int passes = argc > 1 ? std::atoi(argv[1]) : 5;
  std::vector<Timed> all = footprints();
  if (all.empty()) {
    std::puts("no real footprints beside the project");
    return 0;
  }
  for (int pass = 0; pass < passes; ++pass) {
    for (Timed& t : all) {
      t.ours = std::min(t.ours, time_of([&] { return best_skeleton(t.raw); }));
    }
    for (Timed& t : all) {
      t.cgals = std::min(t.cgals, time_of([&] { return raw_skeleton(t.clean); }));
    }
  }
  std::puts(
      "microseconds           ours: median      p99   slowest   CGAL: median    p99   slowest"
      "   CGAL to ours: median, p99, slowest, sum");
  constexpr std::array<std::size_t, 8> bounds{3, 5, 9, 17, 33, 65, 129, 100000};
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) print_row(all, bounds[i], bounds[i + 1] - 1);
  print_row(all, 3, 100000);
  return 0;
}
