// Skeletons over every footprint of real towns that is there, as it is and as grammars and maps
// change it.
#include <doctest/doctest.h>

#include <map>
#include <random>

#include "geometry/clean.hpp"
#include "tests/geometry/random_polygons.hpp"
#include "tests/geometry/skeleton_checks.hpp"

namespace mansard {
namespace {

using test::Named;

#if defined(__SANITIZE_ADDRESS__) || !defined(NDEBUG)
constexpr std::size_t step = 40;
#else
constexpr std::size_t step = 1;
#endif

enum Variant : int { as_is, turned, far_away, with_points, with_points_off, variants };
constexpr std::array<const char*, variants> variant_names{
    "as is", "turned", "far away", "with points on edges", "with points off edges by an ULP"};

double next_to(double x, unsigned random) {
  const double far = random % 3 == 0 ? -1e300 : 1e300;
  return random % 3 == 2 ? x : std::nextafter(x, far);
}

Polygon with_more_points(const Polygon& polygon, bool off, unsigned seed) {
  std::mt19937 random(seed);
  Polygon out;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const auto ring = polygon.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      out.add_point(ring[i]);
      for (unsigned k = random() % 3; k > 0; --k) {
        Vec2 p = mix(ring[i], ring[(i + 1) % ring.size()], 1.0 / (k + 1));
        if (off) p = {next_to(p.x, random()), next_to(p.y, random())};
        out.add_point(p);
      }
    }
    out.close_ring();
  }
  return out;
}

Polygon variant(const Polygon& polygon, int which, unsigned seed) {
  if (which == with_points || which == with_points_off) {
    return with_more_points(polygon, which == with_points_off, seed);
  }
  Polygon out = polygon;
  const double c = std::cos(0.3217), s = std::sin(0.3217);
  for (Vec2& p : out.points) {
    if (which == turned) p = {c * p.x - s * p.y, s * p.x + c * p.y};
    if (which == far_away) p = p + Vec2{6e6, 6e6};
  }
  return out;
}

// Of the originals' edges, as long as 0.1 mm at least, that became none: a spike has two.
std::size_t lost_edges(const SkeletonOn& on, const Polygon& original) {
  std::size_t lost = 0;
  for_each_edge(original, [&](uint32_t e, Vec2 a, Vec2 b) {
    lost += on.edge_of[e] == ~0u && length(b - a) > 1e-4;
  });
  return lost;
}

struct Tally {
  int all = 0;
  std::array<int, 3> makers{};
  std::array<int, 4> rungs{};  // none of them is 0
};

TEST_CASE("every real footprint has a skeleton that keeps its promises") {
  std::vector<Named> all = test::real_footprints(step, step);
  if (all.empty()) MESSAGE("no real footprints beside the project: skipped");
  std::map<std::string, Tally> tallies;
  std::map<std::string, int> broken;
  double slowest = 0;
  unsigned seed = 0;
  for (const Named& named : all) {
    const auto plain = best_skeleton(named.polygon);
    ++seed;
    for (int v = 0; v < variants; ++v) {
      const Polygon polygon = variant(named.polygon, v, seed);
      const double before = test::cpu_seconds();
      const auto on = best_skeleton(polygon);
      slowest = std::max(slowest, test::cpu_seconds() - before);
      Tally& tally = tallies[named.set];
      ++tally.all;
      ++tally.rungs[on ? static_cast<std::size_t>(on->fallback) : 0];
      std::string why;
      if (on) {
        ++tally.makers[static_cast<std::size_t>(on->maker)];
        why = test::broken_skeleton(on->mesh, on->polygon);
        if (why.empty()) why = test::broken_map(*on, polygon);
        if (why.empty() && v != as_is && plain && on->fallback == 1 &&
            lost_edges(*on, polygon) > 3 * lost_edges(*plain, named.polygon)) {
          why = "an edge got lost";
        }
      } else if (const auto cleaned = clean(polygon, {}); cleaned && !cleaned->moved) {
        why = "clean, but without a skeleton";
      }
      if (!why.empty() && ++broken[why] < 4) {
        MESSAGE(named.name << " " << std::string(variant_names[static_cast<std::size_t>(v)]) << ": "
                           << why);
      }
    }
  }
  for (const auto& [set, t] : tallies) {
    MESSAGE(set << ": " << t.all << ", closed form " << t.makers[0] << ", wavefront " << t.makers[1]
                << ", CGAL " << t.makers[2] << "; moved " << t.rungs[2] << ", simplified "
                << t.rungs[3] << ", none since rings cross or cover each other " << t.rungs[0]);
  }
  MESSAGE("slowest " << slowest << " s");
  CHECK(slowest < 2);
  for (const auto& [why, n] : broken) FAIL_CHECK(why << ": " << n);
}

}  // namespace
}  // namespace mansard
