#include "render/film.hpp"
#include "render/rows.hpp"

namespace mansard {
namespace {

/// Panes are never quite parallel: each mirrors another piece of sky.
Float3 pane_normal(Float3 normal, uint32_t face) {
  const uint32_t h = (face + 1) * 0x9e3779b1U;
  const Float3 tilt{static_cast<float>(h >> 24) / 255 - 0.5F,
                    static_cast<float>((h >> 16) & 255) / 255 - 0.5F,
                    static_cast<float>((h >> 8) & 255) / 255 - 0.5F};
  return normalized(normal + tilt * 0.045F);
}

/// Schlick's Fresnel term, raised at right angles so that glass shows in a drawing. The bare ground
/// is not mirrored: seen from above, panes would be white as paper.
Float3 mirrored(const Lighting& lighting, Float3 point, Float3 direction, Float3 normal) {
  const float grazing = 1 - std::min(1.0F, std::abs(dot(normal, direction)));
  const float part = 0.30F + 0.62F * grazing * grazing * grazing;
  Float3 out = normalized(direction - normal * (2 * dot(direction, normal)));
  out.y = std::abs(out.y);
  return lighting.radiance(point + normal * 2e-3F, out) * part;
}

/// How much more light than the plain surface a place gets that leans: lit by the sky, and by the
/// sun where the surface looks that way. A part of the colour, so that smoothing light keeps it.
float relief(const Lighting& lighting, Float3 normal, Float3 leaning) {
  const auto light = [&](Float3 n) {
    return 0.6F + 0.25F * n.y + std::max(0.0F, dot(n, lighting.sun()));
  };
  return light(leaning) / light(normal);
}

/// Smooth stone and metal: Schlick's Fresnel term, dulled by roughness, which also spreads what is
/// seen until only the sky's own light is left of it.
void polish(Film& film, std::size_t i, const Lighting& lighting, Float3 point, Float3 direction,
            const RayScene::Gloss& gloss) {
  const float smooth = (1 - gloss.roughness) * (1 - gloss.roughness);
  if (smooth < 0.02F) return;
  const Float3 normal = gloss.normal;
  const Float3 straight = mix({0.04F, 0.04F, 0.04F}, film.color[i], gloss.metallic);
  const float grazing = 1 - std::min(1.0F, std::abs(dot(normal, direction)));
  const float rim = grazing * grazing * grazing * grazing * grazing;
  const Float3 part = mix(straight, {1, 1, 1}, rim) * smooth;
  Float3 out = normalized(direction - normal * (2 * dot(direction, normal)));
  out.y = std::abs(out.y);
  const Float3 sharp = lighting.radiance(point + normal * 2e-3F, out);
  film.shine[i] = mix(sharp, sky_light(out) * 0.7F, gloss.roughness) * part;
  film.color[i] = film.color[i] * (1 - gloss.metallic * smooth);
}

void expose_sample(Film& film, int x, int row, const RayScene& world, const Tracer& tracer,
                   const Lighting& lighting, int samples) {
  const std::size_t i = film.at(x, row);
  const Float3 ray = film.ray(x, row);
  const Hit hit = tracer.see(film.lens.eye, ray);
  film.triangle[i] = hit.triangle;
  film.seen[i] = {hit.normal, hit.t};
  if (hit.is_sky()) return;

  const float distance = length(ray);
  const Float3 direction = ray * (1 / distance);
  const float slant = std::max(0.25F, -dot(hit.normal, direction));
  const float pixel = 0.5F * film.pixel * hit.t / std::sqrt(slant);
  film.color[i] = world.color_at(hit.triangle, hit.u, hit.v, pixel);
  if (const Hit stain = tracer.stain_before(film.lens.eye, ray, hit); !stain.is_sky())
    film.color[i] = world.stained(film.color[i], stain.triangle, stain.u, stain.v, pixel);
  const Float3 point = film.lens.eye + ray * hit.t;
  film.light[i] = lighting.gather(point, hit.normal, Spread(x, film.top + row, samples), samples);
  if (hit.triangle == RayScene::ground) return;
  if (world.look_of(hit.triangle).glass) {
    film.color[i] = film.color[i] * 0.55F;
    const Float3 normal = pane_normal(hit.normal, world.face[hit.triangle]);
    film.shine[i] = mirrored(lighting, point, direction, normal);
    return;
  }
  const RayScene::Gloss gloss = world.gloss_at(hit.triangle, hit.u, hit.v, pixel, hit.normal);
  film.color[i] = film.color[i] * relief(lighting, hit.normal, gloss.normal);
  polish(film, i, lighting, point, direction, gloss);
}

/// Whether the sample lies behind one plane in which both others lie.
bool is_behind(const Film& film, int x, int row, int dx, int dy) {
  const std::size_t before = film.at(x - dx, row - dy), after = film.at(x + dx, row + dy);
  for (const std::size_t i : {before, after}) {
    if (film.triangle[i] >= RayScene::ground) return false;
  }
  const Float3 normal = film.seen[before].normal;
  if (dot(normal, film.seen[after].normal) < 0.999F) return false;
  const Float3 point = film.point(x - dx, row - dy);
  const float slack = 0.02F + 2 * film.pixel * film.seen[before].depth;
  if (std::abs(dot(normal, film.point(x + dx, row + dy) - point)) > slack) return false;
  const std::size_t here = film.at(x, row);
  if (film.triangle[here] == RayScene::sky) return true;
  return dot(normal, film.point(x, row) - point) < -slack;
}

/// Where a polygon's corner touches another's side, a ray can slip through between them. A lone
/// sample behind a surface that is all around it is taken to be that surface.
void close_cracks(Film& film) {
  for (int row = 1; row + 1 < film.rows; ++row) {
    for (int x = 1; x + 1 < film.width; ++x) {
      const std::size_t here = film.at(x, row), before = here - 1;
      if (film.triangle[here] == film.triangle[before]) continue;
      if (!is_behind(film, x, row, 1, 0) || !is_behind(film, x, row, 0, 1)) continue;
      film.triangle[here] = film.triangle[before];
      film.seen[here] = film.seen[before];
      film.color[here] = film.color[before];
      film.shine[here] = film.shine[before];
      film.light[here] = film.light[before];
    }
  }
}

}  // namespace

Film::Film(const PictureOptions& options, const Lens& of, int band_top, int band_rows)
    : width(2 * options.width),
      height(2 * options.height),
      top(band_top),
      rows(band_rows),
      threads(thread_count(options.threads)),
      lens(of),
      pixel(2 * length(of.up) / static_cast<float>(options.height)) {
  const std::size_t count = at(0, rows);
  seen.resize(count);
  triangle.resize(count, RayScene::sky);
  color.resize(count);
  shine.resize(count);
  light.resize(count);
  smoothed.resize(count);
  ink.resize(count);
}

void expose(Film& film, const RayScene& world, const Tracer& tracer, const Lighting& lighting,
            int samples) {
  for_each_row(film.rows, film.threads, [&](int row) {
    for (int x = 0; x < film.width; ++x) {
      expose_sample(film, x, row, world, tracer, lighting, samples);
    }
  });
  close_cracks(film);
}

}  // namespace mansard
