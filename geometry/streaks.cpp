#include "geometry/streaks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/box_index.hpp"
#include "geometry/random.hpp"
#include "geometry/stain_atlas.hpp"

namespace mansard {
namespace {

constexpr double thin = 1e-6;       ///< metres; what is thinner is nothing
constexpr double shortest = 0.02;   ///< metres; shorter stains are not worth a face
constexpr double narrowest = 0.15;  ///< metres; narrower things shed no water to speak of
constexpr double widest = 2.2;      ///< metres of one stain; ledges get several side by side
constexpr double reach = 0.4;       ///< metres that a wall may lie behind the front of a ledge
constexpr double parallel = 1 - 1e-7;

/// A stain to be: a strip below a drip. Places of a wall are (along the drip, up from it).
struct Lane {
  double left, right;  ///< of the cell of the atlas
  double length;       ///< downwards
  int column, strength;
  bool mirrored;

  Vec2 uv(Vec2 p) const {
    const double across = (p.x - left) / (right - left);
    return StainAtlas::uv(column, strength, mirrored ? 1 - across : across, -p.y / length);
  }
};

/// Faces in one plane, `at` metres before the drip's back.
struct Plane {
  double at;
  std::vector<std::vector<Vec2>> faces;
};

/// What a face covers between two uprights: its border is straight there.
struct Cover {
  Vec2 top, bottom;  ///< heights at the left and at the right
  double upper() const { return (top.x + top.y) / 2; }
  double lower() const { return (bottom.x + bottom.y) / 2; }
};
struct Piece {
  double left, right;
  Cover cover;
};

/// Whether they are one rectangle.
bool goes_on(const Piece& before, const Piece& piece) {
  const auto is_level = [](Vec2 heights) { return std::abs(heights.x - heights.y) < thin; };
  const Cover &a = before.cover, &b = piece.cover;
  return piece.left - before.right < 2 * thin && is_level(a.top) && is_level(a.bottom) &&
         is_level(b.top) && is_level(b.bottom) && is_level({a.top.y, b.top.x}) &&
         is_level({a.bottom.y, b.bottom.x});
}

class Streaks {
 public:
  Streaks(Surface& surface, std::span<const Drip> drips, std::span<const uint32_t> walls);
  void stain_below(const Drip& drip);

 private:
  void find_planes(const Drip& drip);
  void find_ledges(const Drip& drip);
  std::vector<Lane> lanes(const Drip& drip) const;
  void find_cuts(const Lane& lane, const Plane& plane);
  void stain(const Drip& drip, const Lane& lane, const Plane& plane);
  std::optional<Cover> runs_down(const Plane& plane, double left, double right, double end);
  void find_covers(const Plane& plane, double left, double right);
  double end_of(const Lane& lane, const Plane& plane, double along) const;
  void draw(const Drip& drip, const Lane& lane, const Plane& plane, const Piece& piece);

  /// What stops water: another ledge below.
  struct Ledge {
    double left, right, top, back, front;
  };

