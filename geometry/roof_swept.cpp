// Roofs that are one profile swept along a direction: sheds, saltboxes, teeth, barrels, and the
// single ridge that any footprint can have. The footprint is cut into strips where the profile
// bends; walls reach up to it.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/clean.hpp"
#include "geometry/clip.hpp"
#include "geometry/roof_parts.hpp"
#include "geometry/roof_sweep.hpp"

namespace mansard {
namespace {

using Key = std::pair<double, double>;
Key key_of(Vec2 p) { return {p.x, p.y}; }

constexpr double same_level = 1e-7;  // metres
constexpr double thinnest = 0.02;    // metres; a sliver has no room for a profile

// The plan in the frame of the sweep: x along the ridge, y the distance s from the front. Points
// know where they came from, so that they go back to the very same place.
class Frame {
 public:
  Frame(Vec2 along, double front) : along_(along), inwards_(left_of(along)), front_(front) {}

  Vec2 in(Vec2 p) {
    Vec2 q{dot(p, along_), dot(p, inwards_) - front_};
    for (const double level : levels_) {
      if (std::abs(q.y - level) < same_level) q.y = level;
    }
    places_.try_emplace(key_of(q), p);
    return q;
  }
  // Points as near to it as rounding leaves them are on a level.
  void add_level(double s) { levels_.push_back(s); }
  Vec2 out(Vec2 q) const {
    const auto found = places_.find(key_of(q));
    return found != places_.end() ? found->second : along_ * q.x + inwards_ * (q.y + front_);
  }
  // Where the line from p to q crosses a level, the same in both directions.
  Vec2 crossing(Vec2 p, Vec2 q, double level) const {
    if (key_of(q) < key_of(p)) std::swap(p, q);
    return {p.x + (q.x - p.x) * (level - p.y) / (q.y - p.y), level};
  }

 private:
  Vec2 along_, inwards_;
  double front_;
  std::vector<double> levels_;
  std::map<Key, Vec2> places_;
};

class SweptRoof {
 public:
  SweptRoof(Roof& roof, const Polygon& footprint, const RoofOptions& options, Vec2 along)
      : roof_(roof), footprint_(footprint), frame_(frame_for(footprint, along)) {
    double span = 0;
    for (const Vec2 p : footprint.points) span = std::max(span, frame_.in(p).y);
    overhang_ =
        options.kind == RoofKind::sawtooth || has_party_wall(footprint) ? 0 : options.overhang;
    thickness_ = overhang_ > 0 ? thickness_of(options) : 0;
    roof.low = thickness_ > 0 && thickness_ < options.thickness;
    sweep_ = sweep_of(options, span, options.height > 0 ? options.height - thickness_ : 0);
    move_levels();
    frame_.add_level(0);
    for (const Sweep::Strip& strip : sweep_.strips) frame_.add_level(strip.end);
    along_ = along;
    verge_ = verge_of(options);
  }

  void build() {
    Polygon outer = footprint_;
    if (overhang_ > 0) outer.points = move_outline(footprint_, reaches()).points;
    add_tops(divided(outer));
    for_each_edge(footprint_, [&](uint32_t e, Vec2 a, Vec2 b) { add_wall(e, a, b); });
    if (overhang_ <= 0) return;
    const std::vector<uint32_t> next = next_points(footprint_);
    for (uint32_t e = 0; e < next.size(); ++e) {
      add_edge(e, footprint_.points[e], footprint_.points[next[e]], outer.points[e],
               outer.points[next[e]]);
    }
  }

 private:
  static Frame frame_for(const Polygon& polygon, Vec2 along) {
    double front = 1e300;
    for (const Vec2 p : polygon.points) front = std::min(front, dot(p, left_of(along)));
    return {along, front};
  }

  // A level beside a corner of the footprint goes through it, so that no slivers arise.
  void move_levels() {
    for (std::size_t k = 0; k + 1 < sweep_.strips.size(); ++k) {
      for (const Vec2 p : footprint_.points) {
        const double s = frame_.in(p).y;
        const bool inside = s > sweep_.strips[k].begin && s < sweep_.strips[k + 1].end;
        if (!inside || std::abs(s - sweep_.strips[k].end) > 1e-3) continue;
        sweep_.strips[k].end = sweep_.strips[k + 1].begin = s;
        break;
      }
    }
  }

  std::vector<double> reaches() const {
    std::vector<double> reach(footprint_.points.size(), overhang_);
    for_each_edge(footprint_, [&](uint32_t e, Vec2 a, Vec2 b) {
      if (std::abs(dot(normalized(b - a), along_)) <= 0.7) reach[e] = verge_;
    });
    return reach;
  }

