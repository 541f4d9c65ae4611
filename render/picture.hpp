// Pictures of surfaces: our eyes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/finish.hpp"
#include "geometry/mesh.hpp"

namespace mansard {

/// What a surface looks like to the light. Colours are linear 0..1.
struct Paint {
  Vec3 color{0.8, 0.8, 0.8};
  bool glass = false;
  std::string texture;  ///< path of a picture, which `color` stands in for when it is missing
  Finish finish = {};
  Vec3 tint{1, 1, 1};   ///< of the picture
  bool stains = false;  ///< lies before another surface, as opaque as the picture is white; casts
                        ///< no shadow
  std::string picture = {};  ///< the bytes of a picture's file, instead of `texture`
};

/// Triangles to look at. Append, then render.
struct Scene {
  std::vector<float> points;    ///< x y z, three a corner, three corners a triangle
  std::vector<float> uvs;       ///< u v, likewise
  std::vector<uint32_t> paint;  ///< one a triangle
  std::vector<uint32_t> face;   ///< one a triangle: the polygon it belongs to (for ink edges)
  std::vector<Paint> paints;

  /// Triangulates; materials of the surface index `paints` after `first_paint`.
  void add(const Surface& surface, uint32_t first_paint = 0);
};

struct Camera {
  enum class View : uint8_t { iso, street, free };
  View view = View::iso;
  Vec3 eye, target;           ///< free only
  double field_of_view = 35;  ///< degrees, vertical
};

struct PictureOptions {
  int width = 1200, height = 800;
  Camera camera;
  int samples = 16;  ///< a pixel
  int threads = 0;   ///< 0: all
};

struct Picture {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;  ///< rows from the top
};

/// Soft sun, sky occlusion, one bounce, ink edges, ground and horizon (Embree). The same input
/// gives the same bytes for any number of threads. An empty scene is ground and sky.
Picture render(const Scene& scene, const PictureOptions& options);

/// `street`, `iso` or `x,y,z,tx,ty,tz`; nothing for other text.
std::optional<Camera> parse_camera(std::string_view text);

/// The bytes of a PNG file; none for a picture without pixels or with too few.
std::string encode_png(const Picture& picture);

}  // namespace mansard
