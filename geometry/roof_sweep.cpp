#include "geometry/roof_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/roof_parts.hpp"

namespace mansard {

double Sweep::height(std::size_t k, double s) const {
  const Strip& strip = strips[k];
  const bool before = k == 0 && s < strip.begin;
  const bool behind = k + 1 == strips.size() && s > strip.end;
  if (level_eaves && before) return strip.low;
  if (level_eaves && behind) return strip.high;
  if (s == strip.begin) return strip.low;
  if (s == strip.end) return strip.high;
  const double share = (s - strip.begin) / (strip.end - strip.begin);
  return strip.low + (strip.high - strip.low) * share;
}

double Sweep::highest() const {
  double most = 0;
  for (const Strip& strip : strips) most = std::max({most, strip.low, strip.high});
  return most;
}

namespace {

Sweep two_planes(double span, double ridge, double front_rise) {
  return {{{0, ridge, 0, ridge * front_rise}, {ridge, span, ridge * front_rise, 0}}, false};
}

Sweep teeth(double span, double width, double rise) {
  constexpr double most = 1000;  // teeth
  const int count = static_cast<int>(std::clamp(std::round(span / width), 1.0, most));
  Sweep sweep;
  const double tooth = span / count;
  for (int i = 0; i < count; ++i) {
    sweep.strips.push_back({i * tooth, i + 1 == count ? span : (i + 1) * tooth, tooth * rise, 0});
  }
  return sweep;
}

Sweep arc(double span, double pitch) {
  const double half = pitch * (std::numbers::pi / 180), radius = span / 2 / std::sin(half);
  const int pieces = 2 * std::max(2, static_cast<int>(std::ceil(pitch / 10)));
  Sweep sweep;
  sweep.level_eaves = pitch > steep_eaves;
  const auto point = [&](int i) {
    const double angle = half * (2.0 * i / pieces - 1);
    const double s = span / 2 + radius * std::sin(angle);
    return Vec2{s, radius * (std::cos(angle) - std::cos(half))};
  };
  for (int i = 0; i < pieces; ++i) {
    const Vec2 a = i == 0 ? Vec2{} : point(i), b = i + 1 == pieces ? Vec2{span, 0} : point(i + 1);
    sweep.strips.push_back({a.x, b.x, a.y, b.y});
  }
  return sweep;
}

Sweep by_pitch(const RoofOptions& options, double span) {
  const double pitch = std::clamp(pitch_of(options), 0.01, 89.0), rise = rise_of(pitch);
  switch (options.kind) {
    case RoofKind::shed:
      return {{{0, span, 0, span * rise}}, false};
    case RoofKind::saltbox: {
      const double back = rise_of(options.upper_pitch > 0 ? options.upper_pitch : pitch * 0.6);
      return two_planes(span, span * back / (rise + back), rise);
    }
    case RoofKind::sawtooth:
      return teeth(span, options.tooth, rise);
    case RoofKind::barrel:
      return arc(span, pitch);
    default:
      return two_planes(span, span / 2, rise);
  }
}

}  // namespace

Sweep sweep_of(const RoofOptions& options, double span, double height) {
  Sweep sweep = by_pitch(options, span);
  if (height <= 0) return sweep;
  const double scale = height / sweep.highest();
  for (Sweep::Strip& strip : sweep.strips) {
    strip.low *= scale;
    strip.high *= scale;
  }
  return sweep;
}

}  // namespace mansard
