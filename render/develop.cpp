#include <array>

#include "render/film.hpp"
#include "render/rows.hpp"

namespace mansard {
namespace {

constexpr Float3 ink_color{0.030F, 0.032F, 0.050F};
/// Where ground and sky meet.
constexpr Float3 haze{1.62F, 1.62F, 1.60F};
constexpr float exposure = 0.56F;

/// Paper-white at the horizon, blue above.
Float3 backdrop(Float3 direction) {
  const float height = std::max(0.0F, direction.y);
  return mix(haze, {0.72F, 1.02F, 1.50F}, 1 - std::exp(-2.2F * height));
}

/// Narkowicz 2015, a fit of the ACES film curve.
float tone(float light) {
  const float x = light * exposure;
  return std::clamp(x * (2.51F * x + 0.03F) / (x * (2.43F * x + 0.59F) + 0.14F), 0.0F, 1.0F);
}

/// The curve on each channel makes colours garish, on brightness alone it keeps the paint's hue:
/// half of each.
Float3 toned(Float3 light) {
  const float brightness = dot(light, {0.2126F, 0.7152F, 0.0722F});
  if (!(brightness > 0)) return {};
  const float grey = tone(brightness);
  const Float3 same_hue = light * (grey / brightness);
  const Float3 color = mix({tone(light.x), tone(light.y), tone(light.z)}, same_hue, 0.5F);
  return mix(color, {grey, grey, grey}, 0.10F);
}

uint8_t srgb(float linear) {
  const float c =
      linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
  return static_cast<uint8_t>(std::lround(255 * std::clamp(c, 0.0F, 1.0F)));
}

/// The ground runs out into haze; what stands far away gets a little of it.
float haze_at(const Film& film, const RayScene& world, std::size_t i, Float3 point) {
  const Float3 from_middle = point - world.middle();
  const float away = std::sqrt(from_middle.x * from_middle.x + from_middle.z * from_middle.z);
  const float reach = std::max(world.radius, 12.0F);
  if (film.triangle[i] == RayScene::ground) return smooth_step(2 * reach, 14 * reach, away);
  const float nearest = std::max(150.0F, length(film.lens.eye - world.middle()) - reach);
  const float beyond = std::max(0.0F, length(point - film.lens.eye) - nearest);
  return 0.45F * (1 - std::exp(-beyond / std::max(1500.0F, 6 * reach)));
}

Float3 finished(const Film& film, const RayScene& world, const Lighting& lighting, int x, int row) {
  const std::size_t i = film.at(x, row);
  Float3 light;
  if (film.triangle[i] == RayScene::sky) {
    light = backdrop(normalized(film.ray(x, row)));
  } else {
    light = lighting.reflected(film.color[i], film.seen[i].normal, film.light[i]) + film.shine[i];
    light = mix(light, haze, haze_at(film, world, i, film.point(x, row)));
  }
  return mix(toned(light), ink_color, film.ink[i]);
}

}  // namespace

void develop(const Film& film, const RayScene& world, const Lighting& lighting, int first, int last,
             Picture& picture) {
  for_each_row(last - first, film.threads, [&](int number) {
    const int y = first + number;
    uint8_t* out = picture.rgb.data() + std::size_t{3} * static_cast<std::size_t>(picture.width) *
                                            static_cast<std::size_t>(y);
    for (int x = 0; x < picture.width; ++x) {
      Float3 sum;
      for (int k = 0; k < 4; ++k) {
        sum = sum + finished(film, world, lighting, 2 * x + k % 2, 2 * y + k / 2 - film.top);
      }
      for (const float part : {sum.x, sum.y, sum.z}) *out++ = srgb(part / 4);
    }
  });
}

}  // namespace mansard