  Surface& surface_;
  std::span<const Drip> drips_;
  std::vector<uint32_t> walls_;  ///< polygons that stand upright
  BoxIndex wall_index_, drip_index_;
  // ---- of the drip at hand
  double length_ = 0;  ///< of its longest streak
  std::vector<Plane> planes_;
  std::vector<Ledge> ledges_;
  std::vector<uint32_t> near_;
  std::vector<double> cuts_;
  std::vector<Vec2> borders_;  ///< heights at the left and at the right
  std::vector<Cover> covers_;
  std::vector<Piece> pieces_;
};

Vec3 right_of(const Drip& drip) { return normalized(drip.to - drip.from); }

Box3 box_of(const Drip& drip) {
  const Vec3 front = drip.out * drip.depth;
  const std::array corners{drip.from, drip.to, drip.from + front, drip.to + front};
  Box3 box = bounds(corners);
  box.high.y = std::max(box.high.y, drip.top);
  return box;
}

Streaks::Streaks(Surface& surface, std::span<const Drip> drips, std::span<const uint32_t> walls)
    : surface_(surface), drips_(drips) {
  std::vector<Box3> boxes;
  for (const uint32_t polygon : walls) {
    if (std::abs(surface.normals[polygon].y) > 1e-4) continue;
    walls_.push_back(polygon);
    boxes.push_back(bounds(surface.loop(polygon)));
  }
  wall_index_.build(boxes);
  boxes.clear();
  for (const Drip& drip : drips) boxes.push_back(box_of(drip));
  drip_index_.build(boxes);
}

void Streaks::stain_below(const Drip& drip) {
  if (!(length(drip.to - drip.from) >= narrowest) || !(drip.rate > 0)) return;
  const std::vector<Lane> all = lanes(drip);
  length_ = 0;
  for (const Lane& lane : all) length_ = std::max(length_, lane.length);
  find_planes(drip);
  if (planes_.empty()) return;
  find_ledges(drip);
  for (const Lane& lane : all) {
    for (const Plane& plane : planes_) stain(drip, lane, plane);
  }
}

/// One for a sill, a little wider than it is; side by side for a ledge.
std::vector<Lane> Streaks::lanes(const Drip& drip) const {
  const double width = length(drip.to - drip.from);
  uint64_t drawn = 0;
  const auto draw = [&](double low, double high) {
    return low + (high - low) * unit_interval(mix(drip.seed, drawn++));
  };
  const auto made = [&](double left, double right) {
    const double long_as = std::min(1.0, 0.5 + (right - left) / 2);
    const double level = drip.rate * StainAtlas::strengths - 1 + draw(-0.5, 0.5);
    return Lane{left,
                right,
                draw(0.9, 1.8) * (0.6 + 0.8 * drip.rate) * long_as,
                static_cast<int>(draw(0, StainAtlas::columns)),
                static_cast<int>(std::clamp(std::round(level), 0.0, StainAtlas::strengths - 1.0)),
                draw(0, 1) < 0.5};
  };
  if (width <= widest) {
    const double beside = width * StainAtlas::margin / (1 - 2 * StainAtlas::margin);
    return {made(-beside, width + beside)};
  }
  std::vector<Lane> all;
  const auto count = std::max(2.0, std::round(width / 1.3));
  double left = 0;
  for (double i = 1; i <= count; ++i) {
    const double right = i < count ? (i + draw(-0.3, 0.3)) * width / count : width;
    all.push_back(made(left, right));
    left = right;
  }
  return all;
}

void Streaks::find_planes(const Drip& drip) {
  planes_.clear();
  const double deepest = std::min(0.0, drip.depth - reach) - 0.03, front = drip.depth + stain_gap;
  const double beside = length(drip.to - drip.from);
  const Vec3 right = right_of(drip), wider = right * std::min(beside, 1.0);
  const Vec3 down{0, -length_, 0};
  const std::array corners{
      drip.from - wider + drip.out * deepest, drip.to + wider + drip.out * front,
      drip.from - wider + drip.out * front + down, drip.to + wider + drip.out * deepest};
  wall_index_.near(bounds(corners), near_);
  for (const uint32_t number : near_) {
    const uint32_t polygon = walls_[number];
    if (dot(surface_.normals[polygon], drip.out) < parallel) continue;
    const std::span<const Vec3> loop = surface_.loop(polygon);
    const double at = dot(loop[0] - drip.from, drip.out);
    if (at < deepest || at > front) continue;
    auto plane =
        std::ranges::find_if(planes_, [&](const Plane& p) { return std::abs(p.at - at) < 1e-3; });
    if (plane == planes_.end()) plane = planes_.insert(planes_.end(), {at, {}});
    std::vector<Vec2>& face = plane->faces.emplace_back();
    for (const Vec3 p : loop) face.push_back({dot(p - drip.from, right), p.y - drip.from.y});
  }
}

void Streaks::find_ledges(const Drip& drip) {
  ledges_.clear();
  Box3 below = box_of(drip);
  below.low.y -= length_;
  drip_index_.near(grown(below, reach), near_);
  const Vec3 right = right_of(drip);
  for (const uint32_t number : near_) {
    const Drip& other = drips_[number];
    const double top = other.top - drip.from.y;
    if (&other == &drip || top > -shortest || dot(other.out, drip.out) < parallel) continue;
    const double back = dot(other.from - drip.from, drip.out);
    ledges_.push_back({dot(other.from - drip.from, right), dot(other.to - drip.from, right), top,
                       back, back + other.depth});
  }
}

/// Where uprights are needed so that between two of them every border is straight.
void Streaks::find_cuts(const Lane& lane, const Plane& plane) {
  cuts_.assign({lane.left, lane.right});
  const auto add = [&](double along) {
    if (along > lane.left && along < lane.right) cuts_.push_back(along);
  };
  for (const std::vector<Vec2>& face : plane.faces) {
    for (const Vec2 p : face) add(p.x);
  }
  for (const Ledge& ledge : ledges_) {
    add(ledge.left);
    add(ledge.right);
  }
  std::ranges::sort(cuts_);
}

void Streaks::stain(const Drip& drip, const Lane& lane, const Plane& plane) {
  find_cuts(lane, plane);
  pieces_.clear();
  for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) {
    const double left = cuts_[i], right = cuts_[i + 1];
    if (right - left < thin) continue;
    const auto run = runs_down(plane, left, right, end_of(lane, plane, (left + right) / 2));
    if (!run) continue;
    const Piece piece{left, right, *run};
    if (!pieces_.empty() && goes_on(pieces_.back(), piece)) {
      pieces_.back().right = right;
    } else {
      pieces_.push_back(piece);
    }
  }
  for (const Piece& piece : pieces_) draw(drip, lane, plane, piece);
}

/// How far down water may run: to the upper side of the next ledge at most.
double Streaks::end_of(const Lane& lane, const Plane& plane, double along) const {
  double end = -lane.length;
  for (const Ledge& ledge : ledges_) {
    const bool crosses = along > ledge.left && along < ledge.right;
    if (crosses && plane.at > ledge.back - reach && plane.at < ledge.front + stain_gap)
      end = std::max(end, ledge.top);
  }
  return end;
}

/// What the faces cover without a break from the drip down to `end`.
std::optional<Cover> Streaks::runs_down(const Plane& plane, double left, double right, double end) {
  find_covers(plane, left, right);
  std::optional<Cover> run;
  double at = 0;
  for (const Cover& cover : covers_) {
    // Splits leave hairs between faces; a ledge may be set into the wall.
    const double gap = run ? stain_gap : shortest;
    if (cover.upper() < at - gap || at <= end) break;
    if (cover.lower() >= at - thin) continue;
    if (!run) run = Cover{{std::min(0.0, cover.top.x), std::min(0.0, cover.top.y)}, {}};
    run->bottom = cover.bottom;
    at = cover.lower();
  }
  if (!run) return run;
  run->bottom = {std::max(run->bottom.x, end), std::max(run->bottom.y, end)};
  const bool is_long = run->upper() - run->lower() > shortest &&
                       run->top.x - run->bottom.x > -thin && run->top.y - run->bottom.y > -thin;
  return is_long ? run : std::nullopt;
}

/// Of all faces, the highest first.
void Streaks::find_covers(const Plane& plane, double left, double right) {
  covers_.clear();
  const double middle = (left + right) / 2;
  for (const std::vector<Vec2>& face : plane.faces) {
    borders_.clear();
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec2 a = face[i], b = face[(i + 1) % face.size()];
      if ((a.x <= middle) == (b.x <= middle)) continue;
      const auto height = [&](double x) { return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x); };
      borders_.push_back({height(left), height(right)});
    }
    std::ranges::sort(borders_, {}, [](Vec2 border) { return border.x + border.y; });
    for (std::size_t i = 0; i + 1 < borders_.size(); i += 2)
      covers_.push_back({borders_[i + 1], borders_[i]});
  }
  std::ranges::sort(covers_, std::greater{}, &Cover::upper);
}

