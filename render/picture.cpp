#include "render/picture.hpp"

#include "render/film.hpp"
#include "render/rows.hpp"

namespace mansard {
namespace {

constexpr int largest_side = 32768;
/// Samples of a band: bounds the memory to about 150 MB.
constexpr int band_samples = 1'500'000;

}  // namespace

Picture render(const Scene& scene, const PictureOptions& options) {
  if (!is_possible(options)) return {};
  const RayScene world(scene);
  const Tracer tracer(world);
  return paint(world, tracer, aim(world, tracer, options), options);
}

bool is_possible(const PictureOptions& options) {
  return options.width >= 1 && options.height >= 1 && options.width <= largest_side &&
         options.height <= largest_side;
}

Picture paint(const RayScene& world, const Tracer& tracer, const Lens& lens,
              const PictureOptions& options) {
  const Lighting lighting(world, tracer, lens.forward);
  // Of a pixel's samples three quarters look at the sky and half at the sun; each of its two by two
  // points takes its part.
  const int samples = std::clamp((3 * options.samples + 8) / 16, 1, 256);

  Picture picture{options.width, options.height, {}};
  picture.rgb.resize(std::size_t{3} * static_cast<std::size_t>(options.width) *
                     static_cast<std::size_t>(options.height));
  const int band = std::max(32, band_samples / (4 * options.width));
  for (int first = 0; first < options.height; first += band) {
    const int last = std::min(options.height, first + band);
    const int top = std::max(0, 2 * first - film_border);
    const int bottom = std::min(2 * options.height, 2 * last + film_border);
    Film film(options, lens, top, bottom - top);
    expose(film, world, tracer, lighting, samples);
    smooth_light(film);
    draw_ink(film, world);
    develop(film, world, lighting, first, last, picture);
  }
  return picture;
}

}  // namespace mansard
