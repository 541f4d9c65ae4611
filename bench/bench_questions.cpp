// What questions about other shapes cost: a line of JSON for each thing that is measured. CPU time
// of one thread, the least of several passes.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>

#include "bench/workload.hpp"
#include "formats/footprints.hpp"

namespace mansard::bench {
namespace {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double least(int passes, const std::function<void()>& work) {
  double best = 1e9;
  for (int i = 0; i < passes; ++i) {
    const double start = cpu_seconds();
    work();
    best = std::min(best, cpu_seconds() - start);
  }
  return best;
}

double seconds(Compiled& style, const std::vector<Footprint>& footprints, int passes = 3) {
  Derivation derivation = style.derivation();
  Building building;
  return least(passes, [&] {
    for (const Footprint& footprint : footprints) derivation.derive(footprint, building);
  });
}

// ---- buildings whose tiles ask, beside those whose tiles do not

void compare(const char* what, std::vector<Footprint> footprints) {
  mark_neighbours(footprints);
  Compiled plain("bench/facade_box.style"), asking("bench/facade_asks.style");
  const double without = seconds(plain, footprints), with = seconds(asking, footprints);
  std::printf(R"({"buildings": "%s", "count": %zu, "seconds": %.4f, "ratio": %.3f})"
              "\n",
              what, footprints.size(), without, with / without);
}

/// Houses of 10 x 8 m wall to wall, in rows of 40 back to back, of many heights.
std::vector<Footprint> rows(std::size_t count) {
  std::vector<Footprint> all = rectangles(count, 10, 8);
  for (std::size_t i = 0; i < count; ++i) {
    Footprint& house = all[i];
    translate(house.polygon,
              {-4.0 * static_cast<double>(i % 40), -4.0 * static_cast<double>(i / 40)});
    house.properties.push_back({"height", 6.0 + static_cast<double>(i * 7 % 11)});
  }
  return all;
}

// ---- one question more

constexpr double few = 40, many = 440;  // columns of 25 tiles

Footprint field(double side, double columns) {
  Footprint plot = rectangles(1, 2 * side, 2 * side)[0];
  plot.properties.push_back({"columns", columns});
  return plot;
}

/// Of ten thousand more: what they take in `style` less what they take where nobody asks.
double per_question(const std::string& style, const std::string& plain, double side) {
  const auto more = [&](const std::string& name) {
    Compiled compiled("bench/questions.style", name);
    return seconds(compiled, {field(side, many)}) - seconds(compiled, {field(side, few)});
  };
  return (more(style) - more(plain)) / (25 * (many - few));
}

void occluders() {
  for (const double count : {10.0, 100.0, 1000.0, 10'000.0, 100'000.0}) {
    const double side = std::ceil(std::sqrt(count));
    for (const char* const style : {"Covers", "Near", "Distance", "Sees"}) {
      std::printf(R"({"question": "%s", "occluders": %.0f, "microseconds": %.3f})"
                  "\n",
                  style, side * side, 1e6 * per_question(style, "Field", side));
      std::fflush(stdout);
    }
  }
}

void meshes() {
  for (const char* const style : {"Covers", "Near", "Distance", "Sees"}) {
    std::printf(R"({"question": "%s", "faces": 100000, "microseconds": %.3f})"
                "\n",
                style, 1e6 * per_question(std::string("Mesh") + style, "Mesh", 3));
    std::fflush(stdout);
  }
}

void towns() {
  for (const char* const town : {"monaco", "helsinki", "baltimore"}) {
    const std::string path = source_path("../shared/data/" + std::string(town) + ".osm.pbf");
    if (!std::filesystem::exists(path)) continue;
    std::vector<Footprint> all = read_footprints(path, {}).footprints;
    all.resize(std::min<std::size_t>(all.size(), 3000));
    compare(town, std::move(all));
  }
}

}  // namespace
}  // namespace mansard::bench

int main() {
  using namespace mansard::bench;
  compare("standing free", rectangles(10'000, 10, 8));
  compare("wall to wall", rows(10'000));
  towns();
  occluders();
  meshes();
}
