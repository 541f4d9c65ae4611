// A band of a picture while it is made. It has two by two samples for every pixel of the picture,
// which are averaged at the very end, so that edges, ink and textures are smooth.
#pragma once

#include <cstdint>
#include <vector>

#include "render/camera.hpp"
#include "render/light.hpp"

namespace mansard {

struct Film {
  /// The surface that a sample shows.
  struct Seen {
    Float3 normal;
    float depth = 0;  ///< in lengths of the lens's ray
  };

  int width, height;  ///< samples of the whole picture
  int top, rows;      ///< of this band
  int threads;
  Lens lens;
  float pixel;  ///< size of a picture's pixel, at depth 1

  std::vector<Seen> seen;
  std::vector<uint32_t> triangle;
  std::vector<Float3> color;  ///< of the surface, or of the sky
  std::vector<Float3> shine;  ///< mirrored by glass
  std::vector<Light> light;
  std::vector<Light> smoothed;  ///< light while it is smoothed
  std::vector<float> ink;       ///< 0..1

  Film(const PictureOptions& options, const Lens& of, int band_top, int band_rows);

  std::size_t at(int x, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  Float3 ray(int x, int row) const {
    return lens.ray((2 * (static_cast<float>(x) + 0.5F)) / static_cast<float>(width) - 1,
                    1 - (2 * (static_cast<float>(top + row) + 0.5F)) / static_cast<float>(height));
  }
  Float3 point(int x, int row) const { return lens.eye + ray(x, row) * seen[at(x, row)].depth; }
};

/// Whether memory and numbers can hold such a picture.
bool is_possible(const PictureOptions& options);
/// What the lens sees, with all of the below; the options must be possible.
Picture paint(const RayScene& world, const Tracer& tracer, const Lens& lens,
              const PictureOptions& options);

/// Fills everything but ink.
void expose(Film& film, const RayScene& world, const Tracer& tracer, const Lighting& lighting,
            int samples);
/// Blurs light along surfaces: takes the noise away and leaves edges.
void smooth_light(Film& film);
/// Draws lines where surfaces meet, end or change their look.
void draw_ink(Film& film, const RayScene& world);
/// Writes rows [first, last) of the picture, that the band must hold.
void develop(const Film& film, const RayScene& world, const Lighting& lighting, int first, int last,
             Picture& picture);
/// Samples above and below that smooth_light and draw_ink look at.
constexpr int film_border = 24;

}  // namespace mansard