void Streaks::draw(const Drip& drip, const Lane& lane, const Plane& plane, const Piece& piece) {
  const Cover& c = piece.cover;
  const std::array corners{Vec2{piece.left, c.bottom.x}, Vec2{piece.right, c.bottom.y},
                           Vec2{piece.right, c.top.y}, Vec2{piece.left, c.top.x}};
  const Vec3 right = right_of(drip), ahead = drip.out * (plane.at + stain_gap);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 p = corners[i];
    if (length(p - corners[(i + 1) % 4]) < thin) continue;
    surface_.points.push_back(drip.from + right * p.x + Vec3{0, p.y, 0} + ahead);
    surface_.uvs.push_back(lane.uv(p));
  }
  surface_.ends.push_back(static_cast<uint32_t>(surface_.points.size()));
  surface_.normals.push_back(drip.out);
}

}  // namespace

void add_streaks(Surface& surface, std::span<const Drip> drips, std::span<const uint32_t> walls,
                 uint32_t symbol, uint32_t material) {
  const std::size_t before = surface.polygons();
  Streaks streaks(surface, drips, walls);
  for (const Drip& drip : drips) streaks.stain_below(drip);
  if (surface.polygons() > before)
    surface.runs.push_back({symbol, material, static_cast<uint32_t>(surface.polygons())});
}

}  // namespace mansard
