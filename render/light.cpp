#include "render/light.hpp"

#include <array>

namespace mansard {
namespace {

constexpr float pi = 3.14159265F;
constexpr Float3 sun_color{3.35F, 2.85F, 2.20F};
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

/// Within the unit disc.
Vec2 on_disc(Vec2 square) {
  const double radius = std::sqrt(square.x), angle = 2 * pi * square.y;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Off a surface, so that a ray does not meet it again.
Float3 lifted(Float3 point, Float3 normal) {
  const float size = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  return point + normal * (1e-3F + 1e-6F * size);
}

}  // namespace

Float3 sky_light(Float3 direction) {
  const float height = std::pow(std::max(0.0F, direction.y), 0.55F);
  return mix({0.86F, 0.93F, 1.02F}, {0.30F, 0.50F, 0.92F}, height);
}

Spread::Spread(int x, int y, int samples) {
  static constexpr std::array<int, 16> order{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  block_ = hash(static_cast<uint32_t>(x >> 2) + 0x9e3779b9U * hash(static_cast<uint32_t>(y >> 2)));
  first_ = order[static_cast<std::size_t>((y & 3) * 4 + (x & 3))] * samples;
}

Vec2 Spread::at(int i, int stream) const {
  const uint32_t shift = hash(block_ + static_cast<uint32_t>(stream) * 0x68e31da4U);
  const double n = first_ + i;
  const double x = (shift & 0xffff) / 65536.0 + n * 0.7548776662466927;
  const double y = (shift >> 16) / 65536.0 + n * 0.5698402909980532;
  return {x - std::floor(x), y - std::floor(y)};
}

Lighting::Lighting(const World& world, const Tracer& tracer, Float3 view)
    : world_(world), tracer_(tracer) {
  Float3 level = normalized(Float3{view.x, 0, view.z});
  if (length(level) < 0.5F) level = {0, 0, -1};
  const Float3 left{level.z, 0, -level.x};
  constexpr float turn = 0.92F, height = 0.72F;  // radians: 53 degrees aside, 41 up
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
    // Directions by the cosine to the normal: every one counts the same.
    const Vec2 square = spread.at(i, 0), disc = on_disc(square);
    const Float3 direction = basis.x * static_cast<float>(disc.x) +
                             basis.y * static_cast<float>(disc.y) +
                             normal * static_cast<float>(std::sqrt(1 - square.x));
    sum.ambient = sum.ambient + radiance(from, direction);

    const Vec2 spot = on_disc(spread.at(i, 1));
    const Float3 to_sun =
        sun_ + sun_x_ * static_cast<float>(spot.x) + sun_y_ * static_cast<float>(spot.y);
    if (dot(to_sun, normal) > 0 && !tracer_.is_blocked(from, to_sun)) sum.sun += 1;
  }
  const float share = 1.0F / static_cast<float>(samples);
  return {sum.ambient * share, sum.sun * share};
}

Float3 Lighting::radiance(Float3 point, Float3 direction) const {
  const Hit hit = tracer_.hit(point, direction);
  if (hit.is_sky()) return sky_light(direction);
  Light light{sky_light(hit.normal) * 0.5F, 0};
  if (dot(hit.normal, sun_) > 0) {
    const Float3 at = lifted(point + direction * hit.t, hit.normal);
    light.sun = tracer_.is_blocked(at, sun_) ? 0.0F : 1.0F;
  }
  const Float3 color = world_.color_at(hit.triangle, hit.u, hit.v, 1);
  return reflected(color, hit.normal, light);
}

Float3 Lighting::reflected(Float3 color, Float3 normal, const Light& light) const {
  const float toward = std::max(0.0F, dot(normal, sun_));
  return color * (light.ambient + sun_color * (light.sun * toward)) * 0.75F;
}

}  // namespace mansard
