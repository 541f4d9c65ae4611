// Roofs over the footprints of real towns: as they are, turned, far away, and with points inserted
// on their edges.
#include <doctest/doctest.h>

#include <cstdlib>
#include <ctime>
#include <map>
#include <random>

#include "geometry/skeleton.hpp"
#include "tests/geometry/roof_input.hpp"
#include "tests/geometry/roof_laws.hpp"

namespace mansard {
namespace {

using test::Named;

constexpr std::array<const char*, 4> variants{"as is", "turned", "far away",
                                              "with points inserted"};

Polygon turned(const Polygon& polygon) {
  Polygon out = polygon;
  const double c = std::cos(0.3217), s = std::sin(0.3217);
  for (Vec2& p : out.points) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  return out;
}

// One to three on every edge, exact and a little off.
Polygon with_points(const Polygon& polygon, unsigned seed) {
  std::mt19937 random(seed);
  Polygon out;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const uint32_t begin = polygon.ring_begin(r), end = polygon.ring_ends[r];
    for (uint32_t i = begin; i < end; ++i) {
      const Vec2 a = polygon.points[i], b = polygon.points[i + 1 == end ? begin : i + 1];
      out.add_point(a, polygon.tags[i]);
      const unsigned count = 1 + random() % 3;
      for (unsigned k = 1; k <= count; ++k)
        out.add_point(mix(a, b, k / (count + 1.0)), polygon.tags[i]);
    }
    out.close_ring();
  }
  return out;
}

Polygon variant(const Polygon& polygon, std::size_t which, unsigned seed) {
  if (which == 1) return turned(polygon);
  if (which == 2) {
    Polygon out = polygon;
    translate(out, {6e6, -6e6});
    return out;
  }
  return which == 3 ? with_points(polygon, seed) : polygon;
}

bool all_footprints() { return std::getenv("MANSARD_LONG_TESTS") != nullptr; }

std::vector<Named> footprints(std::size_t step) {
  std::vector<Named> found =
      test::real_footprints(all_footprints() ? 1 : step, all_footprints() ? 1 : 12);
  if (found.empty()) MESSAGE("no real footprints beside the project: skipped");
  return found;
}

double cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Tally {
  int roofs = 0;
  std::map<int, int> rungs;
};

TEST_CASE("roofs over real footprints obey every law") {
  std::map<std::string, int> broken;
  std::map<std::string, Tally> tallies;
  double slowest = 0;
  unsigned seed = 0;
  for (const Named& named : footprints(150)) {
    ++seed;
    for (std::size_t v = 0; v < variants.size(); ++v) {
      const Polygon polygon = variant(named.polygon, v, seed);
      for (const RoofOptions& options : test::all_kinds()) {
        const double before = cpu();
        const Roof made = roof(polygon, options);
        slowest = std::max(slowest, cpu() - before);
        Tally& tally =
            tallies[named.set + ", kind " + std::to_string(static_cast<int>(options.kind))];
        ++tally.roofs;
        ++tally.rungs[made.fallback];
        const std::string why = test::broken_law(polygon, options, made, 1e-5);
        if (why.empty()) continue;
        const std::string which = why + ", kind " + std::to_string(static_cast<int>(options.kind));
        if (++broken[which] < 4) {
          MESSAGE(named.name << " " << std::string(variants[v]) << " overhang " << options.overhang
                             << ": " << which);
        }
      }
    }
  }
  for (const auto& [where, tally] : tallies) {
    for (const auto& [rung, n] : tally.rungs) {
      if (rung > 1) MESSAGE(where << ": " << n << " of " << tally.roofs << " took rung " << rung);
    }
  }
  MESSAGE("slowest roof " << slowest << " s");
  CHECK(slowest < 2);
  for (const auto& [why, n] : broken) FAIL_CHECK(why << ": " << n);
}

TEST_CASE("hip roofs over real footprints have the pitch that was asked for") {
  double most = 0;
  for (const Named& named : footprints(20)) {
    for (const double pitch : {20.0, 45.0, 70.0}) {
      RoofOptions options;
      options.pitch = pitch;
      const Roof made = roof(named.polygon, options);
      if (made.fallback > 1) continue;
      const double error = test::pitch_error(made, pitch, 0);
      most = std::max(most, error);
      if (error > 1e-3) FAIL_CHECK(named.name << ": " << error << " degrees off " << pitch);
    }
  }
  MESSAGE("at most " << most << " degrees off");
}

// The triangles of a hip roof that end a ridge: the slopes beside them fall to opposite sides.
// Those between the facets of a curve, or over a corner cut off, end none.
int hip_ends(const SkeletonOn& on) {
  if (on.quad_first) return 2;  // a square's four are one ridge's
  const std::vector<WallLine> lines = wall_lines(on.polygon);
  const uint32_t n = on.polygon.ring_ends[0];
  int ends = 0;
  for (uint32_t e = 0; e < n; ++e) {
    const Vec2 left = lines[(e + n - 1) % n].normal, right = lines[(e + 1) % n].normal;
    ends += on.mesh.face(e).size() == 3 && dot(left, right) < 0;
  }
  return ends;
}

TEST_CASE("nearly all hip ends of real footprints become gables") {
  struct Ends {
    int hips = 0, gables = 0;
  };
  std::map<std::string, Ends> sets;
  Ends all;
  RoofOptions options;
  options.kind = RoofKind::gable;
  for (const Named& named : footprints(5)) {
    const auto on = best_skeleton(named.polygon);
    if (!on || on->fallback > 1) continue;
    int gables = 0;
    for (const RoofFace& face : roof(named.polygon, options).faces) {
      gables += face.part == RoofPart::gable;
    }
    Ends& set = sets[named.set];
    const int hips = hip_ends(*on);
    set.hips += hips;
    set.gables += gables;
    if (named.set == "hard") continue;  // not a town
    all.hips += hips;
    all.gables += gables;
  }
  for (const auto& [set, ends] : sets) {
    MESSAGE(set << ": " << ends.gables << " gables of " << ends.hips << " hip ends, "
                << 100.0 * ends.gables / std::max(ends.hips, 1) << " %");
  }
  if (all.hips == 0) return;
  MESSAGE("together " << 100.0 * all.gables / all.hips << " %");
  CHECK(all.gables >= 0.96 * all.hips);
  CHECK(all.gables <= all.hips);
}

}  // namespace
}  // namespace mansard
