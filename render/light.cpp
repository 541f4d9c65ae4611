#include "render/light.hpp"

#include <array>

namespace mansard {
namespace {

constexpr float pi = 3.14159265F;
constexpr Float3 sun_color{3.20F, 2.85F, 2.38F};
constexpr float sun_disc = 0.022F;  // radius, radians: four times the real one

uint32_t hash(uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352dU;
  x = (x ^ (x >> 15)) * 0x846ca68bU;
  return x ^ (x >> 16);
}

struct Basis {
  Float3 x, y;
  explicit Basis(Float3 normal) {
    x = normalized(cross(normal, std::abs(normal.x) > 0.7F ? Float3{0, 1, 0} : Float3{1, 0, 0}));
    y = cross(normal, x);
  }
};

constexpr std::size_t turns = 1024;

/// Points of the unit circle.
std::array<Spread::Spot, turns> circle() {
  std::array<Spread::Spot, turns> spots{};
  for (std::size_t i = 0; i < turns; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / turns;
    spots[i] = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
  }
  return spots;
}

/// Off a surface, so that a ray does not meet it again.
Float3 lifted(Float3 point, Float3 normal) {
  const float size = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  return point + normal * (1e-3F + 1e-6F * size);
}

}  // namespace

Float3 sky_light(Float3 direction) {
  const float height = std::sqrt(std::max(0.0F, direction.y));
  return mix({0.88F, 0.94F, 1.02F}, {0.36F, 0.54F, 0.92F}, height);
}

Spread::Spread(int x, int y, int samples) {
  static constexpr std::array<uint32_t, 16> order{0, 8,  2, 10, 12, 4, 14, 6,
                                                  3, 11, 1, 9,  15, 7, 13, 5};
  block_ = hash(static_cast<uint32_t>(x >> 2) + 0x9e3779b9U * hash(static_cast<uint32_t>(y >> 2)));
  const auto place = static_cast<uint32_t>(y & 3) * 4 + static_cast<uint32_t>(x & 3);
  first_ = order[place] * static_cast<uint32_t>(samples);
}

Spread::Spot Spread::on_disc(int i, int stream) const {
  static const std::array<Spot, turns> directions = circle();
  // Parts of a whole as 32-bit numbers, which wrap around by themselves.
  const uint32_t n = first_ + static_cast<uint32_t>(i);
  const uint32_t x = hash(block_ + static_cast<uint32_t>(stream)) + n * 3242174889U;
  const uint32_t y = hash(block_ - 1 - static_cast<uint32_t>(stream)) + n * 2447445414U;
  const float radius = std::sqrt(static_cast<float>(x >> 8) * 0x1p-24F);
  const Spot direction = directions[y / (0x100000000ULL / turns)];
  return {radius * direction.x, radius * direction.y};
}

Lighting::Lighting(const RayScene& world, const Tracer& tracer, Float3 view)
    : world_(world), tracer_(tracer) {
  Float3 level = normalized(Float3{view.x, 0, view.z});
  if (length(level) < 0.5F) level = {0, 0, -1};
  const Float3 left{level.z, 0, -level.x};
  constexpr float turn = 1.05F, height = 0.80F;  // radians: 60 degrees aside, 46 up
  sun_ = normalized((left * std::sin(turn) - level * std::cos(turn)) * std::cos(height) +
                    Float3{0, std::sin(height), 0});
  const Basis basis(sun_);
  sun_x_ = basis.x * sun_disc;
  sun_y_ = basis.y * sun_disc;
}

Light Lighting::gather(Float3 point, Float3 normal, const Spread& spread, int samples) const {
  const Float3 from = lifted(point, normal);
  const Basis basis(normal);
  Light sum;
  for (int i = 0; i < samples; ++i) {
    // Directions by the cosine to the normal (Malley): every one counts the same.
    const Spread::Spot sky = spread.on_disc(i, 0);
    const float up = std::sqrt(std::max(0.0F, 1 - sky.x * sky.x - sky.y * sky.y));
    const Float3 direction = basis.x * sky.x + basis.y * sky.y + normal * up;
    sum.ambient = sum.ambient + radiance(from, direction);
  }
  // The sun is small: fewer do.
  const int sun_samples = (2 * samples + 2) / 3;
  for (int i = 0; i < sun_samples; ++i) {
    const Spread::Spot spot = spread.on_disc(i, 1);
    const Float3 to_sun = sun_ + sun_x_ * spot.x + sun_y_ * spot.y;
    if (dot(to_sun, normal) > 0 && !tracer_.is_blocked(from, to_sun)) sum.sun += 1;
  }
  return {sum.ambient * (1.0F / static_cast<float>(samples)),
          sum.sun / static_cast<float>(sun_samples)};
}

Float3 Lighting::radiance(Float3 point, Float3 direction) const {
  const Hit hit = tracer_.hit(point, direction);
  if (hit.is_sky()) return sky_light(direction);
  Light light{sky_light(hit.normal) * 0.6F, 0};
  if (dot(hit.normal, sun_) > 0) {
    const Float3 at = lifted(point + direction * hit.t, hit.normal);
    light.sun = tracer_.is_blocked(at, sun_) ? 0.0F : 1.0F;
  }
  const Float3 color = world_.color_at(hit.triangle, hit.u, hit.v, 1);
  return reflected(color, hit.normal, light);
}

Float3 Lighting::reflected(Float3 color, Float3 normal, const Light& light) const {
  const float toward = std::max(0.0F, dot(normal, sun_));
  return color * (light.ambient * 1.12F + sun_color * (light.sun * toward)) * 0.75F;
}

}  // namespace mansard
