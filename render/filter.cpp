#include <array>

#include "render/film.hpp"
#include "render/rows.hpp"

namespace mansard {
namespace {

constexpr std::array<float, 5> kernel{0.25F, 0.9F, 1.0F, 0.9F, 0.25F};

float brightness(const Light& light) { return light.ambient.x + light.ambient.y + light.ambient.z; }

/// One pass of the à-trous filter (Dammertz et al. 2010), with `step` samples between taps, over
/// samples of the same plane. Wide passes leave out taps that differ much: edges of shadows.
class Pass {
 public:
  Pass(const Film& film, int step)
      : film_(film),
        step_(step),
        sun_range_(step == 1 ? 2 : 0.3F),
        range_(step == 1 ? 1e9F : 0.3F) {
    across_ = film.ray(1, 0) - film.ray(0, 0);
    down_ = film.ray(0, 1) - film.ray(0, 0);
  }

  Light at(int x, int row) const {
    const std::size_t i = film_.at(x, row);
    const uint32_t triangle = film_.triangle[i];
    const Light& own_light = film_.light[i];
    if (triangle == World::sky) return own_light;
    const Film::Seen& own = film_.seen[i];
    const Plane plane(film_, own, film_.ray(x, row), across_, down_);
    const float own_brightness = brightness(own_light);
    Light sum;
    float weights = 0, sun_weights = 0;
    for (int dy = -2; dy <= 2; ++dy) {
      const int y = row + dy * step_;
      if (y < 0 || y >= film_.rows) continue;
      for (int dx = -2; dx <= 2; ++dx) {
        const int other_x = x + dx * step_;
        if (other_x < 0 || other_x >= film_.width) continue;
        const std::size_t k = film_.at(other_x, y);
        if (film_.triangle[k] != triangle &&
            !is_alike(own, film_.seen[k], plane, film_.triangle[k], dx, dy)) {
          continue;
        }
        const float weight =
            kernel[static_cast<std::size_t>(dx + 2)] * kernel[static_cast<std::size_t>(dy + 2)];
        const Light& other = film_.light[k];
        if (std::abs(brightness(other) - own_brightness) <= range_ * own_brightness) {
          sum.ambient = sum.ambient + other.ambient * weight;
          weights += weight;
        }
        if (std::abs(other.sun - own_light.sun) <= sun_range_) {
          sum.sun += other.sun * weight;
          sun_weights += weight;
        }
      }
    }
    return {sum.ambient * (1 / weights), sum.sun / sun_weights};
  }

 private:
  /// Distances of other samples' points to a sample's plane: linear in their place on the film.
  struct Plane {
    float eye, here, across, down, slack;
    Plane(const Film& film, const Film::Seen& own, Float3 ray, Float3 right, Float3 below)
        : eye(0),
          here(dot(own.normal, ray)),
          across(dot(own.normal, right)),
          down(dot(own.normal, below)),
          slack(0.004F + 0.5F * film.pixel * own.depth) {
      eye = -own.depth * here;
    }
    float distance(const Film::Seen& other, float dx, float dy) const {
      return eye + other.depth * (here + dx * across + dy * down);
    }
  };

  bool is_alike(const Film::Seen& own, const Film::Seen& other, const Plane& plane,
                uint32_t triangle, int dx, int dy) const {
    if (triangle == World::sky || dot(own.normal, other.normal) < 0.96F) return false;
    const auto step = static_cast<float>(step_);
    return std::abs(plane.distance(other, step * static_cast<float>(dx),
                                   step * static_cast<float>(dy))) < plane.slack;
  }

  const Film& film_;
  int step_;
  float sun_range_, range_;
  Float3 across_, down_;
};

}  // namespace

void smooth_light(Film& film) {
  // Steps that have no factor in common with the 4 x 4 blocks of Spread.
  for (const int step : {1, 3, 7}) {
    const Pass pass(film, step);
    for_each_row(film.rows, film.threads, [&](int row) {
      for (int x = 0; x < film.width; ++x) film.smoothed[film.at(x, row)] = pass.at(x, row);
    });
    film.light.swap(film.smoothed);
  }
}

}  // namespace mansard
