#include <array>

#include "render/film.hpp"
#include "render/rows.hpp"

namespace mansard {
namespace {

constexpr std::array<float, 5> kernel{0.25F, 0.9F, 1.0F, 0.9F, 0.25F};

float brightness(const Light& light) { return light.ambient.x + light.ambient.y + light.ambient.z; }

/// Half a pass of the à-trous filter (Dammertz et al. 2010): along rows or columns, with `step`
/// samples between taps, over samples of the same plane. Wide passes leave out taps that differ
/// much: edges of shadows.
class Pass {
 public:
  enum class Along : uint8_t { rows, columns };

  Pass(const Film& film, int step, Along along)
      : film_(film),
        dx_(along == Along::rows ? step : 0),
        dy_(along == Along::rows ? 0 : step),
        sun_range_(step == 1 ? 2 : 0.3F),
        range_(step == 1 ? 1e9F : 0.3F),
        turn_(film.ray(dx_, dy_) - film.ray(0, 0)) {}

  Light at(int x, int row) const {
    const std::size_t i = film_.at(x, row);
    const uint32_t triangle = film_.triangle[i];
    const Light own = film_.light[i];
    if (triangle == RayScene::sky) return own;
    const float own_brightness = brightness(own), range = range_ * own_brightness;
    // The picture's border cuts taps off.
    const int place = dx_ > 0 ? x : row, size = dx_ > 0 ? film_.width : film_.rows;
    const int step = dx_ + dy_;
    const std::ptrdiff_t stride = dx_ + std::ptrdiff_t{dy_} * film_.width;
    Light sum;
    float weights = 0, sun_weights = 0;
    for (int tap = -std::min(2, place / step); tap <= 2 && place + tap * step < size; ++tap) {
      const std::size_t k = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + tap * stride);
      if (film_.triangle[k] != triangle && !is_in_plane(x, row, i, k, tap)) continue;
      const float weight = *(kernel.begin() + 2 + tap);
      const Light& other = film_.light[k];
      if (std::abs(brightness(other) - own_brightness) <= range) {
        sum.ambient = sum.ambient + other.ambient * weight;
        weights += weight;
      }
      if (std::abs(other.sun - own.sun) <= sun_range_) {
        sum.sun += other.sun * weight;
        sun_weights += weight;
      }
    }
    return {sum.ambient * (1 / weights), sum.sun / sun_weights};
  }

 private:
  bool is_in_plane(int x, int row, std::size_t i, std::size_t k, int tap) const {
    if (film_.triangle[k] == RayScene::sky) return false;
    const Film::Seen &own = film_.seen[i], &other = film_.seen[k];
    if (dot(own.normal, other.normal) < 0.96F) return false;
    const Float3 ray = film_.ray(x, row);
    const Float3 between = (ray + turn_ * static_cast<float>(tap)) * other.depth - ray * own.depth;
    const float slack = 0.004F + 0.5F * film_.pixel * own.depth;
    return std::abs(dot(own.normal, between)) < slack;
  }

  const Film& film_;
  int dx_, dy_;
  float sun_range_, range_;
  Float3 turn_;  ///< of the ray, from tap to tap
};

}  // namespace

void smooth_light(Film& film) {
  // Steps that have no factor in common with the 4 x 4 blocks of Spread.
  for (const int step : {1, 3, 7}) {
    for (const Pass::Along along : {Pass::Along::rows, Pass::Along::columns}) {
      const Pass pass(film, step, along);
      for_each_row(film.rows, film.threads, [&](int row) {
        for (int x = 0; x < film.width; ++x) film.smoothed[film.at(x, row)] = pass.at(x, row);
      });
      film.light.swap(film.smoothed);
    }
  }
}

}  // namespace mansard
