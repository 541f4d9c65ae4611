#include "render/stain_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/random.hpp"
#include "render/png.hpp"
#include "render/rows.hpp"
#include "render/stain.hpp"

namespace mansard {
namespace {

using Atlas = StainAtlas;

/// A stain's random choices, in the order in which they are asked for.
class Draws {
 public:
  explicit Draws(uint64_t seed) : seed_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * unit_interval(mix(seed_, drawn_++));
  }

 private:
  uint64_t seed_, drawn_ = 0;
};

/// Water comes thinly from the whole edge, and more of it from a few places, the ends above all.
std::vector<StainFlow::Source> sources(Draws& draw) {
  const double left = Atlas::margin * Atlas::cell_width, right = Atlas::cell_width - left;
  std::vector<StainFlow::Source> all;
  const double middle = (left + right) / 2;
  all.push_back({middle, (right - left) / 2, draw.between(0.25, 0.6)});
  for (const double end : {left + 3, right - 3})
    all.push_back({end, draw.between(1.5, 4), draw.between(0.02, 0.16)});
  const int places = static_cast<int>(draw.between(4, 10));
  for (int i = 0; i < places; ++i) {
    const double spread = draw.between(0.8, 4), share = draw.between(0, 1);
    all.push_back({draw.between(left + spread, right - spread), spread, 0.2 * share * share});
  }
  return all;
}

/// The thesis leaves the parameters to chance within bounds; within these, stains look like those
/// below the sills of old houses.
StainFlow flow_of(Draws& draw) {
  StainFlow flow;
  flow.width = Atlas::cell_width;
  flow.height = Atlas::cell_height;
  flow.sources = sources(draw);
  flow.adhesion = draw.between(0.05, 0.12);
  flow.solubility = draw.between(0.01, 0.03);
  flow.roughness = draw.between(0.03, 0.10);
  flow.absorption = draw.between(0.15, 0.4);
  flow.absorptivity = draw.between(0.1, 0.3);
  flow.steps = 1200;
  return flow;
}

/// Binomial over three by three texels: takes the single particles away.
std::vector<double> smoothed(const StainField& field) {
  const int width = field.width, height = field.height;
  const auto at = [&](int x, int y) {
    const auto row = static_cast<std::size_t>(std::clamp(y, 0, height - 1));
    const auto column = static_cast<std::size_t>(std::clamp(x, 0, width - 1));
    return field.stain[row * static_cast<std::size_t>(width) + column];
  };
  std::vector<double> result;
  result.reserve(field.stain.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx)
          sum += at(x + dx, y + dy) * (dx == 0 ? 2 : 1) * (dy == 0 ? 2 : 1);
      }
      result.push_back(sum / 16);
    }
  }
  return result;
}

double smooth_step(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// From 0 towards 1. Not exp(): its last digit depends on the machine.
double saturated(double dirt) { return 1 - 1 / ((1 + dirt) * (1 + dirt)); }

/// 1 inside the cell, 0 at its sides and at its lower edge.
double fade(int x, int y) {
  const double side =
      std::min(x, Atlas::cell_width - 1 - x) / (0.5 * Atlas::margin * Atlas::cell_width);
  const double end = (Atlas::cell_height - 1 - y) / (0.35 * Atlas::cell_height);
  return smooth_step(side) * smooth_step(end);
}

/// How dark the strongest stains of each row are.
constexpr std::array<double, Atlas::strengths> darkest{0.20, 0.36, 0.52, 0.68};

void draw_stain(std::vector<uint8_t>& atlas, int column, int strength, uint64_t seed) {
  Draws draw(seed);
  const std::vector<double> stain = smoothed(run_down(flow_of(draw), mix(seed, 1)));
  std::vector<double> ranked = stain;
  const auto most = ranked.begin() + static_cast<std::ptrdiff_t>(ranked.size() * 49 / 50);
  std::nth_element(ranked.begin(), most, ranked.end());
  for (int y = 0; y < Atlas::cell_height; ++y) {
    for (int x = 0; x < Atlas::cell_width; ++x) {
      const auto row = static_cast<std::size_t>(y), place = static_cast<std::size_t>(x);
      const double dirt = stain[row * Atlas::cell_width + place] / std::max(*most, 1e-12);
      const double dark =
          darkest[static_cast<std::size_t>(strength)] * saturated(dirt) * fade(x, y);
      atlas[(static_cast<std::size_t>(strength) * Atlas::cell_height + row) * Atlas::width +
            static_cast<std::size_t>(column) * Atlas::cell_width + place] =
          static_cast<uint8_t>(std::lround(255 * std::clamp(dark, 0.0, 1.0)));
    }
  }
}

}  // namespace

std::vector<uint8_t> make_stain_atlas(uint64_t seed, int threads) {
  std::vector<uint8_t> atlas(std::size_t{Atlas::width} * Atlas::height);
  for_each_row(Atlas::columns * Atlas::strengths, thread_count(threads), [&](int stain) {
    draw_stain(atlas, stain % Atlas::columns, stain / Atlas::columns,
               mix(seed, static_cast<uint64_t>(stain)));
  });
  return atlas;
}

std::string encode_stain_atlas(const std::vector<uint8_t>& atlas) {
  std::vector<uint8_t> grey_alpha;
  grey_alpha.reserve(2 * atlas.size());
  for (const uint8_t dark : atlas) grey_alpha.insert(grey_alpha.end(), {dark, dark});
  return encode_png(Atlas::width, Atlas::height, 2, grey_alpha);
}

}  // namespace mansard
