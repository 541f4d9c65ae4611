#include "geometry/dormer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mansard {
namespace {

/// Of an eyebrow's roof, at most half of what the slope rises.
double eyebrow_edge(const DormerOptions& o, double rise) {
  return o.overhang > 0 ? std::clamp(o.thickness, 0.0, rise / 2) : 0;
}

double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

bool in_range(const DormerOptions& o) {
  const auto angle = [](double degrees) { return degrees > 0 && degrees < 90; };
  if (!(o.width > 0 && o.height > 0 && angle(o.slope))) return false;
  if (o.kind == DormerKind::flat || o.kind == DormerKind::eyebrow) return true;
  return angle(o.pitch) && (o.kind != DormerKind::shed || o.pitch < o.slope);
}

class Wedge {
 public:
  explicit Wedge(const DormerOptions& options)
      : kind_(options.kind),
        w_(options.width),
        depth_(options.height * std::cos(options.slope * std::numbers::pi / 180)),
        slope_(tangent(options.slope)),
        pitch_(has_pitch() ? tangent(options.pitch) : 0),
        rise_(depth_ * slope_),
        front_(front_height(options)),
        over_(std::max(options.overhang, 0.0)) {
    if (has_pitch()) over_ = std::min(over_, front_ / (2 * pitch_));
    thick_ = over_ > 0 ? std::max(options.thickness, 0.0) : 0;
    if (kind_ == DormerKind::eyebrow) thick_ = eyebrow_edge(options, rise_);
  }

  std::vector<DormerFace> build() {
    switch (kind_) {
      case DormerKind::flat:
      case DormerKind::shed:
        one_plane();
        break;
      case DormerKind::gable:
        gabled();
        break;
      case DormerKind::hip:
        hipped();
        break;
      case DormerKind::eyebrow:
        eyebrow();
        break;
    }
    return std::move(faces_);
  }

 private:
  using enum DormerPart;

  bool has_pitch() const { return kind_ != DormerKind::flat && kind_ != DormerKind::eyebrow; }

  void add(DormerPart part, const std::vector<Vec3>& loop) {
    DormerFace face{part, {}};
    for (const Vec3 p : loop) {
      if (face.loop.empty() || length(face.loop.back() - p) > same) face.loop.push_back(p);
    }
    while (face.loop.size() > 1 && length(face.loop.front() - face.loop.back()) <= same)
      face.loop.pop_back();
    if (face.loop.size() >= 3) faces_.push_back(std::move(face));
  }

  Vec3 mirrored(Vec3 p) const { return {w_ - p.x, p.y, p.z}; }

  // A face and its image at the right, which begins with the image of the same edge.
  void add_both(DormerPart part, const std::vector<Vec3>& loop) {
    add(part, loop);
    std::vector<Vec3> image{mirrored(loop[1]), mirrored(loop[0])};
    for (std::size_t i = loop.size(); i-- > 2;) image.push_back(mirrored(loop[i]));
    add(part, image);
  }

  // How far back the slope is at a height; exactly `depth_` at `rise_`.
  double back(double z) const { return depth_ + (z - rise_) / slope_; }

  void walls() {
    add(front, {{0, 0, 0}, {w_, 0, 0}, {w_, 0, front_}, {0, 0, front_}});
    add_both(cheek, {{0, depth_, rise_}, {0, 0, 0}, {0, 0, front_}});
  }

  void one_plane() {
    walls();
    const double o = over_, low = front_ - o * pitch_, high = low + thick_;
    const double end = depth_ + thick_ / (slope_ - pitch_), top_end = end * slope_;
    add(kind_ == DormerKind::flat ? top : slope,
        {{-o, -o, high}, {w_ + o, -o, high}, {w_ + o, end, top_end}, {-o, end, top_end}});
    if (o == 0) return;
    add(soffit, {{w_ + o, -o, low},
                 {-o, -o, low},
                 {-o, depth_, rise_},
                 {0, depth_, rise_},
                 {0, 0, front_},
                 {w_, 0, front_},
                 {w_, depth_, rise_},
                 {w_ + o, depth_, rise_}});
    add(fascia, {{-o, -o, low}, {w_ + o, -o, low}, {w_ + o, -o, high}, {-o, -o, high}});
    add_both(fascia, {{-o, depth_, rise_}, {-o, -o, low}, {-o, -o, high}, {-o, end, top_end}});
  }

  // The eave over the left cheek: underside and upper side, at the front and where they meet the
  // slope.
  struct Eave {
    Vec3 low, high, low_back, high_back;
  };
  Eave left_eave() const {
    const double z = front_ - over_ * pitch_;
    return {{-over_, -over_, z},
            {-over_, -over_, z + thick_},
            {-over_, back(z), z},
            {-over_, back(z + thick_), z + thick_}};
  }

