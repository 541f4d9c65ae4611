#include "render/camera.hpp"

#include <array>
#include <charconv>
#include <limits>

namespace mansard {
namespace {

constexpr float pi = 3.14159265F;
constexpr float eye_height = 1.7F;  // metres
constexpr float large = 100;        // metres of radius
constexpr float margin = 1.06F;

float radians(double degrees) { return static_cast<float>(degrees) * pi / 180; }

/// Towards the scene from a place `azimuth` degrees from south (+z) to east (+x), `pitch` degrees
/// up.
Float3 looking(double azimuth, double pitch) {
  const float a = radians(azimuth), p = radians(pitch);
  return -Float3{std::sin(a) * std::cos(p), std::sin(p), std::cos(a) * std::cos(p)};
}

struct Axes {
  Float3 right, up, forward;
  explicit Axes(Float3 direction) : forward(normalized(direction)) {
    right = cross(forward, {0, 1, 0});
    right = length(right) > 1e-4F ? normalized(right) : Float3{1, 0, 0};
    up = cross(right, forward);
  }
  Float3 local(Float3 p) const { return {dot(p, right), dot(p, up), dot(p, forward)}; }
  Float3 world(Float3 p) const { return right * p.x + up * p.y + forward * p.z; }
};

/// The largest value of f over all corners (or, without triangles, over the bounds' corners).
template <class F>
float support(const RayScene& world, F f) {
  float most = -std::numeric_limits<float>::infinity();
  for (const Float3 p : world.corners) most = std::max(most, f(p));
  if (!world.corners.empty()) return most;
  for (int k = 0; k < 8; ++k) {
    most = std::max(most, f({(k & 1) != 0 ? world.low.x : world.high.x,
                             (k & 2) != 0 ? world.low.y : world.high.y,
                             (k & 4) != 0 ? world.low.z : world.high.z}));
  }
  return most;
}

/// Along one film axis a picture of tangent `t` to both sides holds p when |p - eye| <= t * depth.
/// Each border is a plane that the eye must stay behind; both are touched at the nearest eye.
struct Fit {
  float across;  ///< the eye's place along the axis
  float depth;   ///< and along the view
};

Fit fit(const RayScene& world, const Axes& axes, Float3 axis, float tangent) {
  const float high =
      support(world, [&](Float3 p) { return dot(p, axis) - dot(p, axes.forward) * tangent; });
  const float low =
      support(world, [&](Float3 p) { return -dot(p, axis) - dot(p, axes.forward) * tangent; });
  return {(high - low) / 2, -(high + low) / (2 * tangent)};
}

Lens lens(Float3 eye, const Axes& axes, float tangent, float aspect, float shift = 0) {
  return {eye, axes.forward + axes.up * shift, axes.right * (tangent * aspect), axes.up * tangent};
}

/// A long lens, nearly without perspective, from the south-east.
Lens aim_iso(const RayScene& world, float aspect) {
  const bool is_large = world.radius > large;
  const Axes axes(looking(is_large ? 30 : 38, is_large ? 36 : 27));
  const float tangent = std::tan(radians(is_large ? 18 : 6) / 2);
  const Fit sideways = fit(world, axes, axes.right, tangent * aspect / margin);
  const Fit upwards = fit(world, axes, axes.up, tangent / margin);
  return lens(
      axes.world({sideways.across, upwards.across, std::min(sideways.depth, upwards.depth)}), axes,
      tangent, aspect);
}

/// Level, at the height of a person's eyes; the nearest place from which nothing is cut off. The
/// film is shifted up, at most until the horizon lies at a quarter of the picture's height.
Lens aim_at_front(const RayScene& world, double field_of_view, float aspect) {
  const Float3 size = world.high - world.low;
  const Axes axes(looking(size.x >= size.z ? 20 : 70, 0));
  float tangent = std::tan(radians(field_of_view) / 2);
  const float top = 1.5F * tangent / margin, bottom = 0.5F * tangent / margin;
  const Fit sideways = fit(world, axes, axes.right, tangent * aspect / margin);
  const float behind_top =
      support(world, [&](Float3 p) { return (p.y - eye_height) - dot(p, axes.forward) * top; });
  const float behind_bottom =
      support(world, [&](Float3 p) { return (eye_height - p.y) - dot(p, axes.forward) * bottom; });
  const float depth = std::min({sideways.depth, -behind_top / top, -behind_bottom / bottom});

  // How far up, down and aside the scene reaches from there; a small one is brought nearer.
  const auto away = [&](Float3 p) { return dot(p, axes.forward) - depth; };
  const float up = support(world, [&](Float3 p) { return (p.y - eye_height) / away(p); });
  const float down = support(world, [&](Float3 p) { return (eye_height - p.y) / away(p); });
  const float aside = support(
      world, [&](Float3 p) { return std::abs(dot(p, axes.right) - sideways.across) / away(p); });
  tangent = std::min(tangent, margin * std::max((up + down) / 2, aside / aspect));

  // The scene lies a little below the middle: more sky than ground.
  const float least = up - tangent / margin, most = tangent / margin - down;
  const float shift = std::max(least, std::min(most, (up - down) / 2 + 0.13F * tangent));
  Float3 eye = axes.world({sideways.across, 0, depth});
  eye.y = eye_height;
  return lens(eye, axes, tangent, aspect, shift);
}

Lens aim_freely(const RayScene& world, const Camera& camera, float aspect) {
  const Float3 eye = world.to_world(camera.eye), target = world.to_world(camera.target);
  const Float3 direction = target - eye;
  const bool is_usable = is_finite(eye) && is_finite(target) && length(direction) > 1e-6F;
  const double degrees =
      std::isfinite(camera.field_of_view) ? std::clamp(camera.field_of_view, 1.0, 150.0) : 35;
  return lens(is_usable ? eye : Float3{0, eye_height, 0},
              Axes(is_usable ? direction : Float3{0, 0, -1}), std::tan(radians(degrees) / 2),
              aspect);
}

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  if (!std::isfinite(value)) return {};
  return value;
}

std::string_view trim(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

std::optional<Camera> parse_camera(std::string_view text) {
  Camera camera;
  if (text == "iso") return camera;
  camera.view = Camera::View::street;
  if (text == "street") return camera;

  std::array<double, 6> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == values.size())) return {};
    const auto value = parse_number(trim(text.substr(0, comma)));
    if (!value) return {};
    values[i] = *value;
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
  }
  camera.view = Camera::View::free;
  camera.eye = {values[0], values[1], values[2]};
  camera.target = {values[3], values[4], values[5]};
  if (camera.eye == camera.target) return {};
  return camera;
}

Lens aim(const RayScene& world, const Tracer& tracer, const PictureOptions& options) {
  const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
  switch (options.camera.view) {
    case Camera::View::iso:
      return aim_iso(world, aspect);
    case Camera::View::free:
      return aim_freely(world, options.camera, aspect);
    case Camera::View::street:
      break;
  }
  if (world.radius <= large) return aim_at_front(world, 40, aspect);
  const Stand stand = find_street(world, tracer);
  const float tangent = std::tan(radians(48) / 2);
  return lens(stand.eye, Axes(stand.direction), tangent, aspect, 0.35F * tangent);
}

}  // namespace mansard
