#include <array>

#include "render/camera.hpp"

namespace mansard {
namespace {

constexpr float pi = 3.14159265F;
constexpr int directions = 32;
constexpr int grid = 48;

Float3 level_direction(int number) {
  const float angle = 2 * pi * static_cast<float>(number) / directions;
  return {std::sin(angle), 0, -std::cos(angle)};
}

/// Under the open sky, on the ground.
bool is_outdoors(const Tracer& tracer, Float3 eye) {
  return !tracer.is_blocked(eye, {0, 1, 0}) && !tracer.is_blocked(eye, {0, -1, 0});
}

/// How much of a street one sees: a free way of some length ahead, houses close on both sides.
float worth(const std::array<float, directions>& free, int ahead) {
  const auto at = [&](int turn) {
    return free[static_cast<std::size_t>((ahead + turn + directions) % directions)];
  };
  const auto near = [](float distance) { return 1 / (1 + distance / 12); };
  float sides = 0;
  for (const int turn : {3, 5, 8}) sides += near(at(turn)) * near(at(-turn));
  const bool is_cramped = at(8) < 2 || at(-8) < 2 || at(4) < 4 || at(-4) < 4;
  return std::min(at(0), 150.0F) / 150 * sides * (is_cramped ? 0.2F : 1.0F);
}

}  // namespace

Stand find_street(const RayScene& world, const Tracer& tracer) {
  const Float3 middle = world.middle(), size = world.high - world.low;
  Stand best{{middle.x, 1.7F, world.high.z + 10}, {0, 0, -1}};
  float most = 0;
  for (int i = 0; i < grid * grid; ++i) {
    // The middle three quarters: not on the edge, looking out of town.
    const int column = i % grid, row = i / grid;
    const float across = (static_cast<float>(column) + 0.5F) / grid - 0.5F;
    const float along = (static_cast<float>(row) + 0.5F) / grid - 0.5F;
    const Float3 eye{middle.x + 0.75F * across * size.x, 1.7F, middle.z + 0.75F * along * size.z};
    if (!is_outdoors(tracer, eye)) continue;
    std::array<float, directions> free{};
    for (int d = 0; d < directions; ++d) {
      const Hit hit = tracer.hit(eye, level_direction(d));
      free[static_cast<std::size_t>(d)] = hit.is_sky() ? 1000.0F : hit.t;
    }
    for (int d = 0; d < directions; ++d) {
      // Far from the middle it must be a better street to be chosen.
      const float value = worth(free, d) * (1 - across * across - along * along);
      if (value <= most) continue;
      most = value;
      best = {eye, level_direction(d)};
    }
  }
  return best;
}

}  // namespace mansard