  // A line from p to q in the frame, with the points where it crosses levels.
  std::vector<Vec2> cut_line(Vec2 p, Vec2 q) const {
    std::vector<Vec2> points{p};
    const auto cross_level = [&](double level) {
      if ((p.y - level) * (q.y - level) < 0) points.push_back(frame_.crossing(p, q, level));
    };
    const std::size_t n = sweep_.strips.size();
    for (std::size_t k = 1; k < n; ++k) {
      cross_level(p.y < q.y ? sweep_.strips[k].begin : sweep_.strips[n - k].begin);
    }
    if (sweep_.level_eaves && overhang_ > 0) {  // where the level eaves begin
      cross_level(0);
      cross_level(sweep_.strips.back().end);
      std::sort(points.begin() + 1, points.end(),
                [&](Vec2 a, Vec2 b) { return p.y < q.y ? a.y < b.y : a.y > b.y; });
    }
    points.push_back(q);
    return points;
  }

  // The polygon in the frame, with points wherever it crosses a level.
  Polygon divided(const Polygon& polygon) {
    Polygon cut;
    for (std::size_t r = 0; r < polygon.rings(); ++r) {
      const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
      for (uint32_t i = begin; i < end; ++i) {
        const Vec2 a = polygon.points[i], b = polygon.points[i + 1 == end ? begin : i + 1];
        const std::vector<Vec2> line = cut_line(frame_.in(a), frame_.in(b));
        for (std::size_t k = 0; k + 1 < line.size(); ++k) cut.add_point(line[k], polygon.tags[i]);
      }
      cut.close_ring();
    }
    return cut;
  }

  struct Band {
    double begin, end;
    std::size_t strip;
  };
  // The strips, and before and behind them what lies outside of the walls.
  std::vector<Band> bands() const {
    constexpr double far = 1e9;
    std::vector<Band> all;
    const std::size_t n = sweep_.strips.size();
    const bool apart = sweep_.level_eaves && overhang_ > 0;
    if (apart) all.push_back({-far, 0, 0});
    for (std::size_t k = 0; k < n; ++k) {
      const double begin = k == 0 && !apart ? -far : sweep_.strips[k].begin;
      const double end = k + 1 == n && !apart ? far : sweep_.strips[k].end;
      all.push_back({begin, end, k});
    }
    if (apart) all.push_back({sweep_.strips.back().end, far, n - 1});
    return all;
  }

  Vec3 place(Vec2 q, std::size_t strip, double up) const {
    const Vec2 p = frame_.out(q);
    return {p.x, p.y, sweep_.height(strip, q.y) + up};
  }

  void add_tops(const Polygon& plan) {
    for (const Band& band : bands()) {
      for (const Polygon& piece : clip_strip(plan, 1, band.begin, band.end)) {
        add_piece(piece, band.strip);
        add_step(piece, band);
      }
    }
  }

  void add_piece(const Polygon& piece, std::size_t strip) {
    RoofFace face{RoofPart::slope, lowest_tag(piece, strip), {}, {}, {}};
    for (std::size_t r = 0; r < piece.rings(); ++r) {
      std::vector<Vec3>& ring = r == 0 ? face.loop : face.holes.emplace_back();
      for (const Vec2 q : piece.ring(r)) ring.push_back(place(q, strip, thickness_));
    }
    roof_.faces.push_back(std::move(face));
  }

  // That of the wall under the piece's lowest edge.
  EdgeTag lowest_tag(const Polygon& piece, std::size_t strip) const {
    EdgeTag tag;
    double least = 1e300;
    for_each_edge(piece, [&](uint32_t e, Vec2 a, Vec2 b) {
      const double up = sweep_.height(strip, a.y) + sweep_.height(strip, b.y);
      if (piece.tags[e].wall == EdgeTag::no_wall || up >= least) return;
      least = up;
      tag = piece.tags[e];
    });
    return tag;
  }

  // The upright face between a strip and the one before it, where that is lower.
  void add_step(const Polygon& piece, const Band& band) {
    if (band.strip == 0 || band.begin != sweep_.strips[band.strip].begin) return;
    const double low = sweep_.strips[band.strip - 1].high, high = sweep_.strips[band.strip].low;
    if (high - low < 1e-9) return;
    for_each_edge(piece, [&](uint32_t e, Vec2 p, Vec2 q) {
      if (p.y != band.begin || q.y != band.begin || !piece.tags[e].has(EdgeTag::cut)) return;
      const Vec2 a = frame_.out(p), b = frame_.out(q);
      add_face(roof_, RoofPart::gable, piece.tags[e],
               std::array{Vec3{a.x, a.y, low}, Vec3{b.x, b.y, low}, Vec3{b.x, b.y, high},
                          Vec3{a.x, a.y, high}});
    });
  }

