#include "render/film.hpp"
#include "render/rows.hpp"

namespace mansard {
namespace {

/// How strongly the border between two samples is drawn, 0..1, were it near.
struct Border {
  float outline = 0;  ///< one surface ends before another
  float crease = 0;   ///< two surfaces meet at an angle
  float look = 0;     ///< the paint changes
};

bool is_same_look(const RayScene& world, uint32_t a, uint32_t b) {
  if (a == RayScene::ground || b == RayScene::ground) return a == b;
  const RayScene::Look &one = world.look_of(a), &other = world.look_of(b);
  if (one.glass != other.glass || one.texture != other.texture) return false;
  const Float3 d = one.color - other.color;
  return dot(d, d) < 0.002F;
}

/// `ray` is the neighbour's.
Border border(const Film& film, const RayScene& world, std::size_t i, std::size_t k, Float3 step) {
  const uint32_t a = film.triangle[i], b = film.triangle[k];
  if (a == b) return {};
  if (a == RayScene::sky || b == RayScene::sky) {
    return {a == RayScene::ground || b == RayScene::ground ? 0.0F : 1.0F, 0, 0};
  }
  const bool same_face =
      a != RayScene::ground && b != RayScene::ground && world.face[a] == world.face[b];
  if (same_face) return {};
  const Film::Seen &own = film.seen[i], &other = film.seen[k];
  // Seen from the nearer surface: does the other one lie in front of or behind its plane?
  const float jump = std::min(std::abs(dot(own.normal, step)), std::abs(dot(other.normal, step)));
  const float depth = std::min(own.depth, other.depth);
  const float slack = 0.03F + 1.5F * film.pixel * depth;
  if (jump > slack) return {0.95F, 0, 0};
  const float turn = 1 - dot(own.normal, other.normal);
  const float crease = smooth_step(0.03F, 0.22F, turn);
  return {0, crease, is_same_look(world, a, b) ? 0.0F : 1.0F};
}

/// Lines fade where a pixel covers much: `size` in metres, `half` where half of them is left.
float fade(float size, float half) { return 1 / (1 + (size / half) * (size / half)); }

float ink_at(const Film& film, const RayScene& world, int x, int row) {
  const std::size_t i = film.at(x, row);
  const Float3 here = film.ray(x, row) * film.seen[i].depth;
  float most = 0;
  for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    const int other_x = x + dx, y = row + dy;
    if (other_x < 0 || y < 0 || other_x >= film.width || y >= film.rows) continue;
    const std::size_t k = film.at(other_x, y);
    if (film.triangle[i] == film.triangle[k]) continue;
    const Float3 there = film.ray(other_x, y) * film.seen[k].depth;
    const Border found = border(film, world, i, k, there - here);
    float depth = std::min(film.seen[i].depth, film.seen[k].depth);
    if (film.triangle[i] == RayScene::sky) depth = film.seen[k].depth;
    if (film.triangle[k] == RayScene::sky) depth = film.seen[i].depth;
    const float size = film.pixel * depth;
    most = std::max({most, found.outline * 0.85F * fade(size, 0.35F),
                     found.crease * 0.62F * fade(size, 0.16F),
                     found.look * 0.40F * fade(size, 0.10F)});
  }
  return most;
}

}  // namespace

void draw_ink(Film& film, const RayScene& world) {
  for_each_row(film.rows, film.threads, [&](int row) {
    for (int x = 0; x < film.width; ++x) film.ink[film.at(x, row)] = ink_at(film, world, x, row);
  });
}

}  // namespace mansard