  void gabled() {
    walls();
    const Eave eave = left_eave();
    const double apex = front_ + w_ / 2 * pitch_, high = apex + thick_;
    add(gable, {{0, 0, front_}, {w_, 0, front_}, {w_ / 2, 0, apex}});
    const Vec3 tip{w_ / 2, -over_, high};
    add_both(slope, {eave.high_back, eave.high, tip, {w_ / 2, back(high), high}});
    if (over_ == 0) return;
    const Vec3 below{w_ / 2, -over_, apex};
    add_both(
        soffit,
        {eave.low, eave.low_back, {0, depth_, rise_}, {0, 0, front_}, {w_ / 2, 0, apex}, below});
    add_both(fascia, {eave.low_back, eave.low, eave.high, eave.high_back});
    add_both(fascia, {eave.low, below, tip, eave.high});
  }

  // A shallow hip on a wide front meets the slope before the ridge begins.
  void hipped() {
    walls();
    const Eave eave = left_eave();
    const double high = front_ + w_ / 2 * pitch_ + thick_;
    if (back(high) > w_ / 2 + same) {
      const Vec3 tip{w_ / 2, w_ / 2, high};
      add(slope, {eave.high, mirrored(eave.high), tip});
      add_both(slope, {eave.high_back, eave.high, tip, {w_ / 2, back(high), high}});
    } else {
      const double end = (front_ + thick_) / (slope_ - pitch_);
      const Vec3 tip{end, end, end * slope_};
      add(slope, {eave.high, mirrored(eave.high), mirrored(tip), tip});
      add_both(slope, {eave.high_back, eave.high, tip});
    }
    if (over_ == 0) return;
    const Vec3 corner{0, 0, front_};
    add(soffit, {mirrored(eave.low), eave.low, corner, mirrored(corner)});
    add_both(soffit, {eave.low, eave.low_back, {0, depth_, rise_}, corner});
    add(fascia, {eave.low, mirrored(eave.low), mirrored(eave.high), eave.high});
    add_both(fascia, {eave.low_back, eave.low, eave.high, eave.high_back});
  }

  // Left to right, as (x, z).
  std::vector<Vec2> arc() const {
    constexpr int pieces = 12;
    const double half = w_ / 2, radius = (half * half + front_ * front_) / (2 * front_);
    const double most = std::atan2(half, radius - front_);
    std::vector<Vec2> points;
    for (int i = 0; i <= pieces; ++i) {
      const double angle = most * (2.0 * i / pieces - 1);
      points.push_back({half + radius * std::sin(angle), front_ - radius * (1 - std::cos(angle))});
    }
    points.front() = {0, 0};
    points.back() = {w_, 0};
    return points;
  }

  void eyebrow() {
    const std::vector<Vec2> curve = arc();
    const double o = over_, t = thick_;
    std::vector<Vec3> face{{0, 0, 0}};
    for (std::size_t i = curve.size(); i-- > 1;) face.push_back({curve[i].x, 0, curve[i].y});
    add(front, face);
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
      const Vec2 a = curve[i], b = curve[i + 1];
      const auto end = [&](Vec2 p) { return Vec3{p.x, (p.y + t) / slope_, p.y + t}; };
      add(slope, {{a.x, -o, a.y + t}, {b.x, -o, b.y + t}, end(b), end(a)});
      if (o == 0) continue;
      add(soffit, {{b.x, -o, b.y}, {a.x, -o, a.y}, {a.x, 0, a.y}, {b.x, 0, b.y}});
      add(fascia, {{a.x, -o, a.y}, {b.x, -o, b.y}, {b.x, -o, b.y + t}, {a.x, -o, a.y + t}});
    }
    if (o > 0) add_both(fascia, {{0, 0, 0}, {0, -o, 0}, {0, -o, t}, {0, t / slope_, t}});
    std::vector<Vec3> left;
    for (std::size_t i = 0; 2 * i < curve.size(); ++i)
      left.push_back({curve[i].x, (curve[i].y + t) / slope_, curve[i].y + t});
    left.push_back({w_ / 2, depth_, rise_});
    left.push_back({0, depth_, rise_});
    add_both(rest, left);
  }

  static constexpr double same = 1e-9;

  DormerKind kind_;
  double w_, depth_;      // in plan
  double slope_, pitch_;  // tangents
  double rise_, front_;   // heights of the piece and of the front
  double over_, thick_ = 0;
  std::vector<DormerFace> faces_;
};

}  // namespace

double front_height(const DormerOptions& options) {
  const double angle = options.slope * std::numbers::pi / 180;
  const double depth = options.height * std::cos(angle), rise = depth * std::tan(angle);
  if (options.kind == DormerKind::shed) return depth * (std::tan(angle) - tangent(options.pitch));
  if (options.kind == DormerKind::eyebrow) {
    return std::min(rise - eyebrow_edge(options, rise), options.width / 2);
  }
  return rise;
}

std::vector<DormerFace> dormer(const DormerOptions& options) {
  if (!in_range(options)) return {};
  return Wedge(options).build();
}

}  // namespace mansard