  // The strip on the left side of the line from p to q, which crosses no level.
  std::size_t strip_at(Vec2 p, Vec2 q) const {
    const double s = (p.y + q.y) / 2;
    const bool turned = p.y == q.y && q.x < p.x;
    std::size_t k = 0;
    while (k + 1 < sweep_.strips.size() &&
           (turned ? s > sweep_.strips[k].end : s >= sweep_.strips[k].end)) {
      ++k;
    }
    return k;
  }

  // The wall between its top and the roof, in pieces that stand apart where the roof comes down.
  void add_wall(uint32_t e, Vec2 a, Vec2 b) {
    const std::vector<Vec2> line = cut_line(frame_.in(a), frame_.in(b));
    std::vector<Vec3> foot, top;
    const auto finish = [&] {
      foot.insert(foot.end(), top.rbegin(), top.rend());
      if (foot.size() > 2) add_face(roof_, RoofPart::gable, footprint_.tags[e], foot);
      foot.clear();
      top.clear();
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const std::size_t strip = strip_at(line[i], line[i + 1]);
      for (const Vec2 q : {line[i], line[i + 1]}) {
        const Vec3 up = place(q, strip, 0);
        const Vec3 down{up.x, up.y, 0};
        const bool ends = i == 0 || i + 2 == line.size() || up.z == 0;
        if (ends && (foot.empty() || foot.back() != down)) foot.push_back(down);
        if (top.empty() || top.back() != up) top.push_back(up);
        if (up.z == 0 && top.size() > 1) {
          finish();
          foot = {down};
          top = {up};
        }
      }
    }
    finish();
  }

  // Soffit and fascia outside of the wall from a to b, whose outer corners are c (at a) and d.
  void add_edge(uint32_t e, Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const EdgeTag tag = footprint_.tags[e];
    const std::vector<Vec2> line = cut_line(frame_.in(c), frame_.in(d));
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const std::size_t strip = strip_at(line[i], line[i + 1]);
      add_face(
          roof_, RoofPart::fascia, tag,
          std::array{place(line[i], strip, 0), place(line[i + 1], strip, 0),
                     place(line[i + 1], strip, thickness_), place(line[i], strip, thickness_)});
    }
    if (a == c && b == d) return;
    Polygon band;
    for (const Vec2 p : {a, c, d, b}) {
      if (band.empty() || band.points.back() != p) band.add_point(p, tag);
    }
    band.close_ring();
    const Polygon cut = divided(band);
    for (const Band& part : bands()) {
      for (const Polygon& piece : clip_strip(cut, 1, part.begin, part.end)) {
        std::vector<Vec3> loop;
        for (const Vec2 q : piece.ring(0)) loop.push_back(place(q, part.strip, 0));
        std::reverse(loop.begin(), loop.end());
        add_face(roof_, RoofPart::soffit, tag, loop);
      }
    }
  }

  Roof& roof_;
  const Polygon& footprint_;
  Frame frame_;
  Sweep sweep_;
  Vec2 along_;
  double overhang_ = 0, verge_ = 0, thickness_ = 0;
};

// Along the edge that was asked for, else along the longest one; teeth stand across that.
Vec2 direction_of(const Polygon& polygon, const RoofOptions& options) {
  Vec2 longest, asked;
  for_each_edge(polygon, [&](uint32_t e, Vec2 a, Vec2 b) {
    if (length(b - a) > length(longest) + 1e-6) longest = b - a;
    if (options.ridge == e) asked = b - a;
  });
  if (length(asked) > 0) return normalized(asked);
  return normalized(options.kind == RoofKind::sawtooth ? left_of(longest) : longest);
}

}  // namespace

std::optional<Roof> swept_roof(const Polygon& polygon, const RoofOptions& options) {
  if (polygon.empty() || polygon.rings() == 0) return std::nullopt;
  for (const CleanTolerance& tolerance :
       {CleanTolerance{}, CleanTolerance{0.02, 0.02, 1, 0.005, 0.03, 2000}}) {
    const auto cleaned = clean(polygon, tolerance);
    if (!cleaned) continue;
    if (2 * area(cleaned->polygon) < thinnest * perimeter(cleaned->polygon)) return std::nullopt;
    Roof roof;
    SweptRoof(roof, cleaned->polygon, options, direction_of(polygon, options)).build();
    roof.fallback = !is_swept(options.kind) ? 5 : cleaned->moved ? 2 : 1;
    return roof;
  }
  return std::nullopt;
}

}  // namespace mansard
